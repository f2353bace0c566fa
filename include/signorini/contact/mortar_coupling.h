// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_mortar_coupling_h
#define signorini_contact_mortar_coupling_h

#include <signorini/contact/contact_node.h>
#include <signorini/discretization/dirichlet_conditions.h>
#include <signorini/surfaces/covered_surface.h>

namespace signorini
{
  /** Where normals of a pair of bodies come from, and which nodes and parts of faces count. */
  struct MortarRules
  {
    /**
     * Per owned node 1 - |mean of the unit normals| of the slave faces around it: 0 on a flat
     * surface. If given, the normal of a contact node is that of the side that is flatter there, so
     * that an edge on a face takes the normal of the face. Null: one weight for the whole pair, by
     * the mean curvatures of both sides.
     */
    const std::vector<double> *bluntness = nullptr;
    /** Per owned node, those that carry no multiplier. Null: none. */
    const std::vector<bool> *excluded = nullptr;
  };

  /**
   * Contact of two bodies with dual Lagrange multipliers (Wohlmuth 2000; Krause and Walloth 2012,
   * section 2). For each node i of the slave surface that carries a multiplier
   *
   * @f[
   *   D_i = \int \psi_i N_i, \qquad
   *   P_{il} = \frac1{D_i} \int \psi_i N_l(\chi) \text{ over the nodes } l \text{ of the master},
   *   \qquad \sum_l P_{il} = 1,
   * @f]
   *
   * with chi the projection along the normals of the slave faces. The relative displacement
   * [u]_i = u_i - sum_l P_il u_l is a matter of single nodes, because the multipliers are
   * biorthogonal to the traces. The same combination of positions gives the gap g_i = -nu_i.[X]_i.
   * nu_i is a mean over the covered faces around i, weighted with N_i, of the normals of the slave
   * and the opposite ones of the master; the normals of the body that is bent less count more
   * (MortarRules). Only the covered part of a slave face counts.
   *
   * Slave nodes that carry no multiplier, because their normal displacement is prescribed or only a
   * sliver of their surroundings is covered, appear among the l, so that constants and linear
   * functions are still reproduced. Hanging nodes on either side are replaced by their parents
   * before anything else.
   */
  template <int dim>
  class MortarCoupling
  {
  public:
    /**
     * In the reference configuration. Collective. @param pair index of a pair of two bodies
     * @throws UserError if a prescribed direction is neither normal nor tangential to the contact
     * surface
     */
    MortarCoupling(const Discretization<dim>          &discretization,
                   const DirichletConditions<dim>     &dirichlet,
                   const std::vector<PairDescription> &pairs,
                   unsigned int                        pair);

    /** With a surface in any configuration. Collective. */
    MortarCoupling(const Discretization<dim>          &discretization,
                   const DirichletConditions<dim>     &dirichlet,
                   const std::vector<PairDescription> &pairs,
                   unsigned int                        pair,
                   const CoveredSurface<dim>          &surface,
                   const MortarRules                  &rules);

    /** The owned nodes that carry a multiplier, ascending. */
    const std::vector<ContactNode<dim>> &nodes() const { return contact_nodes; }

    /** Areas (lengths in 2d) on all processes: of the slave surface, and of its covered part. */
    double slave_area() const { return total_area; }
    double covered_area() const { return total_covered_area; }

    /** Whether any slave face sees a master face, however little of it. */
    bool faces_look_at_each_other() const { return any_segment; }

    /** Number of nodes with multiplier on all processes. */
    unsigned int n_nodes() const { return n_global; }

    /** Largest angle in degrees by which a prescribed direction turned a normal. */
    double largest_turn() const { return turn; }

    /** Number of nodes on all processes without multiplier, their normal being prescribed. */
    unsigned int n_left_to_dirichlet_conditions() const { return n_left_to_dirichlet; }

  private:
    /** Rows of P times D, ascending, by local node: owned ones, then ghosts. */
    using Rows = std::vector<NodeWeights>;

    const Discretization<dim>    &discretization;
    const unsigned int            pair;
    const std::string             pair_name;
    const MortarRules             rules;
    NormalWeights                 weights; ///< of the whole pair, without MortarRules::bluntness
    const double                  total_area, total_covered_area;
    const bool                    any_segment;
    std::vector<ContactNode<dim>> contact_nodes;
    unsigned int                  n_left_to_dirichlet = 0, n_global = 0;
    double                        turn = 0.;

    /** Owned, or ghost. */
    unsigned int local_node(dealii::types::global_dof_index node) const;
    /** Sums of integrals over the faces around each node. */
    struct NodeIntegrals
    {
      Vector covered, full;     ///< in first components
      Vector normals, opposite; ///< of slave and master
      Vector clearance;         ///< smallest distance, first components

      static dealii::Tensor<1, dim> at(const Vector &sums, unsigned int node);
    };
    NodeIntegrals collect(const std::vector<CoveredFace<dim>> &faces) const;
    /** The normal of a node, of any length; zero where faces look in opposite directions. */
    dealii::Tensor<1, dim> normal_at(unsigned int node, const NodeIntegrals &sums) const;
    /**
     * Fit the frame of a node to its prescribed directions.
     * @param complaint becomes a message if that is impossible
     * @return whether the node may carry a multiplier
     */
    bool fit_to_dirichlet(const DirichletConditions<dim> &dirichlet,
                          const dealii::Tensor<1, dim>   &normal,
                          ContactNode<dim>               &contact_node,
                          std::string                    &complaint);
    /**
     * Decide which nodes carry a multiplier, with weight and frame. @return flags per node, with
     * ghosts
     */
    Vector choose_multipliers(const std::vector<CoveredFace<dim>> &faces,
                              const DirichletConditions<dim>      &dirichlet);
    /** Dual basis face by face: partners, gaps. */
    void assemble_rows(const std::vector<CoveredFace<dim>> &faces, const Vector &carries);
    /** Take the multipliers of nodes whose rows turn out not to be usable. @return whether any */
    bool drop_what_transmits_little(Vector &carries);
    /** The part of a face in the rows of its nodes, in their integrals and distances. */
    void add_rows(const CoveredFace<dim> &face,
                  const Vector           &carries,
                  Rows                   &rows,
                  Vector                 &integrals,
                  Vector                 &distance) const;
    /** Sum the rows of all processes at the owners of the nodes. */
    void send_to_owners(Rows &rows) const;
  };
} // namespace signorini

#endif
