// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The elastic energy is u'Au/2 on every kind of mesh, and stays what it is when bodies are carried
// far away, where u'Au/2 itself has lost its digits.

#include "../discretization/bodies.h"

#include <signorini/diagnostics/body_motion.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  State displaced(const Assembled<dim> &assembled, const std::array<std::string, dim> &displacement)
  {
    State state;
    state.displacement   = field<dim>(assembled.discretization, displacement);
    state.internal_force = assembled.discretization.make_vector();
    assembled.discretization.matrices().apply_stiffness(state.internal_force, state.displacement);
    return state;
  }


  const std::array<std::string, 2> bent_2d = {{"0.01*x*y + 0.002*sin(5*x)", "0.01*x^2 - 0.003*y"}};
  const std::array<std::string, 3> bent_3d = {
    {"0.01*x*z + 0.002*sin(5*y)", "0.01*x^2 - 0.003*y", "0.02*y*z"}};


  /** Besides what bends the body, it is turned by an angle of 0.5. */
  template <int dim>
  std::array<std::string, dim> turned(std::array<std::string, dim> displacement)
  {
    displacement[0] += " - 0.5*y";
    displacement[1] += " + 0.5*x";
    return displacement;
  }


  template <int dim>
  void expect_energy(const BodyDescription<dim>         &body,
                     const CellGeometry                  geometry,
                     const std::array<std::string, dim> &displacement)
  {
    Scene<dim>             scene = scene_of<dim>({body, body});
    dealii::Tensor<1, dim> aside;
    aside[0]                  = 5.;
    scene.bodies[1].placement = Placement<dim>({}, {}, aside);
    scene.mapping             = geometry;
    const Assembled<dim> assembled(scene);
    const State          state    = displaced<dim>(assembled, displacement);
    const double         expected = 0.5 * (state.displacement * state.internal_force);
    EXPECT_GT(expected, 0.);
    EXPECT_NEAR(
      BodyMotion<dim>(assembled.discretization).elastic_energy(state), expected, 1e-12 * expected)
      << body.name << ", geometry " << static_cast<int>(geometry);
  }


  template <int dim>
  void expect_energy_far_away(const std::array<std::string, dim> &near)
  {
    const Assembled<dim>         assembled(box_with_hanging_nodes<dim>());
    const BodyMotion<dim>        motion(assembled.discretization);
    std::array<std::string, dim> far = near;
    far[0] += " + 1000 - 300*y";
    far[1] += " - 500 + 300*x";
    const double energy = motion.elastic_energy(displaced<dim>(assembled, near));
    EXPECT_NEAR(motion.elastic_energy(displaced<dim>(assembled, far)), energy, 1e-8 * energy);
  }
} // namespace

TEST(BodyMotion, ElasticEnergy2d)
{
  for (const CellGeometry geometry : {CellGeometry::linear, CellGeometry::curved})
    for (const auto &body : {box<2>(), box_with_hanging_nodes<2>(), ball<2>(1)})
      expect_energy<2>(body, geometry, turned<2>(bent_2d));
}

TEST(BodyMotion, ElasticEnergy3d)
{
  for (const CellGeometry geometry : {CellGeometry::linear, CellGeometry::curved})
    for (const auto &body : {box<3>(), box_with_hanging_nodes<3>(), ball<3>(1)})
      expect_energy<3>(body, geometry, turned<3>(bent_3d));
}

TEST(BodyMotion, ElasticEnergyFarAway)
{
  expect_energy_far_away<2>(bent_2d);
  expect_energy_far_away<3>(bent_3d);
}
