// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/discretization/loads.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <limits>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  Loads<dim>::Loads(const Discretization<dim> &discretization)
    : discretization(discretization)
  {
    for (const auto &body : discretization.scene.bodies)
      {
        has_loads       = has_loads || is_given(body.body_force);
        depends_on_time = depends_on_time || has_time(body.body_force);
        for (const auto &condition : body.traction)
          {
            has_loads       = has_loads || is_given(condition.expressions);
            depends_on_time = depends_on_time || has_time(condition.expressions);
          }
      }
    for (auto &[time, vector] : kept)
      time = std::numeric_limits<double>::quiet_NaN();
  }


  template <int dim>
  const Vector &Loads<dim>::at(const double time)
  {
    for (auto &[kept_time, vector] : kept)
      if (kept_time == time || (!depends_on_time && vector.size() > 0))
        return vector;
    latest       = 1 - latest;
    kept[latest] = {time, assemble(time)};
    return kept[latest].second;
  }


  template <int dim>
  Vector Loads<dim>::assemble(const double time) const
  {
    // Body forces by nodal interpolation and the consistent mass: exact for constants, second order otherwise.
    std::vector<std::array<std::string, dim>> body_forces;
    for (const auto &body : discretization.scene.bodies)
      body_forces.push_back(body.body_force);
    Vector result = discretization.make_vector();
    discretization.matrices.apply_mass(result, discretization.interpolate(body_forces, time));

    const FE_Q<dim>                      scalar_fe(1);
    FEFaceValues<dim>                    fe_values(discretization.mapping,
                                scalar_fe,
                                QGauss<dim - 1>(discretization.n_quadrature_points()),
                                update_values | update_quadrature_points | update_JxW_values);
    std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
    dealii::Vector<double>               local(dofs.size()), traction(dim);
    for (unsigned int b = 0; b < discretization.scene.bodies.size(); ++b)
      for (const auto &condition : discretization.scene.bodies[b].traction)
        {
          const auto function = make_function<dim, dim>(condition.expressions);
          function->set_time(time);
          for (const auto &cell : discretization.dof_handler.active_cell_iterators())
            if (cell->is_locally_owned() && cell->material_id() == b)
              for (const unsigned int f : cell->face_indices())
                if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id)
                  {
                    fe_values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(cell), f);
                    local = 0.;
                    for (const unsigned int q : fe_values.quadrature_point_indices())
                      {
                        function->vector_value(fe_values.quadrature_point(q), traction);
                        for (unsigned int v = 0; v < scalar_fe.n_dofs_per_cell(); ++v)
                          for (unsigned int c = 0; c < dim; ++c)
                            local[dim * v + c] += traction[c] * fe_values.shape_value(v, q) * fe_values.JxW(q);
                      }
                    cell->get_dof_indices(dofs);
                    discretization.hanging_node_constraints.distribute_local_to_global(local, dofs, result);
                  }
        }
    result.compress(VectorOperation::add);
    return result;
  }


  template class Loads<2>;
  template class Loads<3>;
} // namespace signorini
