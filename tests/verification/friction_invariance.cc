// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Friction knows no directions and no units: a scene that is turned as a whole moves in the turned
// way, although the tangents of its contact nodes are others, and a scene in millimetres and tonnes
// takes the same iterations to the same statuses as the one in metres and kilograms.

#include "frictional_motion.h"
#include "frictional_scenes.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;
using dealii::Tensor;

namespace
{
  template <int dim>
  struct Run
  {
    Run(const Scene<dim>  &scene,
        const std::string &scheme,
        const double       angle,
        const double       unit_of_speed = 1.)
      : bodies(turned(scene, angle), angle == 0. ? Map<dim>() : turn<dim>(angle))
      , motion(bodies,
               scheme,
               bodies.discretization.make_vector(),
               bodies.of_first_body([&](const auto &) -> Tensor<1, dim> {
                 return unit_of_speed * (rotation<dim>(angle) * oblique_velocity<dim>());
               }))
    {
    }

    void step() { motion.step(bodies.scene.time.step_size); }

    const FrictionalBodies<dim> bodies;
    FrictionalMotion<dim>       motion;
  };

  /** Largest difference between a nodal field, turned, and another. */
  template <int dim>
  double difference(const Vector &field, const double angle, const Vector &other)
  {
    const Tensor<2, dim> matrix  = rotation<dim>(angle);
    double               largest = 0.;
    for (unsigned int first = 0; first < field.locally_owned_size(); first += dim)
      {
        Tensor<1, dim> a, b;
        for (unsigned int c = 0; c < dim; ++c)
          {
            a[c] = field.local_element(first + c);
            b[c] = other.local_element(first + c);
          }
        largest = std::max(largest, (matrix * a - b).norm());
      }
    return largest_of_all_processes(largest);
  }

  template <int dim>
  void expect_turned_motion(Scene<dim> scene, const std::string &scheme)
  {
    SCOPED_TRACE(scheme);
    scene.time.step_size *= 0.4; // so that contact lasts for 30 steps
    const double angle = 0.7;
    Run<dim>     run(scene, scheme, 0.), other(scene, scheme, angle);
    const double speed = oblique_velocity<dim>().norm();
    // A penetration of 1e-12 is accepted: nodes that touch without force, as with contact-implicit,
    // may count as open in one of the runs.
    const double step_size     = scene.time.step_size,
                 accepted      = 1e-12 * run.bodies.discretization.mesh().body_size() / step_size;
    double       largest_force = 0.;
    unsigned int n_closed      = 0;
    for (unsigned int step = 0; step < 30 || n_closed < 30; ++step)
      {
        run.step();
        other.step();
        const State &a = run.motion.state, &b = other.motion.state;
        largest_force = std::max(largest_force, a.contact_force.linfty_norm());
        EXPECT_LT(difference<dim>(a.displacement, angle, b.displacement), 1e-9 * speed * a.time)
          << step;
        EXPECT_LT(difference<dim>(a.velocity, angle, b.velocity), 1e-9 * speed + 10. * accepted)
          << step;
        EXPECT_LE(difference<dim>(a.contact_force, angle, b.contact_force), 1e-9 * largest_force)
          << step;
        EXPECT_LE(difference<dim>(a.friction.force, angle, b.friction.force), 1e-9 * largest_force)
          << step;
        EXPECT_EQ(a.friction.status, b.friction.status) << step;
        n_closed += run.motion.report.corrector.n_active > 0;
        ASSERT_LT(step, 200u);
      }
  }

  /** Millimetres, tonnes and seconds in place of metres, kilograms and seconds. */
  template <int dim>
  Scene<dim> in_millimetres(Scene<dim> scene)
  {
    for (auto &body : scene.bodies)
      {
        body.lower_corner *= 1e3;
        body.upper_corner *= 1e3;
        body.material.youngs_modulus *= 1e-6;
        body.material.density *= 1e-12;
        if (body.local_refinements > 0)
          body.refine_where =
            dim == 3 && scene.bodies.size() == 2 ? "x + 0.5*y - 1.1e3" : "0.7e3 - x - 0.4*y";
      }
    return scene;
  }

  template <int dim>
  void expect_same_iterations(const Scene<dim> &scene, const std::string &scheme)
  {
    SCOPED_TRACE(scheme);
    Run<dim>     run(scene, scheme, 0.), other(in_millimetres(scene), scheme, 0., 1e3);
    unsigned int n_closed = 0;
    for (unsigned int step = 0; step < 40; ++step)
      {
        run.step();
        other.step();
        const State &a = run.motion.state, &b = other.motion.state;
        EXPECT_EQ(a.friction.status, b.friction.status) << step;
        const SolveReport effort       = run.motion.report.corrector,
                          other_effort = other.motion.report.corrector;
        EXPECT_EQ(effort.active_set_iterations, other_effort.active_set_iterations) << step;
        EXPECT_EQ(effort.n_active, other_effort.n_active) << step;
        Vector velocity = b.velocity;
        velocity *= 1e-3;
        EXPECT_LT(difference<dim>(a.velocity, 0., velocity), 1e-9 * oblique_velocity<dim>().norm())
          << step;
        n_closed += effort.n_active;
      }
    EXPECT_GT(n_closed, 20u);
  }

  const std::vector<std::string> schemes = {"contact-stabilized",
                                            "contact-stabilized-projected",
                                            "contact-implicit"};
} // namespace

TEST(FrictionInvariance, TurnedScenes)
{
  for (const std::string &scheme : schemes)
    {
      expect_turned_motion(block_on_floor<3>(coulomb("0.3")), scheme);
      expect_turned_motion(block_on_floor<2>(coulomb("0.3")), scheme);
      expect_turned_motion(block_on_block<3>(coulomb("0.3")), scheme);
      expect_turned_motion(block_on_block<2>(coulomb("0.3")), scheme);
    }
}

TEST(FrictionInvariance, Units)
{
  for (const std::string &scheme : schemes)
    {
      expect_same_iterations(block_on_floor<3>(coulomb("0.3")), scheme);
      expect_same_iterations(block_on_floor<2>(coulomb("0.3")), scheme);
      expect_same_iterations(block_on_block<3>(coulomb("0.3")), scheme);
      expect_same_iterations(block_on_block<2>(coulomb("0.3")), scheme);
    }
}
