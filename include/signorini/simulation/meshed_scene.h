// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_meshed_scene_h
#define signorini_simulation_meshed_scene_h

#include <signorini/system/elastic_contact_system.h>

namespace signorini
{
  /**
   * All that is built on a mesh, and built anew when the mesh changes, in the order in which one needs the other. Matrices are part of the
   * discretisation.
   */
  template <int dim>
  struct MeshedScene
  {
    /** Assembles the matrices of the discretisation first. Collective. @throws UserError see ContactSurface */
    MeshedScene(Discretization<dim> &discretization, dealii::TimerOutput &timer);

    Supports<dim>             supports;
    ContactSurface<dim>       surface;
    std::string               mass_note; ///< what became of the mass, if that is not the consistent one
    ContactCoordinates<dim>   coordinates;
    Loads<dim>                loads;
    ElasticContactSystem<dim> system;

    /** f at a time, null without loads. */
    const Vector *load(const double time) { return loads.any() ? &loads.at(time) : nullptr; }
  };
} // namespace signorini

#endif
