// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/state_transfer.h>
#include <signorini/simulation/change_mesh.h>

namespace signorini
{
  template <int dim>
  void build_on_changed_mesh(Mesh<dim>                         &mesh,
                             const Scene<dim>                  &scene,
                             const unsigned int                 mesh_life_time,
                             std::unique_ptr<MeshedScene<dim>> &meshed,
                             dealii::TimerOutput               &timer)
  {
    const MotionEnergies energies = meshed->system.energies();
    const ProductCount   products = meshed->discretization.matrices().products();
    {
      dealii::TimerOutput::Scope scope(timer, "mesh: cells");
      // It lives until the cells have changed; if they cannot, nothing is left to be taken for a
      // state.
      const std::unique_ptr<MeshedScene<dim>> old = std::move(meshed);
      mesh.carry_out_flags();
    }
    meshed = std::make_unique<MeshedScene<dim>>(mesh, scene, mesh_life_time, timer);
    meshed->system.see(energies);
    meshed->discretization.matrices().add_products(products);
  }


  template <int dim>
  void build_anew(const Scene<dim>                  &scene,
                  const unsigned int                 mesh_life_time,
                  std::unique_ptr<MeshedScene<dim>> &meshed,
                  dealii::TimerOutput               &timer)
  {
    const MotionEnergies energies = meshed->system.energies();
    const ProductCount   products = meshed->discretization.matrices().products();
    meshed = std::make_unique<MeshedScene<dim>>(std::move(meshed), scene, mesh_life_time, timer);
    meshed->system.see(energies);
    meshed->discretization.matrices().set_products(products);
  }


  template <int dim>
  void change_mesh(Mesh<dim>                         &mesh,
                   const Scene<dim>                  &scene,
                   const unsigned int                 mesh_life_time,
                   std::unique_ptr<MeshedScene<dim>> &meshed,
                   State                             &state,
                   dealii::TimerOutput               &timer)
  {
    StateTransfer<dim> transfer(mesh,
                                meshed->discretization,
                                meshed->surface,
                                meshed->coordinates,
                                state,
                                meshed->load(state.time));
    build_on_changed_mesh(mesh, scene, mesh_life_time, meshed, timer);
    dealii::TimerOutput::Scope scope(timer, "mesh: transfer of the state");
    // Vectors that are assigned to would keep their old ghosts if they own the same entries.
    state = State();
    state = transfer.finish(meshed->discretization,
                            meshed->surface,
                            meshed->coordinates,
                            meshed->system,
                            scene.solver.limits);
  }


#define INSTANTIATE(dim)                                                                           \
  template void build_on_changed_mesh(Mesh<dim> &,                                                 \
                                      const Scene<dim> &,                                          \
                                      unsigned int,                                                \
                                      std::unique_ptr<MeshedScene<dim>> &,                         \
                                      dealii::TimerOutput &);                                      \
  template void build_anew(                                                                        \
    const Scene<dim> &, unsigned int, std::unique_ptr<MeshedScene<dim>> &, dealii::TimerOutput &); \
  template void change_mesh(Mesh<dim> &,                                                           \
                            const Scene<dim> &,                                                    \
                            unsigned int,                                                          \
                            std::unique_ptr<MeshedScene<dim>> &,                                   \
                            State &,                                                               \
                            dealii::TimerOutput &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
