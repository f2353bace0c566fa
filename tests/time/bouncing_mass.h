// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_bouncing_mass_h
#define signorini_tests_bouncing_mass_h

// One mass, perhaps on a spring, and a wall: every inequality has a closed solution.

#include <signorini/schemes/scheme_table.h>

#include <functional>
#include <limits>

namespace signorini
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  /** A mass on a spring in front of a wall, under a load: all that a system has to be able to do.
   */
  class MassOnSpring : public DynamicalSystem
  {
  public:
    double                        mass   = 1.;
    double                        spring = 0.;
    double                        wall   = infinity; ///< largest displacement
    std::function<double(double)> load   = [](double) { return 0.; };

    Vector make_vector() const override { return Vector(1); }
    void   apply_mass(Vector &destination, const Vector &source) const override
    {
      destination.equ(mass, source);
    }
    void apply_stiffness(Vector &destination, const Vector &source) const override
    {
      destination.equ(spring, source);
    }
    void add_load(Vector &destination, double factor, double time) override
    {
      destination(0) += factor * load(time);
    }
    double length() const override { return 1.; }

    NormalGap normal_gap(const Vector &displacement) const override
    {
      return {wall - displacement(0)};
    }
    NormalGap relative_normal(const Vector &motion) const override { return {motion(0)}; }
    NormalGap own_normal_forces(const Vector &forces) const override { return {forces(0)}; }

    Vector solve_mass(const Vector &force) override
    {
      Vector result = force;
      result /= mass;
      return result;
    }

    void solve(const IncrementProblem &problem, IncrementSolution &solution) override
    {
      const double K = mass + problem.stiffness_factor * spring;
      find_increment(K, problem.right_hand_side(0) / K, problem.bounds[0], solution);
    }

  protected:
    void find_increment(const double       K,
                        const double       free,
                        const double       bound,
                        IncrementSolution &solution) const
    {
      solution.increment = solution.contact_reaction = solution.dirichlet_reaction = make_vector();
      solution.increment(0)        = std::min(free, bound);
      solution.contact_reaction(0) = K * (solution.increment(0) - free);
      solution.normal_reaction     = {solution.contact_reaction(0)};
      solution.effort.n_active     = free > bound;
    }
  };


  /** The same with what schemes with a predictor, with impulses or without inertia need. */
  class BouncingMass : public MassOnSpring,
                       protected MassProjections,
                       protected NodalImpulses,
                       protected StaticProblems
  {
  public:
    Capabilities capabilities() override { return {this, this, nullptr, nullptr, nullptr, this}; }

  protected:
    Vector normal_forces(const std::vector<double> &forces) const override
    {
      Vector result = make_vector();
      result(0)     = forces[0];
      return result;
    }

    /** Without a spring, a force takes the mass to the wall. */
    void equilibrate(const LoadStep &step, IncrementSolution &solution) override
    {
      const double force = step.force(0);
      find_increment(spring,
                     spring > 0.  ? force / spring
                     : force > 0. ? infinity
                                  : 0.,
                     step.bounds[0],
                     solution);
      if (spring == 0.)
        solution.contact_reaction(0) = -force;
    }

    SolveReport project(const Vector    &free_increment,
                        const NormalGap &bounds,
                        double,
                        Vector &correction,
                        Vector &mass_correction) override
    {
      correction = mass_correction = make_vector();
      correction(0)                = std::min(0., bounds[0] - free_increment(0));
      mass_correction(0)           = mass * correction(0);
      SolveReport effort;
      effort.n_active = correction(0) < 0.;
      return effort;
    }

    SolveReport stop_relative_motion(const Vector    &velocity,
                                     const ActiveSet &held,
                                     Vector          &correction,
                                     Vector          &mass_correction) override
    {
      correction = mass_correction = make_vector();
      correction(0)                = held[0] ? -velocity(0) : 0.;
      mass_correction(0)           = mass * correction(0);
      SolveReport effort;
      effort.n_active = held[0] != contact_status::open;
      return effort;
    }
  };

  /** All but the reference integration, which makes steps of its own and needs massless nodes. */
  inline std::vector<std::string> schemes_with_steps()
  {
    return schemes_where([](const SchemeInfo &info) { return info.own_tolerance.empty(); });
  }

  /** Those of them in which masses move. */
  inline std::vector<std::string> schemes_of_motion()
  {
    return schemes_where(
      [](const SchemeInfo &info) { return info.own_tolerance.empty() && info.inertia; });
  }

  /** The complete state of given displacement and velocity. */
  inline State
  make_state(const DynamicalSystem &system, const Vector &displacement, const Vector &velocity)
  {
    State state;
    state.displacement   = displacement;
    state.velocity       = velocity;
    state.contact_force  = system.make_vector();
    state.momentum       = system.make_vector();
    state.internal_force = system.make_vector();
    system.apply_mass(state.momentum, velocity);
    system.apply_stiffness(state.internal_force, displacement);
    return state;
  }

  inline State
  make_state(const MassOnSpring &system, const double displacement, const double velocity)
  {
    Vector u(1), v(1);
    u = displacement;
    v = velocity;
    return make_state(system, u, v);
  }

  /** Kinetic and elastic energy, from displacement and velocity alone. */
  inline double energy(const DynamicalSystem &system, const State &state)
  {
    Vector Mv = system.make_vector(), Au = system.make_vector();
    system.apply_mass(Mv, state.velocity);
    system.apply_stiffness(Au, state.displacement);
    return (state.velocity * Mv + state.displacement * Au) / 2.;
  }
} // namespace signorini

#endif
