// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mass/redistribute_mass.h>
#include <signorini/simulation/meshed_scene.h>

namespace signorini
{
  namespace
  {
    /** For its place in front of everything that needs matrices. */
    template <int dim>
    const Discretization<dim> &assembled(Discretization<dim> &discretization, dealii::TimerOutput &timer)
    {
      dealii::TimerOutput::Scope scope(timer, "mesh: mass and stiffness");
      discretization.assemble();
      return discretization;
    }


    template <int dim>
    ContactSurface<dim>
    make_surface(const Discretization<dim> &discretization, const Supports<dim> &supports, dealii::TimerOutput &timer)
    {
      dealii::TimerOutput::Scope scope(timer, "mesh: contact surface");
      return ContactSurface<dim>(discretization, supports);
    }
  } // namespace


  template <int dim>
  MeshedScene<dim>::MeshedScene(Discretization<dim> &discretization, dealii::TimerOutput &timer)
    : supports(assembled(discretization, timer))
    , surface(make_surface(discretization, supports, timer))
    , mass_note(redistribute_mass(discretization, surface))
    , coordinates(discretization, surface, supports)
    , loads(discretization)
    , system(discretization, surface, coordinates, loads, timer)
  {
  }


  template struct MeshedScene<2>;
  template struct MeshedScene<3>;
} // namespace signorini
