// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_change_mesh_h
#define signorini_simulation_change_mesh_h

#include <signorini/simulation/meshed_scene.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Refine and coarsen what is flagged, share the cells among the processes, and build everything
   * anew on the new mesh; the energy of the motion is known there. Collective.
   */
  template <int dim>
  void build_on_changed_mesh(Mesh<dim>                         &mesh,
                             const Scene<dim>                  &scene,
                             unsigned int                       mesh_life_time,
                             std::unique_ptr<MeshedScene<dim>> &meshed,
                             dealii::TimerOutput               &timer);

  /** Build everything but the matrices anew on the mesh as it is. Collective. */
  template <int dim>
  void build_anew(const Scene<dim>                  &scene,
                  unsigned int                       mesh_life_time,
                  std::unique_ptr<MeshedScene<dim>> &meshed,
                  dealii::TimerOutput               &timer);

  /** build_on_changed_mesh(), and carry the state to the new mesh. Collective. */
  template <int dim>
  void change_mesh(Mesh<dim>                         &mesh,
                   const Scene<dim>                  &scene,
                   unsigned int                       mesh_life_time,
                   std::unique_ptr<MeshedScene<dim>> &meshed,
                   State                             &state,
                   dealii::TimerOutput               &timer);
} // namespace signorini

#endif
