// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Contact-stabilized steps with friction, projected or not, never gain energy, whatever falls on
// the floor and however large the steps: contact, predictor, friction and the stop of sticking
// nodes each take some. Ten thousand blocks are thrown with random shapes, materials, velocities,
// spins, coefficients of friction and Courant numbers. On the way Newton's method shows that it
// hardly ever needs its fallback, and few iterations.

#include "frictional_motion.h"
#include "frictional_scenes.h"

#include <gtest/gtest.h>

#include <random>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr unsigned int n_steps_per_throw = 5;

  class Throws
  {
  public:
    explicit Throws(const unsigned int seed)
      : generator(seed)
    {
    }

    double between(const double low, const double high)
    {
      return std::uniform_real_distribution<double>(low, high)(generator);
    }

    template <int dim>
    Tensor<1, dim> vector()
    {
      Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = between(-1., 1.);
      return result;
    }

    /** A block that stands on the floor. */
    template <int dim>
    Scene<dim> scene()
    {
      auto body = block<dim>("block", {}, {}, {});
      for (unsigned int c = 0; c < dim; ++c)
        {
          box_of(body).upper_corner[c] = between(0.6, 1.6);
          box_of(body).repetitions[c]  = dim == 2 || c < 2 ? 2 : 1;
        }
      box_of(body).repetitions[0] += between(0., 1.) < 0.5 ? 1 : 0;
      body.material.poissons_ratio = between(0., 0.45);
      Scene<dim> scene = contact_scene<dim>(body, {floor_at<dim>(0.)}, {bottom_id<dim>});
      set_step(scene, 1., coulomb(std::to_string(between(0., 2.))));
      return scene;
    }

  private:
    std::mt19937 generator;
  };

  struct Statistics
  {
    unsigned int n_throws = 0, n_contact = 0, n_fallbacks = 0, n_iterations = 0,
                 most_iterations = 0, n_stick = 0, n_slip = 0;
    double gain = 0., residual = 0., loss = 0.;
  };

  /** The block flies or starts from the floor, as a rigid body or not. */
  template <int dim>
  void throw_once(const FrictionalBodies<dim> &bodies,
                  const std::string           &scheme,
                  Throws                      &random,
                  Statistics                  &statistics)
  {
    const double step_size =
      random.between(0.3, 10.) / bodies.discretization.mesh().courant_number(1.);
    const double   speed           = std::exp(random.between(-4., 1.));
    Tensor<1, dim> v               = speed * random.vector<dim>();
    v[dim - 1]                     = -std::abs(v[dim - 1]);
    const Tensor<1, dim> spin      = speed * random.vector<dim>();
    const double         irregular = random.between(0., 1.) < 0.5 ? 0. : 0.5 * speed;
    const double         height =
      random.between(0., 1.) < 0.5 ? 0. : random.between(0., 2.) * std::abs(v[dim - 1]) * step_size;

    const Vector displacement = bodies.of_first_body([&](const auto &) {
      Tensor<1, dim> up;
      up[dim - 1] = height;
      return up;
    });
    const Vector velocity     = bodies.of_first_body([&](const Point<dim> &p) {
      Tensor<1, dim> motion = v + irregular * random.vector<dim>();
      for (unsigned int a = 0; a < dim; ++a)
        {
          const unsigned int b = (a + 1) % dim;
          motion[a] += spin[a] * p[b];
          motion[b] -= spin[a] * p[a];
          if (dim == 2)
            break;
        }
      return motion;
    });

    FrictionalMotion<dim> motion(bodies, scheme, displacement, velocity);
    const double          initial_energy = motion.ledger.initial().total();
    ++statistics.n_throws;
    for (unsigned int step = 0; step < n_steps_per_throw; ++step)
      {
        ASSERT_NO_THROW(motion.step(step_size))
          << "throw " << statistics.n_throws << ", step " << step;
        statistics.gain = std::max(statistics.gain, motion.energy_change / initial_energy);
        statistics.residual =
          std::max(statistics.residual, std::abs(motion.booking.residual) / initial_energy);
        statistics.loss = std::max(statistics.loss, -motion.report.work_friction / initial_energy);
        if (motion.report.corrector.n_active == 0)
          continue;
        ++statistics.n_contact;
        const unsigned int n = motion.report.corrector.active_set_iterations;
        statistics.n_fallbacks += motion.report.corrector.n_fallbacks;
        statistics.n_iterations += n;
        statistics.most_iterations = std::max(statistics.most_iterations, n);
        for (const char status : motion.state.friction.status)
          {
            statistics.n_stick += contact_status::sticks(status);
            statistics.n_slip += status == contact_status::slip;
          }
      }
  }

  template <int dim>
  void expect_no_gain(const std::string &scheme,
                      const unsigned int n_scenes,
                      const unsigned int n_throws_per_scene)
  {
    Throws     random(dim);
    Statistics statistics;
    for (unsigned int scene = 0; scene < n_scenes; ++scene)
      {
        const FrictionalBodies<dim> bodies(random.scene<dim>());
        for (unsigned int n = 0; n < n_throws_per_scene; ++n)
          throw_once(bodies, scheme, random, statistics);
      }
    EXPECT_LT(statistics.gain, 1e-12);
    EXPECT_LT(statistics.residual, 1e-11);
    EXPECT_GT(statistics.loss, 0.1);
    EXPECT_GT(statistics.n_contact, statistics.n_throws * n_steps_per_throw / 4);
    EXPECT_LT(statistics.n_fallbacks, 0.01 * statistics.n_contact);
    EXPECT_LT(statistics.n_iterations, 10. * statistics.n_contact);
    EXPECT_GT(statistics.n_stick, statistics.n_contact / 4);
    EXPECT_GT(statistics.n_slip, statistics.n_contact / 4);
    std::cout << dim << "d, " << scheme << ": " << statistics.n_throws << " throws, "
              << statistics.n_contact << " steps with contact, iterations "
              << 1. * statistics.n_iterations / statistics.n_contact << " in the mean, "
              << statistics.most_iterations << " at most, " << statistics.n_fallbacks
              << " fallbacks, largest gain " << statistics.gain << std::endl;
  }
} // namespace

TEST(FrictionEnergy, ThousandsOfThrowsIn2d)
{
  expect_no_gain<2>("contact-stabilized", 100, 50);
}

TEST(FrictionEnergy, ThousandsOfThrowsIn3d)
{
  expect_no_gain<3>("contact-stabilized", 100, 50);
}

TEST(FrictionEnergy, Projected)
{
  expect_no_gain<2>("contact-stabilized-projected", 20, 50);
  expect_no_gain<3>("contact-stabilized-projected", 20, 50);
}
