// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/rigid_obstacle.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  MotionCondition<dim> RigidObstacle<dim>::condition_of_motion(const Point<dim> &start,
                                                               const Point<dim> &end) const
  {
    const Tensor<1, dim> motion   = end - start;
    const auto           at_start = project(start);
    const auto           at_end = try_project(end), in_middle = try_project(start + 0.5 * motion);
    if (!at_end || !in_middle)
      return {at_start.normal, at_start.gap, 1., false};
    const double   before = at_start.gap, after = at_end->gap;
    Tensor<1, dim> normal = in_middle->normal;
    const double   length = motion.norm();
    const double   missed = before - after - normal * motion;
    // The tilt that round-off in the gaps suggests for a small motion would be arbitrary. What is
    // left without it must be less than the round-off that contact accepts of a gap.
    const double round_off = 4. * std::numeric_limits<double>::epsilon()
                             * (start.norm() + std::abs(before) + std::abs(after));
    if (std::abs(missed) <= round_off)
      return {normal, before};
    if (std::abs(missed) > largest_tilt * length)
      return {at_start.normal, before, 1., false};
    normal += missed / (length * length) * motion;
    const double size = normal.norm();
    return {normal / size, before / size, size};
  }


  template class RigidObstacle<2>;
  template class RigidObstacle<3>;
} // namespace signorini
