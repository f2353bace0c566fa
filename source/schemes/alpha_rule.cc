// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/alpha_rule.h>

namespace signorini
{
  AlphaRule::AlphaRule(const double alpha_m, const double alpha_f)
    : alpha_m(alpha_m)
    , alpha_f(alpha_f)
    , beta((1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f) / 4.)
    , gamma(0.5 - alpha_m + alpha_f)
  {
  }


  AlphaRule AlphaRule::with_spectral_radius(const double rho)
  {
    return AlphaRule((2. * rho - 1.) / (rho + 1.), rho / (rho + 1.));
  }


  Vector
  AlphaRule::free_increment(const State &state, const Vector &acceleration, const double tau) const
  {
    Vector result = state.velocity;
    result.sadd(tau, tau * tau * (0.5 - beta), acceleration);
    return result;
  }


  Vector AlphaRule::velocity_change(const Vector &acceleration,
                                    const Vector &new_acceleration,
                                    const double  tau) const
  {
    Vector result = acceleration;
    result.sadd(tau * (1. - gamma), tau * gamma, new_acceleration);
    return result;
  }


  Vector AlphaRule::right_hand_side(DynamicalSystem &system,
                                    const State     &state,
                                    const Vector    &acceleration,
                                    const Vector    &free_increment,
                                    const double     tau) const
  {
    // beta tau^2 times the balance, with a_new = (d - d_free)/(beta tau^2):
    // [(1 - alpha_m) M + (1 - alpha_f) beta tau^2 A] d = M [(1 - alpha_m) d_free - alpha_m beta
    // tau^2 a] - beta tau^2 (A u - f)
    const double scale   = beta * tau * tau;
    Vector       inertia = free_increment;
    inertia.sadd(1. - alpha_m, -alpha_m * scale, acceleration);
    Vector b = system.make_vector();
    system.apply_mass(b, inertia);
    b.add(-scale, state.internal_force);
    Vector load = system.make_vector();
    system.add_load(load, alpha_f, state.time);
    system.add_load(load, 1. - alpha_f, state.time + tau);
    b.add(scale, load);
    b /= 1. - alpha_m;
    return b;
  }


  double AlphaRule::stiffness_factor(const double tau) const
  {
    return (1. - alpha_f) / (1. - alpha_m) * beta * tau * tau;
  }


  double AlphaRule::reaction_weight(const double tau) const
  {
    return (1. - alpha_m) / (beta * tau * tau);
  }


  double AlphaRule::work(DynamicalSystem &system,
                         const State     &before,
                         const State     &after,
                         const Vector    &acceleration,
                         const Vector    &increment) const
  {
    const double tau    = after.time - before.time;
    Vector       change = after.acceleration; // a_new - a
    change -= acceleration;
    Vector momentum_change = after.momentum;
    momentum_change -= before.momentum;

    // M (a_new - a) + A d - (f_new - f)
    Vector forces = system.make_vector();
    system.apply_mass(forces, change);
    forces += after.internal_force;
    forces -= before.internal_force;
    Vector load_change = system.make_vector();
    system.add_load(load_change, 1., after.time);
    system.add_load(load_change, -1., before.time);
    forces -= load_change;
    return (alpha_f - 0.5) * (forces * increment)
           - (beta - gamma / 2.) * tau * (change * momentum_change);
  }
} // namespace signorini
