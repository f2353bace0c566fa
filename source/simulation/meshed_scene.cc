// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mass/redistribute_mass.h>
#include <signorini/simulation/meshed_scene.h>

namespace signorini
{
  namespace
  {
    /** Calls a constructor with a section of the timer of its own. */
    template <typename Make>
    auto timed(dealii::TimerOutput &timer, const std::string &section, const Make &make)
    {
      dealii::TimerOutput::Scope scope(timer, section);
      return make();
    }


    /** @return a sentence about the mass for the user, if contact nodes have none */
    template <int dim>
    std::string give_mass(Discretization<dim>       &discretization,
                          const ContactSurface<dim> &surface,
                          const MassParameters      &mass)
    {
      if (mass.kind == MassKind::lumped)
        discretization.matrices().lump_mass();
      return redistribute_mass(discretization, surface, mass);
    }
  } // namespace


  template <int dim>
  MeshedScene<dim>::MeshedScene(const Mesh<dim>     &mesh,
                                const Scene<dim>    &scene,
                                const unsigned int   mesh_life_time,
                                dealii::TimerOutput &timer)
    : MeshedScene({timed(timer,
                         "mesh: degrees of freedom and matrices",
                         [&] { return std::make_shared<Discretization<dim>>(mesh); }),
                   std::nullopt},
                  scene,
                  mesh_life_time,
                  timer)
  {
  }


  template <int dim>
  MeshedScene<dim>::MeshedScene(std::unique_ptr<MeshedScene> other,
                                const Scene<dim>            &scene,
                                const unsigned int           mesh_life_time,
                                dealii::TimerOutput         &timer)
    : MeshedScene(taken_from(std::move(other)), scene, mesh_life_time, timer)
  {
  }


  template <int dim>
  MeshedScene<dim>::MeshedScene(Matrices             matrices,
                                const Scene<dim>    &scene,
                                const unsigned int   mesh_life_time,
                                dealii::TimerOutput &timer)
    : owned(std::move(matrices.first))
    , discretization(*owned)
    , dirichlet(discretization)
    , surface(timed(timer,
                    "mesh: contact surface",
                    [&] {
                      return ContactSurface<dim>(discretization,
                                                 dirichlet,
                                                 scene.obstacles,
                                                 scene.pairs,
                                                 scene.motion,
                                                 scene.how_to_follow);
                    }))
    , mass_note(matrices.second ? *matrices.second
                                : give_mass(discretization, surface, scene.time.mass))
    , coordinates(discretization, surface, dirichlet)
    , loads(discretization)
    , system(discretization,
             surface,
             coordinates,
             loads,
             system_parameters(scene, mesh_life_time),
             timer)
  {
    if (scene.motion == ContactMotion::follow)
      system.let_contact_follow(dirichlet, surface, coordinates);
  }


  template struct MeshedScene<2>;
  template struct MeshedScene<3>;
} // namespace signorini
