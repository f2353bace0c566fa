// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/stop_held_nodes.h>
#include <signorini/schemes/support_forces.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  ActiveSet staying_nodes(const DynamicalSystem   &system,
                          const NormalGap         &gap,
                          const IncrementSolution &solution,
                          const bool               normal,
                          const bool               tangential)
  {
    const double touching = touching_distance(system.length());
    ActiveSet    held(gap.size(), contact_status::open);
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (gap[k] <= touching && solution.normal_reaction[k] < 0.)
        {
          const bool sticks =
            tangential && !solution.status.empty() && contact_status::sticks(solution.status[k]);
          if (normal)
            held[k] = sticks ? contact_status::stick : contact_status::slip;
          else if (sticks)
            held[k] = contact_status::hang;
        }
    return held;
  }


  namespace
  {
    /**
     * Obstacles and bodies press and do not pull: where a stop would make them, it is left out.
     * @param forces of contact without the stop
     * @return whether any node was let go
     */
    bool let_go_what_would_be_pulled(const DynamicalSystem &system,
                                     const Vector          &forces,
                                     const Vector          &forces_of_stop,
                                     ActiveSet             &held)
    {
      Vector all = forces;
      all += forces_of_stop;
      const NormalGap of_stop = system.own_normal_forces(forces_of_stop),
                      total   = system.own_normal_forces(all);
      unsigned int n_let_go   = 0;
      for (std::size_t k = 0; k < held.size(); ++k)
        if (contact_status::is_closed(held[k]) && of_stop[k] > 0. && total[k] > 0.)
          {
            held[k] = contact_status::open;
            ++n_let_go;
          }
      return dealii::Utilities::MPI::sum(n_let_go, forces.get_mpi_communicator()) > 0;
    }
  } // namespace


  double stop_held_nodes(DynamicalSystem &system,
                         ActiveSet        held,
                         const double     step_size,
                         const Vector    &velocity,
                         Vector          &velocity_change,
                         Vector          &contact_force,
                         StepReport      &report)
  {
    if (is_trial(system))
      return 0.;
    Vector new_velocity = velocity, correction, forces;
    new_velocity += velocity_change;
    Vector relative_velocity = new_velocity;
    if (const Vector *motion = obstacle_motion(system))
      relative_velocity.add(-1. / step_size, *motion);
    do
      {
        const SolveReport effort = system.capabilities().projections->stop_relative_motion(
          relative_velocity, held, correction, forces);
        report.predictor.linear_iterations += effort.linear_iterations;
        if (effort.n_active == 0)
          return 0.;
        forces /= step_size; // they were impulses
      }
    while (let_go_what_would_be_pulled(system, contact_force, forces, held));
    const Vector dirichlet      = dirichlet_part(system, forces);
    const double work_dirichlet = step_size * (dirichlet * new_velocity);
    const double work_obstacles = obstacle_work(system, forces) - obstacle_work(system, dirichlet);
    const double work           = step_size * (forces * new_velocity + 0.5 * (forces * correction))
                        - work_dirichlet - work_obstacles;

    velocity_change += correction;
    contact_force.add(1., forces, -1., dirichlet);
    report.work_dirichlet += work_dirichlet;
    report.work_obstacles += work_obstacles;
    add_support_force(system, 1., dirichlet, report);
    return work;
  }
} // namespace signorini
