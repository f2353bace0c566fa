// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Static equilibria. A clamped beam needs one solution, of a number of products that neither its
// length nor its mesh increases. A block on a floor is held by contact, which bears its weight;
// what is pushed along the floor is not held, and its motion is named. Bodies of any mass are
// judged alike.

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/static_equilibrium.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace static_equilibrium_tests
{
  template <int dim>
  struct StaticScene : public ContactProblem<dim>
  {
    explicit StaticScene(const Scene<dim> &scene)
      : ContactProblem<dim>(scene)
      , coordinates(this->discretization, this->surface, this->dirichlet)
      , equilibrium(this->discretization, coordinates, scene.solver, false)
      , force(this->discretization.make_vector())
    {
    }

    /** With the weight of an acceleration. */
    StaticSolution solve(const std::array<std::string, dim> &acceleration)
    {
      const std::vector<std::array<std::string, dim>> all(this->scene.bodies.size(), acceleration);
      const auto                                     &matrices = this->discretization.matrices();
      matrices.apply_mass(force, this->discretization.interpolate(all));
      const NormalGap           gap = this->surface.normal_gap(this->discretization.make_vector());
      const std::vector<double> prescribed = coordinates.dirichlet_values(0.);
      const unsigned long       before     = matrices.products().stiffness;
      const StaticSolution      solution   = equilibrium.find_held(
        {force, gap, prescribed, {}}, ActiveSet(gap.size(), contact_status::open));
      n_products = matrices.products().stiffness - before;
      return solution;
    }

    const ContactCoordinates<dim> coordinates;
    StaticEquilibrium<dim>        equilibrium;
    Vector                        force;
    unsigned long                 n_products = 0;
  };

  template <int dim>
  BodyDescription<dim>
  long_block(const double length, const unsigned int height_in_cells, const double density = 1.)
  {
    dealii::Point<dim> lower, upper;
    upper[0] = length;
    std::array<unsigned int, dim> repetitions;
    repetitions[0] = static_cast<unsigned int>(length) * height_in_cells;
    for (unsigned int c = 1; c < dim; ++c)
      {
        upper[c]       = 1.;
        repetitions[c] = height_in_cells;
      }
    BodyDescription<dim> body = block<dim>("block", lower, upper, repetitions);
    body.material.density     = density;
    return body;
  }

  template <int dim>
  void expect_few_products(const double length, const unsigned int height_in_cells)
  {
    SCOPED_TRACE(testing::Message()
                 << dim << "d, length " << length << ", " << height_in_cells << " cells");
    BodyDescription<dim>         body = long_block<dim>(length, height_in_cells);
    std::array<std::string, dim> down;
    down.fill("0");
    body.dirichlet.push_back({0, {down}});
    down[dim - 1] = "-1e-6";
    StaticScene<dim>     scene(scene_of<dim>({body}));
    const StaticSolution solution = scene.solve(down);
    EXPECT_EQ(solution.n_steps, 1u);
    EXPECT_TRUE(solution.is_held);
    EXPECT_LT(scene.n_products, 45u);

    Vector residual = stiffness_times(scene.discretization, solution.increment);
    residual -= scene.force;
    for (const unsigned int i : scene.coordinates.dirichlet_entries())
      residual.local_element(i) = 0.;
    const double round_off =
      1e-12 * body.material.youngs_modulus * solution.increment.linfty_norm();
    EXPECT_LT(residual.linfty_norm(), std::max(1e-8 * scene.force.linfty_norm(), round_off));
  }

  TEST(StaticEquilibria, CostTheSameWhateverTheMeshAndTheLength)
  {
    for (const double length : {3., 30., 100.})
      expect_few_products<2>(length, 4);
    for (const unsigned int cells : {2, 8, 16})
      expect_few_products<2>(10., cells);
    expect_few_products<3>(3., 2);
    expect_few_products<3>(30., 2);
  }

  TEST(StaticEquilibria, ContactBearsTheWeight)
  {
    for (const double density : {1e-6, 1., 1e6})
      {
        BodyDescription<3> body      = long_block<3>(2., 3, density);
        body.material.youngs_modulus = 1e3 * density;
        StaticScene<3>       scene(contact_scene<3>(body, {floor_at<3>(0.)}, {4}));
        const StaticSolution solution = scene.solve({{"0", "0", "-1"}});
        EXPECT_TRUE(solution.is_held);
        Vector normal = scene.coordinates.normal_reaction(solution.status, solution.residual);
        double sum    = 0.;
        for (const unsigned int i : scene.coordinates.normal_entries())
          sum -= normal.local_element(i);
        EXPECT_NEAR(dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD), 2. * density, 1e-9 * density);
        EXPECT_LT(scene.n_products, 150u);
      }
  }

  TEST(StaticEquilibria, WhatIsNotHeldIsNamed)
  {
    StaticScene<3> scene(contact_scene<3>(long_block<3>(2., 3), {floor_at<3>(0.)}, {4}));
    const auto     motion = [&](const std::array<std::string, 3> &acceleration) {
      const StaticSolution solution = scene.solve(acceleration);
      EXPECT_FALSE(solution.is_held);
      return scene.equilibrium.unheld_motion(solution);
    };
    EXPECT_EQ(motion({{"1e-3", "0", "-1"}}), "'block' moves along x");
    EXPECT_EQ(motion({{"3e-3", "-4e-3", "-1"}}), "'block' moves along (0.6, -0.8, 0)");
    EXPECT_EQ(motion({{"0", "0", "1"}}), "'block' moves along z");
    EXPECT_EQ(motion({{"-1e-3*(y - 0.5)", "1e-3*(x - 1)", "-1"}}), "'block' turns about z");
  }

  TEST(StaticEquilibria, AHeavyBodyIsHeldAsALightOne)
  {
    Scene<2> scene                   = stacked<2>(block<2>("upper", {0., 0.}, {1., 1.}, {{3, 3}}),
                                block<2>("lower", {0., -1.}, {1., 0.}, {{2, 2}}));
    scene.bodies[0].material.density = 1e8;
    scene.bodies[1].material.density = 1e-8;
    scene.bodies[1].dirichlet.push_back({2, {{"0", "0"}}});
    StaticScene<2>        bodies(scene);
    const RigidModes<2>   modes(bodies.discretization, bodies.coordinates);
    const ActiveSet       closed(bodies.coordinates.normal_entries().size(), contact_status::slip);
    const Eigen::MatrixXd free = modes.free_amplitudes(bodies.coordinates.held_entries(closed));
    EXPECT_EQ(free.cols(), 1) << "the upper one slides";
  }
} // namespace static_equilibrium_tests
