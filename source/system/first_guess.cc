// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/first_guess.h>

#include <algorithm>

namespace signorini
{
  template <int dim>
  void FirstGuess<dim>::from_start(const IncrementProblem &problem,
                                   const LinearOperator   &matrix,
                                   const Vector           &right_hand_side,
                                   Vector                 &increment,
                                   ActiveSet              &active) const
  {
    increment.equ(problem.step_size, problem.start.velocity);
    coordinates.displacement_to_contact(increment);
    const double reach = std::max(increment.linfty_norm(), touching);
    // In long steps velocities are no increments: they alternate. The part of them that has the
    // least energy is never worse than none, and as good as all of them in short steps.
    Vector product = right_hand_side;
    matrix.vmult(product, increment);
    if (const double energy = dot(increment, product); energy > 0.)
      increment *= std::clamp(dot(increment, right_hand_side) / energy, 0., 1.);
    status(problem.start, active);
    // On a finer mesh forces are spread to nodes that do not touch.
    for (unsigned int k = 0; k < active.size(); ++k)
      if (problem.bounds[k] > reach)
        active[k] = contact_status::open;
  }


  template <int dim>
  void FirstGuess<dim>::status(const State &start, ActiveSet &active) const
  {
    Vector force = start.contact_force;
    coordinates.force_to_contact(force);
    for (unsigned int k = 0; k < active.size(); ++k)
      {
        // New nodes between those that stick and those that slip are under pressure, but have no
        // status yet.
        active[k] = start.friction.any() ? start.friction.status[k] : contact_status::open;
        if (is_pressed(force.local_element(coordinates.normal_entries()[k])))
          active[k] = std::max(active[k], contact_status::slip);
      }
  }


  template <int dim>
  void FirstGuess<dim>::expect_contact(const Vector    &increment,
                                       const NormalGap &bounds,
                                       ActiveSet       &active) const
  {
    for (unsigned int k = 0; k < active.size(); ++k)
      if (increment.local_element(coordinates.normal_entries()[k]) > bounds[k])
        active[k] = std::max(active[k], contact_status::slip);
  }


  template class FirstGuess<2>;
  template class FirstGuess<3>;
} // namespace signorini
