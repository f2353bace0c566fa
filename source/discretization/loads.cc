// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/base/expressions.h>
#include <signorini/discretization/loads.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    bool is_number(const double value)
    {
      return std::isfinite(value);
    }
  } // namespace


  const Vector &VectorInTime::at(const double                   time,
                                 const bool                     depends_on_time,
                                 const std::function<Vector()> &evaluate)
  {
    for (const auto &[kept_time, vector] : kept)
      if (vector.size() > 0 && (kept_time == time || !depends_on_time))
        return vector;
    latest       = 1 - latest;
    kept[latest] = {time, evaluate()};
    return kept[latest].second;
  }


  template <int dim>
  BodyForce<dim>::BodyForce(const Discretization<dim> &discretization)
    : discretization(discretization)
  {
    for (const auto &body : discretization.mesh().bodies())
      {
        expressions.push_back(body.body_force);
        is_given = is_given || signorini::is_given(body.body_force);
        has_time = has_time || signorini::has_time(body.body_force);
      }
  }


  template <int dim>
  const Vector &BodyForce<dim>::at(const double time)
  {
    return values.at(time, has_time, [&] {
      return is_given ? discretization.interpolate(expressions, time)
                      : discretization.make_vector();
    });
  }


  template <int dim>
  Loads<dim>::Loads(const Discretization<dim> &discretization)
    : discretization(discretization)
    , body_force(discretization)
    , has_loads(body_force.any())
    , depends_on_time(body_force.depends_on_time())
  {
    for (const auto &body : discretization.mesh().bodies())
      for (const auto &condition : body.traction)
        {
          has_loads       = has_loads || is_given(condition.expressions);
          depends_on_time = depends_on_time || has_time(condition.expressions);
        }
  }


  template <int dim>
  const Vector &Loads<dim>::at(const double time)
  {
    return values.at(time, depends_on_time, [&] { return assemble(time); });
  }


  template <int dim>
  Vector Loads<dim>::assemble(const double time)
  {
    // Body forces by nodal interpolation and the consistent mass: exact for constants, second order
    // otherwise.
    Vector                   result = discretization.make_vector();
    std::vector<std::string> not_numbers; ///< what is not a finite number now
    if (body_force.any())                 // what is no number there is refused by the interpolation
      discretization.matrices().apply_mass(result, body_force.at(time));
    const auto &bodies = discretization.mesh().bodies();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (const auto &condition : bodies[b].traction)
        if (!add_traction(b, condition, time, result))
          not_numbers.push_back("Bodies/" + bodies[b].name + "/Traction on the boundary "
                                + std::to_string(condition.boundary_id));
    result.compress(VectorOperation::add);
    throw_if_any_is_no_number(not_numbers, time, discretization.communicator());
    return result;
  }


  template <int dim>
  bool Loads<dim>::add_traction(const unsigned int            body,
                                const BoundaryCondition<dim> &condition,
                                const double                  time,
                                Vector                       &forces) const
  {
    const Mesh<dim>                     &mesh = discretization.mesh();
    const FE_Q<dim>                      scalar_fe(1);
    FEFaceValues<dim>                    fe_values(mesh.mapping(),
                                scalar_fe,
                                QGauss<dim - 1>(mesh.n_quadrature_points()),
                                update_values | update_quadrature_points | update_JxW_values);
    std::vector<types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
    dealii::Vector<double>               local(dofs.size()), traction(dim);
    auto                                &function = mesh.function(condition.expressions);
    function.set_time(time);
    bool all_are_numbers = true;
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned() && cell->material_id() == body)
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id)
            {
              fe_values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(cell), f);
              local = 0.;
              for (const unsigned int q : fe_values.quadrature_point_indices())
                {
                  function.vector_value(fe_values.quadrature_point(q), traction);
                  all_are_numbers =
                    all_are_numbers && std::all_of(traction.begin(), traction.end(), is_number);
                  for (unsigned int v = 0; v < scalar_fe.n_dofs_per_cell(); ++v)
                    for (unsigned int c = 0; c < dim; ++c)
                      local[dim * v + c] +=
                        traction[c] * fe_values.shape_value(v, q) * fe_values.JxW(q);
                }
              cell->get_dof_indices(dofs);
              discretization.hanging_node_constraints().distribute_local_to_global(
                local, dofs, forces);
            }
    return all_are_numbers;
  }


  template class BodyForce<2>;
  template class BodyForce<3>;
  template class Loads<2>;
  template class Loads<3>;
} // namespace signorini
