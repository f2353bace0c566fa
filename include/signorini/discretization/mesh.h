// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_mesh_h
#define signorini_discretization_mesh_h

#include <signorini/base/expressions.h>
#include <signorini/discretization/cell_matrices.h>
#include <signorini/discretization/mesh_geometry.h>
#include <signorini/model/cell_geometry.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>

namespace signorini
{
  /**
   * The bodies and their mesh; lives as long as the run. The cells may change, and what is numbered
   * on them is then built anew (Discretization); geometry and the matrices of single cells survive.
   */
  template <int dim>
  class Mesh
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

    /**
     * Collective.
     * @param changes whether the cells are going to change; then the bodies keep the geometry of
     *                their uniform refinements, see MeshGeometry
     */
    Mesh(std::vector<BodyDescription<dim>> bodies,
         MPI_Comm                          communicator,
         CellGeometry                      cells   = CellGeometry::linear,
         bool                              changes = false);

    /**
     * Refine and coarsen the cells that are flagged, and share them among the processes.
     * Collective.
     */
    void carry_out_flags();

    /** To be called when vertices were moved. Collective. */
    void update();

    /** Material ids of cells are indices of bodies. */
    const std::vector<BodyDescription<dim>> &bodies() const { return descriptions; }

    /** Whether any body has viscous damping. */
    bool is_damped() const
    {
      return std::any_of(descriptions.begin(), descriptions.end(), [](const auto &body) {
        return body.material.damping.any();
      });
    }

    Triangulation       &triangulation() { return cells; }
    const Triangulation &triangulation() const { return cells; }

    /**
     * The active cells in the order of the space-filling curve, those of other processes included.
     * What is summed or numbered in this order depends on the mesh alone; the order of the
     * triangulation depends on how the mesh came about.
     */
    const std::vector<typename Triangulation::active_cell_iterator> &active_cells() const
    {
      return ordered_cells;
    }

    const dealii::MappingQ<dim> &mapping() const { return geometry.mapping(); }
    const CellMatrices<dim>     &cell_matrices() const { return matrices_of_cells; }

    /** The function of expressions that belong to the bodies, kept from the first call on. */
    dealii::FunctionParser<dim> &function(const std::array<std::string, dim> &expressions) const
    {
      return functions.get(expressions);
    }

    /** Points per direction of the quadrature formula for cells and faces. */
    unsigned int n_quadrature_points() const { return mapping().get_degree() + 1; }

    /** Box around the coarse mesh of a body; the same on all processes. */
    const dealii::BoundingBox<dim> &bounding_box(const unsigned int body) const
    {
      return boxes[body];
    }

    const std::vector<dealii::BoundingBox<dim>> &bounding_boxes() const { return boxes; }

    /** Largest extent of any body: the unit of length for tolerances. */
    double body_size() const { return largest_extent; }

    /** Largest extent of a body. */
    double body_size(const unsigned int body) const { return extents[body]; }

    /** Of a body along a unit vector, from its first vertex to its last one. Collective. */
    double extent(unsigned int body, const dealii::Tensor<1, dim> &direction) const;

    /** Areas in 2d; cells count with straight edges. Collective. */
    std::vector<double> volumes_of_bodies() const;

    /**
     * About the lowest one of a body: the speed of pressure waves over its length, which does not
     * depend on axes.
     */
    double lowest_frequency(unsigned int body) const;
    /** Below those of all bodies: the slowest wave over the longest body. */
    double lowest_frequency() const;

    /** Courant number c_p tau / h of the smallest cell (collective), and of one cell. */
    double courant_number(double step_size) const;

    double courant_number(const typename Triangulation::active_cell_iterator &cell,
                          double                                              step_size) const;

    MPI_Comm communicator() const { return cells.get_communicator(); }

  private:
    const std::vector<BodyDescription<dim>>                   descriptions;
    Triangulation                                             cells;
    std::vector<typename Triangulation::active_cell_iterator> ordered_cells;
    MeshGeometry<dim>                                         geometry;
    CellMatrices<dim>                                         matrices_of_cells;
    std::vector<dealii::BoundingBox<dim>>                     boxes; ///< of the bodies
    double                                                    largest_extent = 0.;
    std::vector<double>                                       extents; ///< of each body
    std::vector<double>                                       lengths; ///< of each body
    mutable FunctionCache<dim>                                functions;

    void order_cells();

    /** In one pass over the coarse cells, as there may be many of them. */
    void find_bounding_boxes();
    /** Of boxes with the second moments of the bodies along their main axes. */
    void find_lengths();

    /**
     * Move hanging vertices of round bodies onto the straight edges and faces of their coarser
     * neighbours: the mesh has no gaps then, and the elements represent every linear function.
     */
    void straighten_hanging_vertices();
  };
} // namespace signorini

#endif
