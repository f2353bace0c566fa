// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/user_error.h>
#include <signorini/discretization/assemble_matrices.h>
#include <signorini/discretization/discretization.h>
#include <signorini/discretization/mesh.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::vector<unsigned int> refinements(const Scene<dim> &scene)
    {
      std::vector<unsigned int> levels;
      for (const auto &body : scene.bodies)
        levels.push_back(body.refinements);
      return levels;
    }


    /**
     * Points per direction more than the degree needs. Where curved cells are refined, the same function is integrated by other points: what this
     * changes in the energy has to be small.
     */
    template <int dim>
    unsigned int extra_points(const MeshGeometry<dim> &geometry)
    {
      return geometry.has_base() && geometry.mapping().get_degree() > 1 ? 2 : 0;
    }
  } // namespace


  template <int dim>
  Discretization<dim>::Discretization(const Scene<dim> &scene, const MPI_Comm communicator, const bool mesh_changes)
    : scene(scene)
    , triangulation(communicator)
    , fe(FE_Q<dim>(1), dim)
    , geometry(scene.mapping == "curved" ? 2 : 1, mesh_changes ? refinements(scene) : std::vector<unsigned int>())
    , mapping(geometry.mapping())
    , dof_handler(triangulation)
    , cell_matrices(scene, mapping, n_quadrature_points() + extra_points<dim>(geometry))
    , mesh_life_time(scene.time.n_steps())
  {
    make_mesh(scene, triangulation);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      for (unsigned int c = 0; c < dim; ++c)
        largest_extent = std::max(largest_extent, bounding_box(b).side_length(c));
    distribute();
  }


  template <int dim>
  void Discretization<dim>::distribute()
  {
    dof_handler.distribute_dofs(fe);
    locally_owned = dof_handler.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dof_handler, locally_relevant);
    hanging_node_constraints.clear();
    hanging_node_constraints.reinit(locally_relevant);
    DoFTools::make_hanging_node_constraints(dof_handler, hanging_node_constraints);
    hanging_node_constraints.close();
    if (mapping.get_degree() == 1 && !geometry.has_base())
      straighten_hanging_vertices();
    geometry.update(triangulation);
  }


  template <int dim>
  void Discretization<dim>::straighten_hanging_vertices()
  {
    // The position is an isoparametric displacement: it has to obey the same constraints.
    Vector positions(locally_owned, locally_relevant, communicator());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (locally_owned.is_element(cell->vertex_dof_index(v, 0)))
            for (unsigned int c = 0; c < dim; ++c)
              positions(cell->vertex_dof_index(v, c)) = cell->vertex(v)[c];
    hanging_node_constraints.distribute(positions);
    positions.update_ghost_values();
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          if (hanging_node_constraints.is_constrained(cell->vertex_dof_index(v, 0)))
            for (unsigned int c = 0; c < dim; ++c)
              cell->vertex(v)[c] = positions(cell->vertex_dof_index(v, c));
  }


  template <int dim>
  void Discretization<dim>::assemble(const MassChange &change)
  {
    cell_matrices.forget_unused();
    assemble_matrices(*this, matrices, change);
    if (scene.time.mass == "lumped")
      matrices.lump_mass();

    // Positions travel to the ghosts as a vector does.
    Vector positions = make_vector();
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (locally_owned.is_element(cell->vertex_dof_index(v, 0)))
            for (unsigned int c = 0; c < dim; ++c)
              positions(cell->vertex_dof_index(v, c)) = cell->vertex(v)[c];
    positions.update_ghost_values();
    node_positions.resize(matrices.pattern.n_local);
    for (unsigned int node = 0; node < matrices.pattern.n_local; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        node_positions[node][c] = positions.local_element(dim * node + c);
  }


  template <int dim>
  Vector Discretization<dim>::interpolate(const std::vector<std::array<std::string, dim>> &expressions_by_body,
                                          const double                                     time) const
  {
    std::vector<FunctionParser<dim> *> functions;
    for (const auto &expressions : expressions_by_body)
      {
        auto &function = parsed[expressions];
        if (!function)
          function = make_function<dim, dim>(expressions);
        function->set_time(time);
        functions.push_back(function.get());
      }
    Vector                 result = make_vector();
    dealii::Vector<double> value(dim);
    std::vector<char>      done(matrices.pattern.n_owned);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof = cell->vertex_dof_index(v, 0);
            if (!locally_owned.is_element(dof) || hanging_node_constraints.is_constrained(dof))
              continue;
            const unsigned int node = result.get_partitioner()->global_to_local(dof) / dim;
            if (done[node])
              continue;
            done[node] = 1;
            functions[cell->material_id()]->vector_value(cell->vertex(v), value);
            for (unsigned int c = 0; c < dim; ++c)
              {
                if (!std::isfinite(value[c]))
                  {
                    std::ostringstream message;
                    message << scene.file_name << ": Bodies/" << scene.bodies[cell->material_id()].name
                            << ": the expression '" << expressions_by_body[cell->material_id()][c]
                            << "' is not a finite number at (" << cell->vertex(v) << "), t = " << time
                            << ". Change it so that it can be evaluated everywhere in the body.";
                    throw UserError(message.str());
                  }
                result(dof + c) = value[c];
              }
          }
    return result;
  }


  template <int dim>
  Vector Discretization<dim>::interpolate_hanging_nodes(const Vector &vector) const
  {
    Vector result(locally_owned, locally_relevant, communicator());
    result.copy_locally_owned_data_from(vector);
    hanging_node_constraints.distribute(result);
    result.update_ghost_values();
    return result;
  }


  template <int dim>
  BoundingBox<dim> Discretization<dim>::bounding_box(const unsigned int body) const
  {
    std::vector<Point<dim>> points;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      if (cell->material_id() == body)
        for (const unsigned int v : cell->vertex_indices())
          points.push_back(cell->vertex(v));
    return BoundingBox<dim>(points);
  }


  template <int dim>
  double Discretization<dim>::courant_number(const double step_size) const
  {
    double number = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        number = std::max(number,
                          scene.bodies[cell->material_id()].material.pressure_wave_speed() * step_size
                            / cell->minimum_vertex_distance());
    return Utilities::MPI::max(number, communicator());
  }


  template class Discretization<2>;
  template class Discretization<3>;
} // namespace signorini
