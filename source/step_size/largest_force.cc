// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/energy_norm.h>
#include <signorini/step_size/largest_force.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * Elastic energies below this part of the largest energy are taken for it: far from where it
     * began, a body without deformation has one by round-off.
     */
    constexpr double noticeable = 1e-8;

    double elastic_energy(const State &state)
    {
      return 0.5 * (state.displacement * state.internal_force);
    }
  } // namespace


  double LargestForce::expected(const State &start, const State &end, const double force) const
  {
    const double energy = std::max({so_far.energy, energy_of_motion(start), energy_of_motion(end)});
    const double least  = noticeable * energy;
    const double elastic = std::max(elastic_energy(end), least);
    const double largest = std::max(so_far.elastic_energy, least);
    const double growth  = elastic >= largest ? std::sqrt(std::max(1., energy / elastic)) : 1.;
    return std::max(so_far.force, force * growth);
  }


  void LargestForce::accept(const State &start, const State &end, const double force)
  {
    before        = so_far;
    so_far.force  = std::max(so_far.force, force);
    so_far.energy = std::max({so_far.energy, energy_of_motion(start), energy_of_motion(end)});
    so_far.elastic_energy = std::max(so_far.elastic_energy, elastic_energy(end));
  }
} // namespace signorini
