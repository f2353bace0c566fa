// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/energy_of_vibration.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/rigid_modes.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  void take_from_vibration(const Discretization<dim>     &discretization,
                           const ContactCoordinates<dim> &coordinates,
                           const double                   energy,
                           State                         &state)
  {
    Assert(energy > 0., dealii::ExcMessage("Energy is taken, not given."));
    Vector vibration = state.velocity;
    coordinates.rotate_to_frames(vibration); // prescribed entries are not relative
    for (const unsigned int i : coordinates.dirichlet_entries())
      vibration.local_element(i) = 0.;
    coordinates.rotate_from_frames(vibration);
    const RigidModes<dim> rigid(discretization, coordinates);
    for (const Motion &mode : rigid.free_of(coordinates.dirichlet_entries()))
      vibration.add(-dot(mode.momentum, vibration), mode.displacement);
    Vector momentum = discretization.make_vector();
    discretization.matrices().apply_mass(momentum, vibration);

    // t w'Mv - t^2/2 w'Mw = energy; the left side is largest at t = w'Mv / w'Mw
    const double linear    = dot(momentum, state.velocity);
    const double quadratic = dot(momentum, vibration);
    if (!(linear > 0. && quadratic > 0.))
      return;
    const double square = linear * linear - 2. * quadratic * energy;
    const double part =
      square > 0. ? 2. * energy / (linear + std::sqrt(square)) : linear / quadratic;
    state.velocity.add(-part, vibration);
    state.momentum.add(-part, momentum);
  }


  template void
  take_from_vibration(const Discretization<2> &, const ContactCoordinates<2> &, double, State &);
  template void
  take_from_vibration(const Discretization<3> &, const ContactCoordinates<3> &, double, State &);
} // namespace signorini
