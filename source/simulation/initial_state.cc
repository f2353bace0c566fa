// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/simulation/initial_state.h>

#include <deal.II/base/utilities.h>

#include <cstdlib>

namespace signorini
{
  double perturbation_of_velocities()
  {
    const char *const text = std::getenv("SIGNORINI_PERTURB");
    return text == nullptr ? 0. : dealii::Utilities::string_to_double(text);
  }


  template <int dim>
  State initial_state(const Discretization<dim> &discretization)
  {
    std::vector<std::array<std::string, dim>> displacements, velocities;
    for (const auto &body : discretization.mesh().bodies())
      {
        displacements.push_back(body.initial_displacement);
        velocities.push_back(body.initial_velocity);
      }
    State state;
    state.displacement = discretization.interpolate(displacements);
    state.velocity     = discretization.interpolate(velocities);
    state.velocity *= 1. + perturbation_of_velocities();
    state.contact_force = state.momentum = state.internal_force = discretization.make_vector();
    return state;
  }


  template State initial_state(const Discretization<2> &);
  template State initial_state(const Discretization<3> &);
} // namespace signorini
