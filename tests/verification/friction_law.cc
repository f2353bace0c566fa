// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// In every step of every scheme that knows friction each contact node obeys the law: its tangential
// force does not exceed the bound, it is at the bound and along the slip where there is slip, and
// these forces are those of the equation of motion. Friction takes energy, the ledger explains
// every change of it, and two free bodies keep their momentum, because friction acts on both.

#include "frictional_motion.h"
#include "frictional_scenes.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;
using dealii::Tensor;

namespace
{
  const std::vector<std::string> schemes_with_friction = {"contact-stabilized",
                                                          "contact-stabilized-projected",
                                                          "contact-implicit",
                                                          "laursen-chawla",
                                                          "hager-hueeber-wohlmuth",
                                                          "laursen-love",
                                                          "newmark",
                                                          "backward-euler"};

  /**
   * Largest violations at the contact nodes of all processes; forces relative to the largest one
   * of the step.
   */
  struct Violations
  {
    double beyond_bound = 0., direction = 0., slip_below_bound = 0., open_nodes = 0.,
           normal_force  = 0.;
    unsigned int n_stick = 0, n_slip = 0;
  };

  template <int dim>
  Violations violations(const FrictionalMotion<dim> &motion)
  {
    const auto  &bodies = motion.bodies;
    const auto  &system = motion.system;
    const double size = bodies.discretization.mesh().body_size(), factor = system.force_factor;
    Vector       further = system.further_reaction, friction = system.solution.friction_reaction,
           total = motion.state.contact_force;
    bodies.coordinates.force_to_contact(further);
    bodies.coordinates.force_to_contact(friction);
    bodies.coordinates.force_to_contact(total);
    const auto          slips = bodies.surface.relative_tangential(system.solution.increment);
    const auto         &nodes = bodies.surface.nodes();
    std::vector<double> normal(nodes.size());
    double              largest = 0.;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const unsigned int i = bodies.coordinates.normal_entries()[k];
        normal[k] = -(system.solution.normal_reaction[k] + further.local_element(i)) / factor;
        largest   = std::max({largest, normal[k], nodes[k].friction.constant});
      }
    largest = largest_of_all_processes(largest);

    Violations result;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const bool         touched = system.bounds[k] <= 1e-10 * size;
        FrictionLaw        law     = nodes[k].friction;
        const unsigned int i       = bodies.coordinates.normal_entries()[k];
        law.constant *= touched;
        Tensor<1, dim> force;
        for (unsigned int j = 1; j < dim; ++j)
          force += friction.local_element(i + j) / factor * nodes[k].direction(j);
        const double bound = law.bound(normal[k]), slip = slips[k].norm();
        const bool   free = law.constant == 0. && normal[k] <= 0.;
        const auto   note = [&](double &worst, const double value) {
          worst = std::max(worst, value);
        };
        note(result.beyond_bound, force.norm() - bound);
        if (free)
          note(result.open_nodes, force.norm());
        else if (slip > 1e-12 * size)
          {
            note(result.direction, (force + bound / slip * slips[k]).norm());
            ++result.n_slip;
          }
        else
          ++result.n_stick;
        if (!free && force.norm() < bound - 1e-8 * largest)
          note(result.slip_below_bound, slip / size);
        note(result.normal_force, std::abs(normal[k] + total.local_element(i)));
      }
    for (double *value :
         {&result.beyond_bound, &result.direction, &result.open_nodes, &result.normal_force})
      *value = largest_of_all_processes(*value) / std::max(largest, 1e-300);
    result.slip_below_bound = largest_of_all_processes(result.slip_below_bound);
    result.n_stick          = sum_of_all_processes(result.n_stick);
    result.n_slip           = sum_of_all_processes(result.n_slip);
    return result;
  }

  /** K d - b - forces, relative to the largest force. */
  template <int dim>
  double imbalance(const FrictionalMotion<dim> &motion)
  {
    const auto &system  = motion.system;
    Vector      balance = system.make_vector(), product = balance;
    system.apply_mass(balance, system.solution.increment);
    system.apply_stiffness(product, system.solution.increment);
    balance.add(system.stiffness_factor, product);
    balance -= system.right_hand_side;
    balance -= system.solution.contact_reaction;
    const double largest = system.solution.contact_reaction.linfty_norm();
    balance -= system.solution.friction_reaction;
    return balance.linfty_norm() / std::max(largest, system.right_hand_side.linfty_norm());
  }

  template <int dim>
  void expect_law(Scene<dim>         scene,
                  const std::string &scheme,
                  const double       angle,
                  const unsigned int n_steps)
  {
    SCOPED_TRACE(scheme);
    scene.time.scheme = scheme;
    if (scheme == "hager-hueeber-wohlmuth")
      {
        scene.time.mass.kind           = MassKind::redistributed;
        scene.time.mass.redistribution = MassRedistribution::extrapolation;
      }
    const FrictionalBodies<dim> bodies(turned(scene, angle), turn<dim>(angle));
    const Tensor<1, dim>        v        = rotation<dim>(angle) * oblique_velocity<dim>();
    const Vector                velocity = bodies.of_first_body([&](const auto &) { return v; });
    FrictionalMotion<dim> motion(bodies, scheme, bodies.discretization.make_vector(), velocity);
    const double          initial_energy = motion.ledger.initial().total();
    const auto            initial        = momentum(bodies.discretization, motion.state).linear;
    const bool            two_bodies     = scene.bodies.size() == 2;
    unsigned int          n_stick = 0, n_slip = 0, n_fallbacks = 0;
    double                work = 0.;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        motion.step(scene.time.step_size);
        const Violations wrong = violations(motion);
        EXPECT_LT(wrong.beyond_bound, 1e-8) << step;
        EXPECT_LT(wrong.direction, 1e-8) << step;
        EXPECT_LT(wrong.slip_below_bound, 1e-12) << step;
        EXPECT_EQ(wrong.open_nodes, 0.) << step;
        EXPECT_LT(imbalance(motion), 1e-8) << step;
        EXPECT_LT(std::abs(motion.booking.residual), 1e-10 * initial_energy) << step;
        if (scheme != "laursen-love") // whose impulses come on top
          {
            EXPECT_LT(wrong.normal_force, scheme == "contact-stabilized-projected" ? 1e-3 : 1e-8)
              << step;
          }
        if (scheme != "newmark") // half of its friction belongs to the slip of the step before
          {
            EXPECT_LE(motion.report.work_friction, 1e-13 * initial_energy) << step;
          }
        if (two_bodies)
          {
            const auto   now   = momentum(bodies.discretization, motion.state).linear;
            const double scale = v.norm() * total_mass(bodies.discretization);
            for (unsigned int c = 0; c < dim; ++c)
              EXPECT_NEAR(now[c], initial[c], 1e-11 * scale) << step;
          }
        n_fallbacks += motion.report.corrector.n_fallbacks;
        n_stick += wrong.n_stick;
        n_slip += wrong.n_slip;
        work += motion.report.work_friction;
      }
    EXPECT_LE(n_fallbacks, 1u);
    EXPECT_GT(n_stick, 4u);
    EXPECT_GT(n_slip, 4u);
    EXPECT_TRUE(work < -1e-4 * initial_energy || scheme == "newmark");
  }

  template <int dim>
  void expect_law_of_all_schemes(const Scene<dim> &scene, const unsigned int n_steps)
  {
    for (const std::string &scheme : schemes_with_friction)
      expect_law(scene, scheme, 0.7, n_steps);
  }
} // namespace

TEST(FrictionLaw, BlockOnFloorIn2d)
{
  expect_law_of_all_schemes(block_on_floor<2>(coulomb("0.3")), 60);
}

TEST(FrictionLaw, BlockOnFloorIn3dWithHangingNodes)
{
  expect_law_of_all_schemes(block_on_floor<3>(coulomb("0.3")), 40);
}

TEST(FrictionLaw, BlocksIn2d)
{
  expect_law_of_all_schemes(block_on_block<2>(coulomb("0.3")), 60);
}

TEST(FrictionLaw, BlocksIn3dWithHangingNodes)
{
  expect_law_of_all_schemes(block_on_block<3>(coulomb("0.3")), 30);
}

// The law is one of nodes, whatever the stiffness.
TEST(FrictionLaw, WithEnhancedElements)
{
  Scene<2> blocks = block_on_block<2>(coulomb("0.3"));
  Scene<3> block  = block_on_floor<3>(coulomb("0.3"));
  for (BodyDescription<2> &body : blocks.bodies)
    body.element = ElementKind::enhanced;
  block.bodies[0].element = ElementKind::enhanced;
  expect_law_of_all_schemes(blocks, 60);
  expect_law_of_all_schemes(block, 40);
}

TEST(FrictionLaw, Cap)
{
  for (const std::string scheme : {"contact-stabilized", "contact-implicit"})
    {
      expect_law(block_on_floor<2>(coulomb("0.5", "5")), scheme, 0.7, 60);
      expect_law(block_on_floor<3>(coulomb("0.5", "5")), scheme, 0.7, 40);
      expect_law(block_on_block<2>(coulomb("0.5", "5")), scheme, 0.7, 60);
    }
}

TEST(FrictionLaw, Tresca)
{
  for (const std::string scheme : {"contact-stabilized", "contact-implicit"})
    {
      expect_law(block_on_floor<2>(tresca("3")), scheme, 0.7, 60);
      expect_law(block_on_floor<3>(tresca("3")), scheme, 0.7, 40);
      expect_law(block_on_block<2>(tresca("3")), scheme, 0.7, 60);
    }
}
