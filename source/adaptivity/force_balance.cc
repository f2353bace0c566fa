// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/force_balance.h>
#include <signorini/schemes/scheme_table.h>

namespace signorini
{
  template <int dim>
  ForceBalance balance_of_step(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const StepRecord          &step,
                               BodyForce<dim>            &body_force)
  {
    const StepBalance kind = scheme_info(discretization.scene.time.scheme).balance;
    ForceBalance      balance;
    balance.end_time      = step.end.time;
    balance.start_time    = step.end.time - step.step_size;
    balance.displacement  = step.end.displacement;
    balance.contact_force = step.end.contact_force;
    if (kind == StepBalance::end)
      balance.start_time = balance.end_time;
    else
      balance.displacement.sadd(0.5, 0.5, step.start.displacement);
    if (kind == StepBalance::both_ends)
      balance.contact_force.sadd(0.5, 0.5, step.start.contact_force);
    balance.specific_force = body_force.at(balance.end_time);
    if (balance.start_time != balance.end_time)
      balance.specific_force.sadd(0.5, 0.5, body_force.at(balance.start_time));
    balance.specific_force.add(-1. / step.step_size, step.end.velocity, 1. / step.step_size, step.start.velocity);
    balance.gap = surface.distance(step.end.displacement);
    return balance;
  }


  template <int dim>
  ForceBalance
  balance_of_step(const Discretization<dim> &discretization, const ContactSurface<dim> &surface, const StepRecord &step)
  {
    BodyForce<dim> body_force(discretization);
    return balance_of_step(discretization, surface, step, body_force);
  }


  template <int dim>
  ForceBalance balance_at_rest(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const Vector              &displacement,
                               const Vector              &contact_force,
                               const double               time)
  {
    return {
      displacement, BodyForce<dim>(discretization).at(time), contact_force, surface.distance(displacement), time, time};
  }


  template ForceBalance
  balance_of_step(const Discretization<2> &, const ContactSurface<2> &, const StepRecord &, BodyForce<2> &);
  template ForceBalance
  balance_of_step(const Discretization<3> &, const ContactSurface<3> &, const StepRecord &, BodyForce<3> &);
  template ForceBalance balance_of_step(const Discretization<2> &, const ContactSurface<2> &, const StepRecord &);
  template ForceBalance balance_of_step(const Discretization<3> &, const ContactSurface<3> &, const StepRecord &);
  template ForceBalance
  balance_at_rest(const Discretization<2> &, const ContactSurface<2> &, const Vector &, const Vector &, double);
  template ForceBalance
  balance_at_rest(const Discretization<3> &, const ContactSurface<3> &, const Vector &, const Vector &, double);
} // namespace signorini
