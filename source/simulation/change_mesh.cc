// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/state_transfer.h>
#include <signorini/simulation/change_mesh.h>

namespace signorini
{
  template <int dim>
  void change_mesh(Discretization<dim>               &discretization,
                   std::unique_ptr<MeshedScene<dim>> &meshed,
                   State                             &state,
                   dealii::TimerOutput               &timer)
  {
    const double energy = meshed->system.energy();

    StateTransfer<dim> transfer(discretization, meshed->surface, meshed->coordinates, state);
    {
      dealii::TimerOutput::Scope scope(timer, "mesh: cells and degrees of freedom");
      discretization.triangulation.execute_coarsening_and_refinement();
      meshed.reset();
      discretization.distribute();
    }
    meshed = std::make_unique<MeshedScene<dim>>(discretization, timer);
    meshed->system.set_energy(energy);
    dealii::TimerOutput::Scope scope(timer, "mesh: transfer of the state");
    state = State(); // vectors that are assigned to would keep their old ghosts if they own the same entries
    state = transfer.finish(meshed->surface, meshed->coordinates, meshed->system);
  }


#define INSTANTIATE(dim)                                                                                               \
  template void change_mesh(Discretization<dim> &, std::unique_ptr<MeshedScene<dim>> &, State &, dealii::TimerOutput &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
