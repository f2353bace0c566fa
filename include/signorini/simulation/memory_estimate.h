// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_memory_estimate_h
#define signorini_simulation_memory_estimate_h

#include <signorini/simulation/meshed_scene.h>

namespace signorini
{
  /** Bytes. */
  struct MemoryEstimate
  {
    double prepared = 0.; ///< taken by all processes together before the first step, as measured
    double run      = 0.; ///< expected of the whole run on the present mesh, the same
    double largest_process = 0.; ///< the part of `run` of the process that needs most
    /**
     * Like `run`, if the mesh grows to `Adaptivity/Maximum cells`; infinite if that sets no limit,
     * and equal to `run` on meshes that do not change.
     */
    double at_most = 0.;
  };

  /**
   * What a run takes: the most that has been taken until now, as the system tells, and what steps
   * add to it for each unknown and fields for each cell. The latter are means of measured runs, see
   * doc/output.md. Collective.
   */
  template <int dim>
  MemoryEstimate memory_estimate(const Scene<dim> &scene, const MeshedScene<dim> &meshed);
} // namespace signorini

#endif
