// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_node_coupling_h
#define signorini_contact_node_coupling_h

#include <signorini/contact/contact_node.h>

namespace signorini
{
  /**
   * The block P of the mortar coupling as an operator between the contact nodes that this process
   * owns and their partners, wherever those are. A relative entry r belongs to a contact node k and
   * a direction e_r of its frame (ContactNode::relative). Values of partners on other processes
   * travel in one message per neighbour.
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

    /**
     * The entries of contact nodes in their frames that are relative: by contact node, and there
     * the normal first.
     */
    const std::vector<unsigned int> &relative_entries() const { return relative; }

    /** Per relative entry r of a contact node k: e_r . sum_l P_kl u_l. Collective if any(). */
    std::vector<double> partner_motion(const Vector &u) const;

    /** The transpose: f_l += sum_k P_kl sum_r e_r forces_r. Collective if any(). */
    void add_to_partners(const std::vector<double> &forces, Vector &f) const;

    /**
     * For diagonals of matrices: d_lc += sum_k P_kl^2 (Pi_k B_k Pi_k)_cc with Pi_k = sum_r e_r
     * e_r'. Collective if any().
     * @param blocks B_k per contact node, in its frame
     */
    void add_blocks_to_partners(const std::vector<std::array<double, dim * dim>> &blocks,
                                Vector                                           &d) const;

  private:
    bool                                has_partners;
    unsigned int                        n_owned_entries;
    std::vector<unsigned int>           relative;
    std::vector<dealii::Tensor<1, dim>> directions;     ///< by relative entry
    std::vector<unsigned int>           relative_start; ///< by contact node
    std::vector<unsigned int>           row_start;      ///< by contact node
    std::vector<std::pair<unsigned int, double>>
      entries; ///< first entry of the partner (owned, then ghosts); weight
    std::shared_ptr<dealii::Utilities::MPI::Partitioner>
                                partners; ///< ghosts: partners on other processes
    mutable std::vector<double> ghost_values, import_storage;

    /**
     * Let add(k, P_kl, target_l) add to the dim entries of every partner l of every contact node
     * k.
     */
    template <typename Add>
    void scatter(Vector &target, const Add &add) const;
  };
} // namespace signorini

#endif
