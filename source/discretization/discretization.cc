// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/discretization/assemble_matrices.h>
#include <signorini/discretization/discretization.h>

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_value = 1e100; ///< squares and products must not overflow

    template <int dim>
    [[noreturn]] void refuse(const std::string &body,
                             const std::string &expression,
                             const Point<dim>  &place,
                             const double       time)
    {
      std::ostringstream message;
      message << "Bodies/" << body << ": the expression '" << expression
              << "' is not a finite number (up to " << largest_value << ") at (" << place
              << "), t = " << time
              << ". Change it so that it can be evaluated everywhere in the body.";
      throw UserError(message.str());
    }
  } // namespace


  template <int dim>
  Discretization<dim>::Discretization(const Mesh<dim> &mesh)
    : all_cells(mesh)
    , element(FE_Q<dim>(1), dim)
    , numbering(mesh.triangulation())
  {
    numbering.distribute_dofs(element);
    DoFRenumbering::hierarchical(numbering);
    numbered_cells.reserve(mesh.active_cells().size());
    for (const auto &cell : mesh.active_cells())
      numbered_cells.emplace_back(&mesh.triangulation(), cell->level(), cell->index(), &numbering);
    DoFTools::extract_locally_relevant_dofs(numbering, relevant);
    hanging_nodes.reinit(relevant);
    DoFTools::make_hanging_node_constraints(numbering, hanging_nodes);
    hanging_nodes.close();
    assemble({});
  }


  template <int dim>
  void Discretization<dim>::change_mass(const MassChange &change)
  {
    assemble(change);
  }


  template <int dim>
  void Discretization<dim>::assemble(const MassChange &change)
  {
    assemble_matrices(*this, elastic_matrices, change);
    if (all_cells.is_damped())
      assign_damping();

    // Positions travel to the ghosts as a vector does.
    Vector places = make_vector();
    for (const auto &cell : cells())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (locally_owned().is_element(cell->vertex_dof_index(v, 0)))
            for (unsigned int c = 0; c < dim; ++c)
              places(cell->vertex_dof_index(v, c)) = cell->vertex(v)[c];
    places.update_ghost_values();
    positions.resize(elastic_matrices.pattern.n_local);
    for (unsigned int node = 0; node < elastic_matrices.pattern.n_local; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        positions[node][c] = places.local_element(dim * node + c);
  }


  template <int dim>
  std::vector<unsigned int> Discretization<dim>::bodies_of_nodes() const
  {
    const auto               &partitioner = *elastic_matrices.pattern.partitioner;
    std::vector<unsigned int> result(elastic_matrices.pattern.n_owned,
                                     numbers::invalid_unsigned_int);
    for (const auto &cell : cells())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (const auto dof = cell->vertex_dof_index(v, 0);
              partitioner.in_local_range(dof) && !hanging_nodes.is_constrained(dof))
            result[partitioner.global_to_local(dof) / dim] = cell->material_id();
    return result;
  }


  template <int dim>
  void Discretization<dim>::assign_damping()
  {
    Vector                          bodies(elastic_matrices.pattern.partitioner);
    const std::vector<unsigned int> of_owned_nodes = bodies_of_nodes();
    for (unsigned int node = 0; node < of_owned_nodes.size(); ++node)
      if (of_owned_nodes[node] != numbers::invalid_unsigned_int)
        bodies.local_element(dim * node) = of_owned_nodes[node];
    bodies.update_ghost_values();
    elastic_matrices.damping.resize(elastic_matrices.pattern.n_local);
    for (unsigned int node = 0; node < elastic_matrices.pattern.n_local; ++node)
      elastic_matrices.damping[node] =
        all_cells.bodies()[static_cast<unsigned int>(bodies.local_element(dim * node))]
          .material.damping;
  }


  template <int dim>
  Vector Discretization<dim>::interpolate(
    const std::vector<std::array<std::string, dim>> &expressions_by_body,
    const double                                     time) const
  {
    std::vector<FunctionParser<dim> *> functions;
    for (const auto &expressions : expressions_by_body)
      {
        functions.push_back(&all_cells.function(expressions));
        functions.back()->set_time(time);
      }
    Vector                 result = make_vector();
    dealii::Vector<double> value(dim);
    std::vector<char>      done(elastic_matrices.pattern.n_owned);
    for (const auto &cell : cells())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof = cell->vertex_dof_index(v, 0);
            if (!locally_owned().is_element(dof) || hanging_nodes.is_constrained(dof))
              continue;
            const unsigned int node = result.get_partitioner()->global_to_local(dof) / dim;
            if (done[node])
              continue;
            done[node]              = 1;
            const unsigned int body = cell->material_id();
            functions[body]->vector_value(cell->vertex(v), value);
            for (unsigned int c = 0; c < dim; ++c)
              {
                if (!(std::abs(value[c]) <= largest_value))
                  refuse(all_cells.bodies()[body].name,
                         expressions_by_body[body][c],
                         cell->vertex(v),
                         time);
                result(dof + c) = value[c];
              }
          }
    return result;
  }


  template <int dim>
  Vector Discretization<dim>::interpolate_hanging_nodes(const Vector &vector) const
  {
    Vector result(locally_owned(), relevant, communicator());
    result.copy_locally_owned_data_from(vector);
    hanging_nodes.distribute(result);
    result.update_ghost_values();
    return result;
  }


  template class Discretization<2>;
  template class Discretization<3>;
} // namespace signorini
