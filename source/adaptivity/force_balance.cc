// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/force_balance.h>

namespace signorini
{
  namespace
  {
    /** C d/tau of the bodies, d the increment: a force per mass, and more displacement. */
    template <int dim>
    void
    add_damping(const ElasticMatrices<dim> &matrices, const StepRecord &step, ForceBalance &balance)
    {
      if (matrices.damping.empty())
        return;
      for (unsigned int node = 0; node < matrices.pattern.n_owned; ++node)
        for (unsigned int i = dim * node; i < dim * (node + 1); ++i)
          {
            const double rate =
              (step.end.displacement.local_element(i) - step.start.displacement.local_element(i))
              / step.step_size;
            balance.specific_force.local_element(i) -= matrices.damping[node].mass * rate;
            balance.displacement.local_element(i) += matrices.damping[node].stiffness * rate;
          }
    }
  } // namespace


  template <int dim>
  ForceBalance balance_of_step(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const StepRecord          &step,
                               const TimeIntegration     &time,
                               BodyForce<dim>            &body_force)
  {
    const StepBalance kind = time.balance;
    ForceBalance      balance;
    balance.end_time      = step.end.time;
    balance.start_time    = step.end.time - step.step_size;
    balance.displacement  = step.end.displacement;
    balance.contact_force = step.end.contact_force;
    if (kind == StepBalance::end)
      balance.start_time = balance.end_time;
    else
      balance.displacement.sadd(
        0.5 + step.stiffness_damping, 0.5 - step.stiffness_damping, step.start.displacement);
    if (kind == StepBalance::both_ends)
      balance.contact_force.sadd(0.5, 0.5, step.start.contact_force);
    balance.specific_force = body_force.at(balance.end_time);
    if (balance.start_time != balance.end_time)
      balance.specific_force.sadd(0.5, 0.5, body_force.at(balance.start_time));
    balance.specific_force.add(
      -1. / step.step_size, step.end.velocity, 1. / step.step_size, step.start.velocity);
    add_damping(discretization.matrices(), step, balance);
    balance.gap = surface.distance(step.end.displacement);
    return balance;
  }


  template <int dim>
  ForceBalance balance_of_step(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const StepRecord          &step,
                               const TimeIntegration     &time)
  {
    BodyForce<dim> body_force(discretization);
    return balance_of_step(discretization, surface, step, time, body_force);
  }


  template <int dim>
  ForceBalance balance_at_rest(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const Vector              &displacement,
                               const Vector              &contact_force,
                               const double               time)
  {
    return {displacement,
            BodyForce<dim>(discretization).at(time),
            contact_force,
            surface.distance(displacement),
            time,
            time};
  }


#define INSTANTIATE(dim)                                                                           \
  template ForceBalance balance_of_step(const Discretization<dim> &,                               \
                                        const ContactSurface<dim> &,                               \
                                        const StepRecord &,                                        \
                                        const TimeIntegration &,                                   \
                                        BodyForce<dim> &);                                         \
  template ForceBalance balance_of_step(const Discretization<dim> &,                               \
                                        const ContactSurface<dim> &,                               \
                                        const StepRecord &,                                        \
                                        const TimeIntegration &);                                  \
  template ForceBalance balance_at_rest(const Discretization<dim> &,                               \
                                        const ContactSurface<dim> &,                               \
                                        const Vector &,                                            \
                                        const Vector &,                                            \
                                        double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
