// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/make_triangulation.h>
#include <signorini/discretization/mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Eigenvalues>

#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::vector<unsigned int> refinements(const std::vector<BodyDescription<dim>> &bodies)
    {
      std::vector<unsigned int> levels;
      for (const auto &body : bodies)
        levels.push_back(body.refinements);
      return levels;
    }


    /**
     * Points per direction more than the degree needs. Where cells that are no parallelepipeds are
     * refined, the same function is integrated by other points: what this changes in the energy has
     * to be small.
     */
    template <int dim>
    unsigned int extra_points(const MeshGeometry<dim>                 &geometry,
                              const std::vector<BodyDescription<dim>> &bodies)
    {
      const bool parallel = std::all_of(bodies.begin(), bodies.end(), [](const auto &body) {
        return body.shape->has_only_parallelepipeds();
      });
      return geometry.has_base() && !parallel ? 2 : 0;
    }


    /** Append the active descendants of a cell: children follow each other along the curve. */
    template <int dim, typename ActiveCell>
    void append_active(const typename Triangulation<dim>::cell_iterator &cell,
                       std::vector<ActiveCell>                          &result)
    {
      if (cell->is_active())
        result.emplace_back(cell);
      else
        for (unsigned int child = 0; child < cell->n_children(); ++child)
          append_active<dim>(cell->child(child), result);
    }
  } // namespace


  template <int dim>
  Mesh<dim>::Mesh(std::vector<BodyDescription<dim>> bodies,
                  const MPI_Comm                    communicator,
                  const CellGeometry                cell_geometry,
                  const bool                        changes)
    : descriptions(std::move(bodies))
    , cells(communicator)
    , geometry(cell_geometry == CellGeometry::curved ? 2 : 1,
               changes ? refinements(descriptions) : std::vector<unsigned int>())
    , matrices_of_cells(descriptions,
                        mapping(),
                        n_quadrature_points() + extra_points<dim>(geometry, descriptions))
  {
    make_triangulation(descriptions, cells);
    find_bounding_boxes();
    extents.assign(descriptions.size(), 0.);
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      for (unsigned int c = 0; c < dim; ++c)
        extents[b] = std::max(extents[b], bounding_box(b).side_length(c));
    largest_extent = *std::max_element(extents.begin(), extents.end());
    find_lengths();
    update();
  }


  template <int dim>
  void Mesh<dim>::carry_out_flags()
  {
    cells.execute_coarsening_and_refinement();
    update();
  }


  template <int dim>
  void Mesh<dim>::order_cells()
  {
    ordered_cells.clear();
    ordered_cells.reserve(cells.n_active_cells());
    for (const auto coarse : cells.get_p4est_tree_to_coarse_cell_permutation())
      append_active<dim>(typename dealii::Triangulation<dim>::cell_iterator(&cells, 0, coarse),
                         ordered_cells);
  }


  template <int dim>
  void Mesh<dim>::update()
  {
    order_cells();
    find_bounding_boxes();
    if (mapping().get_degree() == 1 && !geometry.has_base() && cells.has_hanging_nodes())
      straighten_hanging_vertices();
    geometry.update(cells);
    matrices_of_cells.forget_unused();
  }


  template <int dim>
  void Mesh<dim>::straighten_hanging_vertices()
  {
    // The position is an isoparametric displacement: it has to obey the same constraints.
    DoFHandler<dim> dofs(cells);
    dofs.distribute_dofs(FESystem<dim>(FE_Q<dim>(1), dim));
    const IndexSet &owned = dofs.locally_owned_dofs();
    IndexSet        relevant;
    DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    AffineConstraints<double> constraints(relevant);
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    constraints.close();

    Vector positions(owned, relevant, communicator());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (owned.is_element(cell->vertex_dof_index(v, 0)))
            for (unsigned int c = 0; c < dim; ++c)
              positions(cell->vertex_dof_index(v, c)) = cell->vertex(v)[c];
    constraints.distribute(positions);
    positions.update_ghost_values();
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          if (constraints.is_constrained(cell->vertex_dof_index(v, 0)))
            for (unsigned int c = 0; c < dim; ++c)
              cell->vertex(v)[c] = positions(cell->vertex_dof_index(v, c));
  }


  template <int dim>
  void Mesh<dim>::find_bounding_boxes()
  {
    Point<dim> lowest, highest;
    for (unsigned int c = 0; c < dim; ++c)
      {
        lowest[c]  = std::numeric_limits<double>::lowest();
        highest[c] = std::numeric_limits<double>::max();
      }
    std::vector<std::pair<Point<dim>, Point<dim>>> corners(descriptions.size(), {highest, lowest});
    for (const auto &cell : cells.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int c = 0; c < dim; ++c)
          {
            auto &[lower, upper] = corners[cell->material_id()];
            lower[c]             = std::min(lower[c], cell->vertex(v)[c]);
            upper[c]             = std::max(upper[c], cell->vertex(v)[c]);
          }
    boxes.assign(corners.begin(), corners.end());
  }


  template <int dim>
  double Mesh<dim>::extent(const unsigned int body, const Tensor<1, dim> &direction) const
  {
    double first = std::numeric_limits<double>::max(), last = -first;
    for (const auto &cell : ordered_cells)
      if (cell->is_locally_owned() && cell->material_id() == body)
        for (const unsigned int v : cell->vertex_indices())
          {
            const double place = direction * cell->vertex(v);
            first              = std::min(first, place);
            last               = std::max(last, place);
          }
    return Utilities::MPI::max(last, communicator()) - Utilities::MPI::min(first, communicator());
  }


  template <int dim>
  std::vector<double> Mesh<dim>::volumes_of_bodies() const
  {
    std::vector<double> volumes(bodies().size(), 0.);
    for (const auto &cell : ordered_cells)
      if (cell->is_locally_owned())
        volumes[cell->material_id()] += cell->measure();
    Utilities::MPI::sum(volumes, communicator(), volumes);
    return volumes;
  }


  template <int dim>
  void Mesh<dim>::find_lengths()
  {
    using SmallVector = Eigen::Matrix<double, dim, 1>;
    using SmallMatrix = Eigen::Matrix<double, dim, dim>;
    std::vector<double>      volumes(descriptions.size(), 0.);
    std::vector<SmallVector> first(descriptions.size(), SmallVector::Zero());
    std::vector<SmallMatrix> second(descriptions.size(), SmallMatrix::Zero());
    for (const auto &cell : cells.cell_iterators_on_level(0))
      {
        const unsigned int body   = cell->material_id();
        const double       volume = cell->measure();
        // From the middle of the box, or round-off would be that of its distance.
        const auto place = [&](const Point<dim> &point) {
          SmallVector result;
          for (unsigned int c = 0; c < dim; ++c)
            result[c] = point[c] - bounding_box(body).center()[c];
          return result;
        };
        const SmallVector middle = place(cell->center());
        volumes[body] += volume;
        first[body] += volume * middle;
        // Exact for parallelepipeds.
        second[body] += 2. / 3. * volume * middle * middle.transpose();
        for (const unsigned int v : cell->vertex_indices())
          second[body] += volume / (3. * cell->n_vertices()) * place(cell->vertex(v))
                          * place(cell->vertex(v)).transpose();
      }
    for (unsigned int body = 0; body < descriptions.size(); ++body)
      {
        const SmallVector middle = first[body] / volumes[body];
        const SmallMatrix about  = second[body] / volumes[body] - middle * middle.transpose();
        const Eigen::SelfAdjointEigenSolver<SmallMatrix> eigen(about, Eigen::EigenvaluesOnly);
        lengths.push_back(std::sqrt(12. * eigen.eigenvalues()[dim - 1]));
      }
  }


  template <int dim>
  double Mesh<dim>::lowest_frequency(const unsigned int body) const
  {
    return bodies()[body].material.pressure_wave_speed() / lengths[body];
  }


  template <int dim>
  double Mesh<dim>::lowest_frequency() const
  {
    double slowest = std::numeric_limits<double>::max();
    for (const auto &body : bodies())
      slowest = std::min(slowest, body.material.pressure_wave_speed());
    return slowest / *std::max_element(lengths.begin(), lengths.end());
  }


  template <int dim>
  double Mesh<dim>::courant_number(const typename Triangulation::active_cell_iterator &cell,
                                   const double step_size) const
  {
    return descriptions[cell->material_id()].material.pressure_wave_speed() * step_size
           / cell->minimum_vertex_distance();
  }


  template <int dim>
  double Mesh<dim>::courant_number(const double step_size) const
  {
    double number = 0.;
    for (const auto &cell : ordered_cells)
      if (cell->is_locally_owned())
        number = std::max(number, courant_number(cell, step_size));
    return Utilities::MPI::max(number, communicator());
  }


  template class Mesh<2>;
  template class Mesh<3>;
} // namespace signorini
