// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Static problems of an ElasticContactSystem.

#include <signorini/base/user_error.h>
#include <signorini/system/elastic_contact_system.h>
#include <signorini/system/scales.h>

#include <deal.II/base/patterns.h>

namespace signorini
{
  template <int dim>
  StaticEquilibrium<dim> &ElasticContactSystem<dim>::statics()
  {
    // Rigid motions are kept in contact coordinates.
    if (!static_equilibrium || turns_of_statics != coordinates.n_turns())
      {
        dealii::TimerOutput::Scope scope(timer, "step: preconditioner set-up");
        static_equilibrium = std::make_unique<StaticEquilibrium<dim>>(
          discretization, coordinates, parameters.solver, friction.any());
        turns_of_statics = coordinates.n_turns();
      }
    return *static_equilibrium;
  }


  template <int dim>
  Friction ElasticContactSystem<dim>::laws_of_load_step(const NormalGap &bounds) const
  {
    if (!friction.any())
      return {};
    return friction.of_step(1.,
                            step_contact ? step_contact->gaps_at_start() : bounds,
                            touching_distance(discretization.mesh().body_size()),
                            nullptr);
  }


  template <int dim>
  void ElasticContactSystem<dim>::equilibrate(const LoadStep &step, IncrementSolution &solution)
  {
    StaticEquilibrium<dim>    &equilibrium = statics();
    dealii::TimerOutput::Scope scope(timer, "step: inequality");
    const std::vector<double>  prescribed = prescribed_increments(step.start, step.step_size);
    const Friction             laws       = laws_of_load_step(step.bounds);
    first_guess.status(step.start, active);

    Vector force = step.force, drag;
    if (step_contact && friction.any())
      drag = step_contact->drag();
    if (drag.size() > 0) // tangential entries are slip
      {
        Vector motion = drag, resistance = drag;
        coordinates.displacement_to_cartesian(motion);
        discretization.matrices().apply_stiffness(resistance, motion);
        force -= resistance;
      }
    StaticProblem problem{force, step.bounds, prescribed, laws};
    problem.energy             = largest_energies.motion;
    const StaticSolution found = equilibrium.find_held(problem, active);
    if (!found.is_held)
      throw RunError("There is no static equilibrium at time "
                     + dealii::Patterns::Tools::to_string(step.start.time + step.step_size)
                     + ": neither Dirichlet conditions nor contact hold what the loads move: "
                     + equilibrium.unheld_motion(found)
                     + ". Prescribe a displacement against this motion, let loads balance, give "
                       "the contact more friction or pressure, or take a scheme with inertia.");
    active             = found.status;
    solution.increment = found.increment;
    solution.effort    = found.effort;
    extract(laws, found.residual, equilibrium.stiffness_matrix(), false, drag, solution);
  }


#define INSTANTIATE(dim)                                                                           \
  template StaticEquilibrium<dim> &ElasticContactSystem<dim>::statics();                           \
  template Friction ElasticContactSystem<dim>::laws_of_load_step(const NormalGap &) const;         \
  template void     ElasticContactSystem<dim>::equilibrate(const LoadStep &, IncrementSolution &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
