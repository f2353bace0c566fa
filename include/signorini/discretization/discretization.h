// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_discretization_h
#define signorini_discretization_discretization_h

#include <signorini/discretization/mass_change.h>
#include <signorini/discretization/mesh.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/affine_constraints.h>

namespace signorini
{
  /**
   * Q1 displacements, hanging nodes and matrices of all bodies on one state of the mesh: build
   * another one when the cells have changed.
   *
   * A node is a vertex with dim consecutive degrees of freedom. Vectors live on the nodes of
   * `matrices().pattern`: owned ones first, then ghosts. Hanging nodes are eliminated: their
   * entries in vectors are zero but for interpolate_hanging_nodes().
   */
  template <int dim>
  class Discretization
  {
  public:
    /**
     * Numbers the degrees of freedom and assembles mass and stiffness. The mesh must outlive the
     * object. Collective.
     */
    explicit Discretization(const Mesh<dim> &mesh);

    /**
     * Assemble anew with changes of the mass of the time discretisation, see assemble_matrices().
     * New couplings enter the pattern: vectors made before are of no use then. Collective.
     */
    void change_mass(const MassChange &change);

    const Mesh<dim>               &mesh() const { return all_cells; }
    const dealii::FESystem<dim>   &fe() const { return element; }
    const dealii::DoFHandler<dim> &dof_handler() const { return numbering; }
    /** Mesh::active_cells() with their degrees of freedom, which are numbered in this order. */
    const std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator> &cells() const
    {
      return numbered_cells;
    }
    const dealii::AffineConstraints<double> &hanging_node_constraints() const
    {
      return hanging_nodes;
    }
    const dealii::IndexSet &locally_owned() const { return numbering.locally_owned_dofs(); }
    const dealii::IndexSet &locally_relevant() const { return relevant; }

    const ElasticMatrices<dim> &matrices() const { return elastic_matrices; }
    /** For those who give the time discretisation another mass of the same couplings. */
    ElasticMatrices<dim> &matrices() { return elastic_matrices; }

    /** Positions of the local nodes of the pattern, ghosts included. */
    const std::vector<dealii::Point<dim>> &node_positions() const { return positions; }

    /** The body of each owned node; an invalid number for hanging ones. */
    std::vector<unsigned int> bodies_of_nodes() const;

    /** A vector of zeros. */
    Vector make_vector() const { return Vector(elastic_matrices.pattern.partitioner); }

    /** Nodal interpolation of expressions given per body (empty: zero), hanging nodes left zero. */
    Vector interpolate(const std::vector<std::array<std::string, dim>> &expressions_by_body,
                       double                                           time = 0.) const;

    /** Copy with ghosts for output: hanging nodes filled by interpolation. */
    Vector interpolate_hanging_nodes(const Vector &vector) const;

    MPI_Comm communicator() const { return all_cells.communicator(); }

  private:
    const Mesh<dim>                                                    &all_cells;
    const dealii::FESystem<dim>                                         element;
    dealii::DoFHandler<dim>                                             numbering;
    std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator> numbered_cells;
    dealii::AffineConstraints<double>                                   hanging_nodes;
    dealii::IndexSet                                                    relevant;
    ElasticMatrices<dim>                                                elastic_matrices;
    std::vector<dealii::Point<dim>>                                     positions;

    void assemble(const MassChange &change);
    /** Give each local node the damping of its body. Collective. */
    void assign_damping();
  };
} // namespace signorini

#endif
