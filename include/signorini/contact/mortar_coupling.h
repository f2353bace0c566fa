// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_mortar_coupling_h
#define signorini_contact_mortar_coupling_h

#include <signorini/contact/contact_node.h>
#include <signorini/contact/contact_search.h>
#include <signorini/discretization/dirichlet_conditions.h>

#include <Eigen/Core>

#include <map>

namespace signorini
{
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
   * (weights_of_normals). Only the covered part of a slave face counts.
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
     * Collective. @param pair index of a pair of two bodies
     * @throws UserError if a prescribed direction is neither normal nor tangential to the contact
     * surface
     */
    MortarCoupling(const Discretization<dim>          &discretization,
                   const DirichletConditions<dim>     &dirichlet,
                   const std::vector<PairDescription> &pairs,
                   unsigned int                        pair);

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
    /** Integrals over the covered part of a slave face; one row per node that moves the face. */
    struct CoveredFace
    {
      /** Nodes and full integrals; nothing is covered yet. The face must outlive this. */
      explicit CoveredFace(const SurfaceFace<dim> &slave);

      /** N_i of all nodes at a point of the face. */
      Eigen::VectorXd values_at(const dealii::Point<dim - 1> &xi) const;

      /**
       * Add a point of a segment to the integrals. @param normal, opposite of slave and master,
       * unit vectors out of the bodies
       */
      void add(const SegmentPoint<dim>      &point,
               const SurfaceFace<dim>       &master,
               const dealii::Tensor<1, dim> &normal,
               const dealii::Tensor<1, dim> &opposite);

      const SurfaceFace<dim>                      *slave;
      std::vector<dealii::types::global_dof_index> nodes;
      Eigen::MatrixXd                              mass; ///< int N_i N_j
      std::map<dealii::types::global_dof_index, Eigen::VectorXd>
                      mixed;          ///< per master node l: int N_i N_l(chi)
      Eigen::MatrixXd normals;        ///< int N_i nu, dim columns
      Eigen::MatrixXd opposite;       ///< int N_i n(chi), dim columns
      Eigen::MatrixXd distance;       ///< int N_i (X(chi) - X), dim columns
      Eigen::VectorXd full;           ///< int N_i over the whole face
      double          clearance = 0.; ///< smallest distance to the master
    };
    using Rows =
      std::map<dealii::types::global_dof_index, std::map<dealii::types::global_dof_index, double>>;

    const Discretization<dim>    &discretization;
    const unsigned int            pair;
    const std::string             pair_name;
    std::vector<ContactNode<dim>> contact_nodes;
    double                        total_area = 0., total_covered_area = 0.;
    unsigned int                  n_left_to_dirichlet = 0, n_global = 0;
    bool                          any_segment = false;
    double                        turn        = 0.;

    std::vector<CoveredFace> integrate(const FacingSurfaces<dim> &surfaces);
    /** Sums of integrals over the faces around each node. */
    struct NodeIntegrals
    {
      Vector covered, full, normals; ///< the first two in first components
      Vector clearance;              ///< smallest distance, first components
    };
    NodeIntegrals collect(const std::vector<CoveredFace> &faces) const;
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
    Vector choose_multipliers(const std::vector<CoveredFace> &faces,
                              const DirichletConditions<dim> &dirichlet);
    /** Dual basis face by face: partners, gaps. */
    void assemble_rows(const std::vector<CoveredFace> &faces, const Vector &carries);
    /** Sum the rows of all processes at the owners of the nodes. */
    Rows send_to_owners(const Rows &rows) const;
  };
} // namespace signorini

#endif
