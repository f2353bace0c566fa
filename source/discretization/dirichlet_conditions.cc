// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/base/expressions.h>
#include <signorini/discretization/dirichlet_conditions.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  DirichletConditions<dim>::DirichletConditions(const Discretization<dim> &discretization)
    : mesh(discretization.mesh())
  {
    const auto &bodies = discretization.mesh().bodies();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (const BoundaryCondition<dim> &condition : bodies[b].dirichlet)
        {
          const unsigned int index = functions.size();
          functions.push_back(&discretization.mesh().function(condition.expressions));
          places.emplace_back(b, condition.boundary_id);
          depends_on_time.emplace_back();
          for (unsigned int c = 0; c < dim; ++c)
            depends_on_time.back()[c] =
              has_time(std::array<std::string, 1>{{condition.expressions[c]}});
          // Flags travel as numbers: a process may own a node without owning a cell at this part of
          // the boundary.
          Vector flags = discretization.make_vector();
          for (const auto &cell : discretization.cells())
            if (cell->is_locally_owned() && cell->material_id() == b)
              for (const unsigned int f : cell->face_indices())
                if (cell->face(f)->at_boundary()
                    && cell->face(f)->boundary_id() == condition.boundary_id)
                  for (const unsigned int v : cell->face(f)->vertex_indices())
                    if (const auto dof = cell->face(f)->vertex_dof_index(v, 0);
                        !discretization.hanging_node_constraints().is_constrained(dof))
                      flags(dof) = 1.;
          flags.compress(VectorOperation::add);
          for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
            if (flags.local_element(dim * node) > 0.)
              {
                Components none_yet;
                none_yet.fill(none);
                Components &components = prescribed.emplace(node, none_yet).first->second;
                for (unsigned int c = 0; c < dim; ++c)
                  if (const std::string &text = condition.expressions[c];
                      !text.empty() && text != "-")
                    {
                      if (components[c] == none)
                        components[c] = index;
                      else
                        shared.push_back(
                          {discretization.node_positions()[node], c, components[c], index});
                    }
              }
        }
  }


  template <int dim>
  std::string DirichletConditions<dim>::name(const unsigned int condition) const
  {
    return "Bodies/" + mesh.bodies()[places[condition].first].name + "/Dirichlet on the boundary "
           + std::to_string(places[condition].second);
  }


  template <int dim>
  std::vector<std::string> DirichletConditions<dim>::check_shared_nodes(const double end_time) const
  {
    const auto boundaries = [&](const Shared &node) {
      return "Bodies/" + mesh.bodies()[places[node.first].first].name
             + "/Dirichlet: the boundaries " + std::to_string(places[node.first].second) + " and "
             + std::to_string(places[node.second].second);
    };
    std::vector<Complaint> complaints;
    std::set<std::string>  notes;
    for (const Shared &node : shared)
      {
        // Any times will do that are not the same part of a period.
        for (const double part : {0., 0.0173, 0.131, 0.317, 0.523, 0.779, 1.})
          {
            const double time   = part * end_time;
            const double first  = value(node.first, node.point, node.component, time),
                         second = value(node.second, node.point, node.component, time);
            const double size   = std::max({std::abs(first), std::abs(second), mesh.body_size()});
            if (std::abs(first - second) <= 1e-12 * size)
              continue;
            std::ostringstream message;
            message << boundaries(node) << " share the point (" << node.point
                    << "), and prescribe different displacements there in "
                    << "xyz"[node.component] << ", " << first << " and " << second
                    << " at the time " << time
                    << ". Let them agree, or leave this component free (-) on one of them.";
            complaints.emplace_back(std::abs(first - second), message.str());
            break;
          }
        notes.insert(boundaries(node) + " share nodes and agree there");
      }
    throw_worst(complaints, mesh.communicator());
    std::set<std::string> all;
    for (const auto &of_process : Utilities::MPI::all_gather(
           mesh.communicator(), std::vector<std::string>(notes.begin(), notes.end())))
      all.insert(of_process.begin(), of_process.end());
    return {all.begin(), all.end()};
  }


  template <int dim>
  double DirichletConditions<dim>::value(const unsigned int condition,
                                         const Point<dim>  &point,
                                         const unsigned int component,
                                         const double       time) const
  {
    functions[condition]->set_time(time);
    return functions[condition]->value(point, component);
  }


  template class DirichletConditions<2>;
  template class DirichletConditions<3>;
} // namespace signorini
