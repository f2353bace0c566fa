// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/simulation/simulation.h>

namespace signorini
{
template <int dim>
Simulation<dim>::Simulation(const Scene<dim> &scene, const MPI_Comm comm, const bool quiet)
  : scene(scene)
  , comm(comm)
  , quiet(quiet)
{
}

template <int dim>
std::string
Simulation<dim>::validate()
{
  return scene.file_name + ": the scene is in order, " + std::to_string(scene.time.n_steps()) +
         " steps of " + scene.time.scheme + " would run.\n";
}

template <int dim>
void
Simulation<dim>::run()
{
  throw RunError("running a scene is not available yet.");
}

template class Simulation<2>;
template class Simulation<3>;
} // namespace signorini
