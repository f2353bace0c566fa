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
    /**
     * Collective.
     * @param partitioner       of vectors with dim entries per node
     * @param partners_may_come contact follows the motion: nodes may have partners later
     */
    NodeCoupling(const std::vector<ContactNode<dim>>                              &nodes,
                 const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &partitioner,
                 bool partners_may_come = false);

    /**
     * False if no contact node of any process has a partner, and none will: then there is nothing
     * to do.
     */
    bool any() const { return has_partners; }

    /** Whether partners come and go: contact follows the motion. */
    bool changes() const { return partners_change; }

    /**
     * Partners may be contact nodes themselves. The level of a node is 0 if nothing of it is
     * relative, otherwise one more than the highest one of its partners: displacements become
     * Cartesian level by level. This is the number of levels above 0, on all processes; more than
     * most_levels if a node follows itself, by whatever way.
     */
    unsigned int n_levels() const { return levels; }

    static constexpr unsigned int most_levels = 64;

    /** The level of a contact node. */
    unsigned int level(const std::size_t contact_node) const { return level_of[contact_node]; }

    /** The owned nodes that are partners of contact nodes on any process, ascending. */
    std::vector<unsigned int> owned_partners() const;

    /** Per contact node k: sum_l P_kl u_l. Collective if any(). */
    std::vector<dealii::Tensor<1, dim>> partner_displacement(const Vector &u) const;

    /**
     * The values of the partners of the contact nodes, one node after the other, in their order.
     * Collective if any().
     */
    std::vector<dealii::Tensor<1, dim>> partner_values(const Vector &u) const;

    /**
     * The entries of contact nodes in their frames that are relative: by contact node, and there
     * the normal first.
     */
    const std::vector<unsigned int> &relative_entries() const { return relative; }

    /** The contact node of each relative entry. */
    const std::vector<std::size_t> &nodes_of_relative_entries() const { return relative_nodes; }

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
    bool                                has_partners, partners_change;
    unsigned int                        n_owned_entries;
    std::vector<unsigned int>           relative;
    std::vector<dealii::Tensor<1, dim>> directions;     ///< by relative entry
    std::vector<unsigned int>           relative_start; ///< by contact node
    std::vector<std::size_t>            relative_nodes; ///< by relative entry
    std::vector<unsigned int>           row_start;      ///< by contact node
    std::vector<unsigned int>           level_of;       ///< by contact node
    unsigned int                        levels = 0;
    std::vector<std::pair<unsigned int, double>>
      entries; ///< first entry of the partner (owned, then ghosts); weight
    std::shared_ptr<dealii::Utilities::MPI::Partitioner>
                                partners; ///< ghosts: partners on other processes
    mutable std::vector<double> ghost_values, import_storage;

    /** Bring the values of partners on other processes. Collective. */
    void fetch(const Vector &u) const;
    /** The dim values of a partner, after fetch(). */
    const double *values(const Vector &u, unsigned int entry) const;
    /** Collective. */
    void find_levels(const std::vector<ContactNode<dim>>                              &nodes,
                     const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &partitioner);

    /**
     * Let add(k, P_kl, target_l) add to the dim entries of every partner l of every contact node
     * k.
     */
    template <typename Add>
    void scatter(Vector &target, const Add &add) const;
  };
} // namespace signorini

#endif
