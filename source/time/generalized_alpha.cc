// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/time/first_acceleration.h>
#include <signorini/time/generalized_alpha.h>
#include <signorini/time/trapezoidal_rule.h>

namespace signorini
{
  GeneralizedAlpha::GeneralizedAlpha(const double alpha_m, const double alpha_f)
    : alpha_m(alpha_m)
    , alpha_f(alpha_f)
    , beta((1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f) / 4.)
    , gamma(0.5 - alpha_m + alpha_f)
  {
  }


  GeneralizedAlpha GeneralizedAlpha::with_spectral_radius(const double rho)
  {
    return GeneralizedAlpha((2. * rho - 1.) / (rho + 1.), rho / (rho + 1.));
  }


  StepReport GeneralizedAlpha::advance(DynamicalSystem &system, State &state, const double tau)
  {
    const Vector a = state.acceleration.size() > 0 ? state.acceleration : first_acceleration(system, state);

    // beta tau^2 times the balance, with a_new = (d - d_free)/(beta tau^2), d_free = tau v + tau^2 (1/2 - beta) a:
    // [(1 - alpha_m) M + (1 - alpha_f) beta tau^2 A] d = M [(1 - alpha_m) d_free - alpha_m beta tau^2 a] - beta tau^2 (A u - f - r)
    const double scale  = beta * tau * tau;
    Vector       d_free = state.velocity;
    d_free.sadd(tau, tau * tau * (0.5 - beta), a);
    Vector inertia = d_free;
    inertia.sadd(1. - alpha_m, -alpha_m * scale, a);
    Vector b = system.make_vector();
    system.apply_mass(b, inertia);
    b.add(-scale, state.internal_force);
    Vector load = system.make_vector();
    system.add_load(load, alpha_f, state.time);
    system.add_load(load, 1. - alpha_f, state.time + tau);
    b.add(scale, load);
    b /= 1. - alpha_m;

    const NormalGap   gap = system.normal_gap(state.displacement);
    IncrementSolution solution;
    system.solve({(1. - alpha_f) / (1. - alpha_m) * scale, b, gap, state.displacement, state.time, tau}, solution);
    const Vector &d      = solution.increment;
    const double  weight = (1. - alpha_m) / scale; // from reactions of the problem to forces
    Vector        r      = solution.contact_reaction;
    r *= weight;

    Vector a_new = d;
    a_new -= d_free;
    a_new /= scale;
    Vector velocity_change = a;
    velocity_change.sadd(tau * (1. - gamma), tau * gamma, a_new);

    StepReport report;
    report.corrector    = solution.effort;
    report.work_contact = r * d;
    report.work_support = weight * (solution.support_reaction * d);
    const State before  = state;
    state.acceleration  = std::move(a_new);
    trapezoidal_rule::finish(system, state, tau, d, velocity_change, std::move(r));

    // What the rule itself does to the energy: the mean velocity is not d/tau, and the forces are not the means of both ends.
    Vector momentum_change = state.momentum, forces = state.internal_force;
    momentum_change -= before.momentum;
    forces += before.internal_force;
    forces *= 0.5;
    Vector mean_load = system.make_vector();
    system.add_mean_load(mean_load, 1., before.time, state.time);
    forces -= mean_load;
    Vector mismatch = before.velocity;
    mismatch.add(1., state.velocity);
    mismatch.sadd(0.5, -1. / tau, d);
    report.work_scheme =
      mismatch * momentum_change + momentum_change * d / tau + forces * d - report.work_contact - report.work_support;
    return report;
  }
} // namespace signorini
