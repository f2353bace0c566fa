// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_simulation_h
#define signorini_simulation_simulation_h

#include <signorini/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace signorini
{
  /** A run of one scene. All functions are collective. */
  template <int dim>
  class Simulation
  {
  public:
    /** @param quiet no progress line. The scene must outlive the simulation. */
    Simulation(const Scene<dim> &scene, MPI_Comm comm, bool quiet);

    /** Build all that can be built without a time step. @return what would run, for the user. @throws UserError. */
    std::string validate();

    /** From time 0 to the end. @throws RunError. */
    void run();

  private:
    const Scene<dim> &scene;
    const MPI_Comm    comm;
    const bool        quiet;
  };
} // namespace signorini

#endif
