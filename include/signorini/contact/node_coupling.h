// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_node_coupling_h
#define signorini_contact_node_coupling_h

#include <signorini/contact/contact_node.h>

namespace signorini
{
  /**
   * The block P of the mortar coupling as an operator between the contact nodes that this process owns and their partners,
   * wherever those are. Values of partners on other processes travel in one message per neighbour.
   */
  template <int dim>
  class NodeCoupling
  {
  public:
    /** Collective. @param partitioner of vectors with dim entries per node */
    NodeCoupling(const std::vector<ContactNode<dim>>                              &nodes,
                 const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &partitioner);

    /** False if no contact node of any process has a partner: then there is nothing to do. */
    bool any() const { return has_partners; }

    /** The owned nodes that are partners of contact nodes on any process, ascending. */
    std::vector<unsigned int> owned_partners() const;

    /** Per contact node k: sum_l P_kl u_l. Collective if any(). */
    std::vector<dealii::Tensor<1, dim>> partner_displacement(const Vector &u) const;

    /** Per contact node k: nu_k . sum_l P_kl u_l. Collective if any(). */
    std::vector<double> partner_motion(const Vector &u) const;

    /** The transpose: f_l += sum_k P_kl nu_k force_k. Collective if any(). */
    void add_to_partners(const std::vector<double> &forces, Vector &f) const;

    /** The same with the squares of the coefficients, d_lc += sum_k (P_kl nu_kc)^2 values_k, for diagonals of matrices. */
    void add_squares_to_partners(const std::vector<double> &values, Vector &d) const;

  private:
    bool                                         has_partners;
    unsigned int                                 n_owned_entries;
    std::vector<dealii::Tensor<1, dim>>          normals;
    std::vector<unsigned int>                    row_start; ///< by contact node
    std::vector<std::pair<unsigned int, double>> entries;   ///< first entry of the partner (owned, then ghosts); weight
    std::shared_ptr<dealii::Utilities::MPI::Partitioner> partners; ///< ghosts: partners on other processes
    mutable std::vector<double>                          ghost_values, import_storage;

    /** target_l += sum_k power(P_kl nu_k) values_k, component by component. */
    template <typename Power>
    void scatter(const std::vector<double> &values, Vector &target, const Power &power) const;
  };
} // namespace signorini

#endif
