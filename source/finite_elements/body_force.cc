// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/body_force.h>
#include <signorini/base/expressions.h>

namespace signorini
{
  template <int dim>
  BodyForce<dim>::BodyForce(const Discretization<dim> &discretization)
    : discretization(discretization)
  {
    for (const auto &body : discretization.scene.bodies)
      {
        expressions.push_back(body.body_force);
        any             = any || is_given(body.body_force);
        depends_on_time = depends_on_time || has_time(body.body_force);
      }
  }


  template <int dim>
  const Vector &BodyForce<dim>::at(const double time)
  {
    for (const auto &[kept_time, force] : kept)
      if (force.size() > 0 && (kept_time == time || !depends_on_time))
        return force;
    latest       = 1 - latest;
    kept[latest] = {time, any ? discretization.interpolate(expressions, time) : discretization.make_vector()};
    return kept[latest].second;
  }


  template class BodyForce<2>;
  template class BodyForce<3>;
} // namespace signorini
