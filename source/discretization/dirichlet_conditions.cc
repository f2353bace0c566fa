// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/dirichlet_conditions.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  DirichletConditions<dim>::DirichletConditions(const Discretization<dim> &discretization)
  {
    const auto &bodies = discretization.mesh().bodies();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (const BoundaryCondition<dim> &condition : bodies[b].dirichlet)
        {
          const unsigned int index = functions.size();
          functions.push_back(&discretization.mesh().function(condition.expressions));
          // Flags travel as numbers: a process may own a node without owning a cell at this part of
          // the boundary.
          Vector flags = discretization.make_vector();
          for (const auto &cell : discretization.dof_handler().active_cell_iterators())
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
                      !text.empty() && text != "-" && components[c] == none)
                    components[c] = index;
              }
        }
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
