// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Without contact all schemes are the trapezoidal rule, second order in space and time: for
// standing waves, whose exact solution is known, halving cells and steps together divides the
// errors of displacement and velocity by four, and energy is conserved.

#include "../discretization/bodies.h"

#include <signorini/diagnostics/error_norms.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/meshed_scene.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /**
   * Longitudinal standing wave in a free bar of length 2 with nu = 0, so that it is exact in two
   * dimensions, too; c = 3.
   */
  Scene<2> standing_wave(const unsigned int n_cells, const double step_size)
  {
    BodyDescription<2> bar;
    bar.name                 = "bar";
    box_of(bar).upper_corner = dealii::Point<2>(2., 0.25);
    box_of(bar).repetitions  = {{n_cells, 1}};
    bar.material             = {18., 0., 2.};
    bar.initial_displacement = {{"cos(pi*x/2)", "0"}};
    Scene<2> scene           = scene_of<2>({bar});
    scene.time.step_size     = step_size;
    scene.exact_solution     = {
          true, {{"cos(pi*x/2)*cos(1.5*pi*t)", "0"}}, {{"-1.5*pi*cos(pi*x/2)*sin(1.5*pi*t)", "0"}}};
    return scene;
  }

  /** Shear wave between clamped sides, in a strip that is held in y; c = sqrt(mu / rho) = 2. */
  Scene<2> shear_wave(const unsigned int n_cells, const double step_size)
  {
    BodyDescription<2> strip;
    strip.name                 = "strip";
    box_of(strip).upper_corner = dealii::Point<2>(0.25, 1.);
    box_of(strip).repetitions  = {{1, n_cells}};
    strip.material             = {10.4, 0.3, 1.};
    strip.initial_velocity     = {{"2*pi*sin(pi*y)", "0"}};
    strip.dirichlet = {{2, {{"0", "0"}}}, {3, {{"0", "0"}}}, {0, {{"-", "0"}}}, {1, {{"-", "0"}}}};
    Scene<2> scene  = scene_of<2>({strip});
    scene.time.step_size = step_size;
    scene.exact_solution = {
      true, {{"sin(pi*y)*sin(2*pi*t)", "0"}}, {{"2*pi*sin(pi*y)*cos(2*pi*t)", "0"}}};
    return scene;
  }

  struct Outcome
  {
    ErrorNorms errors;             ///< at the end
    double     energy_change = 0.; ///< relative, the largest
  };

  Outcome run(const Scene<2> &scene, const std::string &scheme_name, const unsigned int n_steps)
  {
    Assembled<2>                 assembled(scene);
    auto                        &discretization = assembled.discretization;
    const DirichletConditions<2> dirichlet(discretization);
    const ContactSurface<2>      surface(discretization, dirichlet, scene.obstacles, scene.pairs);
    const ContactCoordinates<2>  coordinates(discretization, surface, dirichlet);
    Loads<2>                     loads(discretization);
    dealii::TimerOutput          timer(
      std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times);
    ElasticContactSystem<2> system(
      discretization, surface, coordinates, loads, system_parameters(scene), timer);

    State state;
    state.displacement   = field<2>(discretization, scene.bodies[0].initial_displacement);
    state.velocity       = field<2>(discretization, scene.bodies[0].initial_velocity);
    state.contact_force  = discretization.make_vector();
    state.momentum       = mass_times(discretization, state.velocity);
    state.internal_force = stiffness_times(discretization, state.displacement);
    const auto energy    = [&] {
      return 0.5 * (state.velocity * state.momentum + state.displacement * state.internal_force);
    };
    const double initial_energy = energy();
    system.see({initial_energy, initial_energy});

    Outcome    outcome;
    const auto scheme = make_time_scheme(scheme_name);
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        scheme->advance(system, state, scene.time.step_size);
        outcome.energy_change =
          std::max(outcome.energy_change, std::abs(energy() / initial_energy - 1.));
      }
    outcome.errors = ErrorEvaluation<2>(scene.exact_solution).evaluate(discretization, state, 0.);
    return outcome;
  }

  /**
   * Cells and steps halved together three times, at Courant numbers 1.5 and 2, where the errors of
   * space and time do not cancel; the end is at 13/16, no moment of symmetry.
   */
  template <typename MakeScene>
  void expect_second_order(const MakeScene &make_scene, const std::string &scheme)
  {
    std::vector<ErrorNorms> errors;
    for (const unsigned int n : {16, 32, 64, 128})
      {
        const Outcome outcome = run(make_scene(n, 1. / n), scheme, 13 * n / 16);
        EXPECT_LT(outcome.energy_change, 1e-10) << n;
        errors.push_back(outcome.errors);
      }
    EXPECT_LT(errors.back().displacement, 2e-2 * errors.back().displacement_norm);
    for (unsigned int k = 1; k < errors.size(); ++k)
      {
        EXPECT_NEAR(errors[k - 1].displacement / errors[k].displacement, 4., 0.3)
          << scheme << " " << k;
        EXPECT_NEAR(errors[k - 1].velocity / errors[k].velocity, 4., 0.3) << scheme << " " << k;
      }
  }
} // namespace

TEST(FreeElastodynamics, StandingWaveIsSecondOrder)
{
  for (const char *scheme : {"newmark", "contact-implicit", "contact-stabilized"})
    expect_second_order(standing_wave, scheme);
}

TEST(FreeElastodynamics, ShearWaveBetweenDirichletConditionsIsSecondOrder)
{
  expect_second_order(shear_wave, "contact-stabilized");
}

TEST(FreeElastodynamics, SchemesDifferOnlyInContact)
{
  const Scene<2> scene    = standing_wave(16, 1. / 32.);
  const double   expected = run(scene, "newmark", 20).errors.displacement;
  EXPECT_GT(expected, 1e-6);
  for (const char *scheme : {"contact-implicit", "contact-stabilized"})
    EXPECT_NEAR(run(scene, scheme, 20).errors.displacement, expected, 1e-9 * expected) << scheme;
}
