// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_initial_equilibrium_h
#define signorini_simulation_initial_equilibrium_h

#include <signorini/simulation/meshed_scene.h>
#include <signorini/system/start_equilibrium.h>

namespace signorini
{
  /**
   * The equilibrium in which a run starts: start_in_equilibrium(). Where contact follows the
   * motion, its normals and gaps are those of the equilibrium itself, found by a fixed point from
   * the undeformed bodies; obstacles are where they are at time 0. Collective.
   * @param state displacement, contact force and friction become those of the equilibrium
   * @throws RunError if there is none, or none whose normals are its own
   */
  template <int dim>
  StartReport initial_equilibrium(const Scene<dim> &scene, MeshedScene<dim> &meshed, State &state);
} // namespace signorini

#endif
