// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_driven_scenes_h
#define signorini_tests_driven_scenes_h

#include "bouncing_mass.h"
#include "elastic_bar.h"

namespace signorini
{
  /** A system and its start: both bodies hit a wall several times. */
  inline std::pair<std::unique_ptr<DynamicalSystem>, State> make_scene(const std::string &name)
  {
    if (name == "mass_on_spring")
      {
        auto system    = std::make_unique<BouncingMass>();
        system->mass   = 2.;
        system->spring = 30.;
        system->wall   = 0.1;
        system->load   = [](const double t) { return 5. * std::sin(3. * t); };
        State state    = make_state(*system, -0.2, 1.);
        return {std::move(system), std::move(state)};
      }
    auto system = std::make_unique<ElasticBar>(6);
    if (name == "driven_bar")
      system->motion = [](const double t) { return 0.4 * std::sin(4. * t); };
    else
      system->load = [](const double t) { return 0.3 * std::cos(2. * t); };
    Vector u = system->make_vector(), v = u;
    for (unsigned int i = 0; i < u.size(); ++i)
      v(i) = 1. + 0.5 * std::sin(i);
    State state = make_state(*system, u, v);
    return {std::move(system), std::move(state)};
  }
} // namespace signorini

#endif
