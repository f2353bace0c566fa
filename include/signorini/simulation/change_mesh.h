// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_change_mesh_h
#define signorini_simulation_change_mesh_h

#include <signorini/simulation/meshed_scene.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Refine and coarsen what is flagged, share the cells among the processes, build everything anew on the new mesh, and carry the state there.
   * Both @p meshed and @p state are replaced. Collective.
   */
  template <int dim>
  void change_mesh(Discretization<dim>               &discretization,
                   std::unique_ptr<MeshedScene<dim>> &meshed,
                   State                             &state,
                   dealii::TimerOutput               &timer);
} // namespace signorini

#endif
