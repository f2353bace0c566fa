// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_discretization_h
#define signorini_discretization_discretization_h

#include <signorini/discretization/cell_matrices.h>
#include <signorini/discretization/mass_change.h>
#include <signorini/discretization/mesh_geometry.h>
#include <signorini/scene/scene.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function_parser.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/affine_constraints.h>

#include <map>

namespace signorini
{
  /**
   * Mesh, Q1 displacements, hanging nodes and matrices of all bodies of a scene.
   *
   * A node is a vertex with dim consecutive degrees of freedom. Vectors live on the nodes of `matrices.pattern`: owned ones
   * first, then ghosts. Hanging nodes are eliminated: their entries in vectors are zero but for interpolate_hanging_nodes().
   */
  template <int dim>
  class Discretization
  {
  public:
    /**
     * Builds the mesh and numbers the degrees of freedom; no matrices yet.
     * @param mesh_changes whether the mesh is going to change; then the bodies keep the geometry of their uniform refinements, see MeshGeometry
     */
    Discretization(const Scene<dim> &scene, MPI_Comm communicator, bool mesh_changes = false);

    /**
     * Number the degrees of freedom of the mesh as it is, after the triangulation has changed. All vectors, and everything that was built
     * from this object, are of no use then; matrices have to be assembled anew. Collective.
     */
    void distribute();

    /**
     * Assemble mass and stiffness; needed before vectors can be made.
     * @param change added to the mass of the time discretisation, see assemble_matrices(). Vectors made before are of no use then.
     */
    void assemble(const MassChange &change = {});

    const Scene<dim>                                 &scene;
    dealii::parallel::distributed::Triangulation<dim> triangulation;
    dealii::FESystem<dim>                             fe;
    MeshGeometry<dim>                                 geometry;
    const dealii::MappingQ<dim>                      &mapping; ///< of the geometry
    dealii::DoFHandler<dim>                           dof_handler;
    dealii::AffineConstraints<double>                 hanging_node_constraints;
    dealii::IndexSet                                  locally_owned, locally_relevant;
    ElasticMatrices<dim>                              matrices;
    CellMatrices<dim>                                 cell_matrices; ///< of single cells; survive a change of the mesh
    /** Positions of the local nodes of the pattern, ghosts included. */
    std::vector<dealii::Point<dim>> node_positions;

    /** Number of steps that will probably be made on this mesh: what it pays to build depends on it. */
    unsigned int mesh_life_time; ///< all of them unless the mesh changes

    /** Points per direction of the quadrature formula for cells and faces. */
    unsigned int n_quadrature_points() const { return mapping.get_degree() + 1; }

    /** A vector of zeros. */
    Vector make_vector() const { return Vector(matrices.pattern.partitioner); }

    /** Nodal interpolation of expressions given per body (empty: zero), hanging nodes left zero. */
    Vector interpolate(const std::vector<std::array<std::string, dim>> &expressions_by_body, double time = 0.) const;

    /** Copy with ghosts for output: hanging nodes filled by interpolation. */
    Vector interpolate_hanging_nodes(const Vector &vector) const;

    /** Box around the coarse mesh of a body; the same on all processes. */
    dealii::BoundingBox<dim> bounding_box(unsigned int body) const;

    /** Largest extent of a body: the unit of length for tolerances. */
    double body_size() const { return largest_extent; }

    /** Courant number c_p tau / h of the smallest cell. */
    double courant_number(double step_size) const;

    MPI_Comm communicator() const { return triangulation.get_communicator(); }

  private:
    double largest_extent = 0.;

    /** Functions that were interpolated; to parse an expression takes as long as a step in 2d. */
    mutable std::map<std::array<std::string, dim>, std::unique_ptr<dealii::FunctionParser<dim>>> parsed;

    /**
     * Move hanging vertices of round bodies onto the straight edges and faces of their coarser neighbours: the mesh has no gaps
     * then, and the elements represent every linear function.
     */
    void straighten_hanging_vertices();
  };
} // namespace signorini

#endif
