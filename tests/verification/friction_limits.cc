// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Friction between its limits: with a bound of zero the frictional solver gives the motion without
// friction, though it goes other ways; with a huge coefficient closed nodes are glued, and the
// motion is that of bodies whose closed nodes are held in all directions.

#include "frictional_motion.h"
#include "frictional_scenes.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  struct LimitRun
  {
    LimitRun(const Scene<dim> &scene, const std::string &scheme)
      : bodies(scene)
      , motion(bodies,
               scheme,
               bodies.discretization.make_vector(),
               bodies.of_first_body([](const auto &) { return oblique_velocity<dim>(); }))
    {
    }

    void step() { motion.step(bodies.scene.time.step_size); }

    const FrictionalBodies<dim> bodies;
    FrictionalMotion<dim>       motion;
  };

  double difference(const Vector &a, const Vector &b)
  {
    Vector result = a;
    result -= b;
    return result.linfty_norm();
  }

  template <int dim>
  void
  expect_same_motion(Scene<dim> scene, const FrictionDescription &other, const std::string &scheme)
  {
    SCOPED_TRACE(scheme);
    LimitRun<dim> run(scene, scheme);
    scene.pairs[0].friction = other;
    LimitRun<dim> other_run(scene, scheme);
    const double  speed         = oblique_velocity<dim>().norm();
    unsigned int  n_closed      = 0;
    double        largest_force = 0.;
    for (unsigned int step = 0; step < 40; ++step)
      {
        run.step();
        other_run.step();
        const State &a = run.motion.state, &b = other_run.motion.state;
        EXPECT_LT(difference(a.displacement, b.displacement), 1e-9 * speed * a.time) << step;
        EXPECT_LT(difference(a.velocity, b.velocity), 1e-9 * speed) << step;
        largest_force = std::max(largest_force, a.contact_force.linfty_norm());
        EXPECT_LE(difference(a.contact_force, b.contact_force), 1e-9 * largest_force) << step;
        EXPECT_EQ(run.motion.report.corrector.n_active, other_run.motion.report.corrector.n_active)
          << step;
        n_closed += run.motion.report.corrector.n_active;
      }
    EXPECT_GT(n_closed, 20u);
  }

  template <int dim>
  void expect_glue(const Scene<dim> &scene, const std::string &scheme)
  {
    SCOPED_TRACE(scheme);
    LimitRun<dim> run(scene, scheme);
    unsigned int  n_stick = 0;
    for (unsigned int step = 0; step < 40; ++step)
      {
        run.step();
        const auto &solution = run.motion.system.solution;
        const auto  slips    = run.bodies.surface.relative_tangential(solution.increment);
        for (unsigned int k = 0; k < slips.size(); ++k)
          if (contact_status::is_closed(solution.status[k]))
            {
              EXPECT_EQ(solution.status[k], contact_status::stick) << step;
              EXPECT_LT(slips[k].norm(), 1e-14) << step;
              ++n_stick;
            }
        EXPECT_LT(std::abs(run.motion.booking.residual),
                  1e-10 * run.motion.ledger.initial().total())
          << step;
        EXPECT_FALSE(run.motion.report.corrector.n_fallbacks) << step;
      }
    EXPECT_GT(sum_of_all_processes(n_stick), 20u);
  }

  // Not those that magnify round-off: newmark oscillates, laursen-love gives impulses along forces
  // that may be next to nothing.
  const std::vector<std::string> schemes_with_limits = {"contact-stabilized",
                                                        "contact-stabilized-projected",
                                                        "contact-implicit",
                                                        "laursen-chawla",
                                                        "backward-euler"};
  const FrictionDescription      frictionless = {}, no_bound = coulomb("0.5", "0");
} // namespace

TEST(FrictionLimits, ABoundOfZeroIsNoFriction)
{
  for (const std::string &scheme : schemes_with_limits)
    {
      expect_same_motion(block_on_floor<2>(frictionless), no_bound, scheme);
      expect_same_motion(block_on_floor<3>(frictionless), no_bound, scheme);
      expect_same_motion(block_on_block<2>(frictionless), no_bound, scheme);
      expect_same_motion(block_on_block<3>(frictionless), no_bound, scheme);
    }
}

TEST(FrictionLimits, AVanishingCoefficientIsNoFriction)
{
  for (const std::string &scheme : schemes_with_limits)
    {
      expect_same_motion(block_on_floor<3>(frictionless), coulomb("1e-13"), scheme);
      expect_same_motion(block_on_block<2>(frictionless), coulomb("1e-13"), scheme);
    }
}

TEST(FrictionLimits, HugeFrictionIsGlue)
{
  // Not a matter of course: a node that pulls where it sticks and penetrates where it is open slips
  // under next to no normal force, however large the coefficient. With laursen-chawla one of these
  // nodes does.
  for (const std::string &scheme : schemes_with_limits)
    {
      if (scheme == "laursen-chawla")
        continue;
      expect_glue(block_on_floor<2>(coulomb("1e6")), scheme);
      expect_glue(block_on_floor<3>(coulomb("1e6")), scheme);
      expect_glue(block_on_block<2>(coulomb("1e6")), scheme);
      expect_glue(block_on_block<3>(coulomb("1e6")), scheme);
      if (scheme != "contact-stabilized-projected") // a projection that hardly presses holds better
                                                    // with 1e6
        expect_same_motion(block_on_floor<3>(coulomb("1e6")), coulomb("1e5"), scheme);
    }
}
