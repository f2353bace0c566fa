// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Friction knows no directions and no units: a scene that is turned as a whole moves in the turned
// way, although the tangents of its contact nodes are others, and a scene in other units takes the
// same iterations to the same statuses. The units are powers of two, so that there is no round-off:
// what differs depends on the units.

#include "frictional_motion.h"
#include "frictional_scenes.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;
using dealii::Tensor;

namespace
{
  constexpr double coefficient = 0.3;

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

  /**
   * Contact nodes do the same in both runs, but for those at the edge between two statuses: without
   * force, or with friction at its bound, within the accepted force.
   */
  template <int dim>
  void expect_same_status(const Run<dim> &run, const Run<dim> &other, const double accepted)
  {
    const State &a = run.motion.state, &b = other.motion.state;
    const auto   normal = run.bodies.surface.relative_normal(a.contact_force);
    for (unsigned int k = 0; k < normal.size(); ++k)
      if (a.friction.status[k] != b.friction.status[k])
        {
          Tensor<1, dim> tangential;
          for (unsigned int c = 0; c < dim; ++c)
            tangential[c] =
              a.friction.force.local_element(dim * run.bodies.surface.nodes()[k].node + c);
          const double bound = coefficient * std::max(0., -normal[k]);
          EXPECT_TRUE(bound <= accepted || std::abs(tangential.norm() - bound) <= accepted)
            << "node " << k << " at step " << a.step << ": normal force " << normal[k]
            << ", friction " << tangential;
        }
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
        expect_same_status(run, other, 1e-9 * largest_force);
        n_closed += run.motion.report.corrector.n_active > 0;
        ASSERT_LT(step, 200u);
      }
  }

  /** A unit of length close to a millimetre, one of mass close to a tonne, and the same seconds. */
  constexpr double per_metre = 1024., per_kilogram = 1. / 1024.;

  template <int dim>
  Scene<dim> in_small_units(Scene<dim> scene)
  {
    for (auto &body : scene.bodies)
      {
        box_of(body).lower_corner *= per_metre;
        box_of(body).upper_corner *= per_metre;
        body.material.youngs_modulus *= per_kilogram / per_metre;
        body.material.density *= per_kilogram / (per_metre * per_metre * per_metre);
        if (body.local_refinements > 0)
          body.refine_where =
            dim == 3 && scene.bodies.size() == 2 ? "x + 0.5*y - 1.1*1024" : "0.7*1024 - x - 0.4*y";
      }
    return scene;
  }

  template <int dim>
  void expect_same_iterations(const Scene<dim> &scene, const std::string &scheme)
  {
    SCOPED_TRACE(scheme);
    Run<dim>     run(scene, scheme, 0.), other(in_small_units(scene), scheme, 0., per_metre);
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
        velocity /= per_metre;
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
      expect_turned_motion(block_on_floor<3>(coulomb(std::to_string(coefficient))), scheme);
      expect_turned_motion(block_on_floor<2>(coulomb(std::to_string(coefficient))), scheme);
      expect_turned_motion(block_on_block<3>(coulomb(std::to_string(coefficient))), scheme);
      expect_turned_motion(block_on_block<2>(coulomb(std::to_string(coefficient))), scheme);
    }
}

TEST(FrictionInvariance, Units)
{
  for (const std::string &scheme : schemes)
    {
      expect_same_iterations(block_on_floor<3>(coulomb(std::to_string(coefficient))), scheme);
      expect_same_iterations(block_on_floor<2>(coulomb(std::to_string(coefficient))), scheme);
      expect_same_iterations(block_on_block<3>(coulomb(std::to_string(coefficient))), scheme);
      expect_same_iterations(block_on_block<2>(coulomb(std::to_string(coefficient))), scheme);
    }
}
