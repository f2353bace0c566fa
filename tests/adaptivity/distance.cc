// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The distance indicator sees what is close and what will be close, on both sides of a pair; it
// needs no motion. Marked by it, the mesh is fine at the contact and goes back when the contact is
// over.

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/adaptivity/error_indicator.h>
#include <signorini/adaptivity/mark_cells.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  std::unique_ptr<ErrorIndicator<dim>> indicator_of(const Scene<dim>               &scene,
                                                    const Discretization<dim>      &discretization,
                                                    const ContactSurface<dim>      &surface,
                                                    const DirichletConditions<dim> &dirichlet)
  {
    return make_error_indicator(scene.adaptivity,
                                {StepBalance::middle, scene.time.step_size},
                                discretization,
                                surface,
                                dirichlet);
  }

  Scene<2> disc_above_floor(const double distance)
  {
    BodyDescription<2> body        = ball<2>(3);
    Scene<2>           scene       = contact_scene<2>(body, {floor_at<2>(-0.01)});
    scene.adaptivity.indicator     = IndicatorKind::distance;
    scene.adaptivity.distance      = distance;
    scene.adaptivity.maximum_level = 5;
    return scene;
  }

  /** Largest indicator, and how many are at least 1, on all processes. */
  template <int dim>
  std::pair<double, unsigned int> look(const Discretization<dim>    &discretization,
                                       const dealii::Vector<double> &indicator,
                                       const unsigned int            body)
  {
    double       largest = 0.;
    unsigned int number  = 0;
    for (const auto &cell : discretization.mesh().triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == body)
        {
          largest = std::max(largest, indicator(cell->active_cell_index()));
          number += indicator(cell->active_cell_index()) >= 1.;
        }
    return {dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD),
            dealii::Utilities::MPI::sum(number, MPI_COMM_WORLD)};
  }

  template <int dim>
  State moving(const Discretization<dim> &discretization, const double height, const double speed)
  {
    std::array<std::string, dim> up, velocity;
    up.fill("0");
    velocity.fill("0");
    up[dim - 1]       = std::to_string(height);
    velocity[dim - 1] = std::to_string(speed);
    State state;
    state.displacement = field<dim>(discretization, up);
    state.velocity     = field<dim>(discretization, velocity);
    return state;
  }
} // namespace

TEST(Distance, SeesWhatIsCloseOrWillBe)
{
  Scene<2> scene                 = disc_above_floor(0.02);
  scene.adaptivity.steps_between = 1;
  const ContactProblem<2> problem(scene);
  const auto              indicator =
    indicator_of(problem.scene, problem.discretization, problem.surface, problem.dirichlet);
  const auto at = [&](const double height, const double speed) {
    const State state = moving(problem.discretization, height, speed);
    return look(problem.discretization, indicator->evaluate({state, state, 0.}), 0);
  };
  const auto [largest, number] = at(0., 0.);
  EXPECT_NEAR(largest, 2., 1e-10); // the lowest node is at half of the distance
  EXPECT_GE(number, 2u);
  EXPECT_EQ(at(1., 0.).second, 0u);
  EXPECT_NEAR(at(1., 0.).first, 0.02 / 1.01, 1e-10);
  EXPECT_EQ(at(1., -49.).second, 0u);
  EXPECT_GE(at(1., -50.).second, 2u); // two steps of 0.01
  EXPECT_NEAR(at(0., -2.).first, 4., 1e-10);
}

TEST(Distance, LooksAsFarAheadAsTheMeshMayHaveToServe)
{
  // Until it is judged again, and one step more: three steps of 0.01.
  const ContactProblem<2> problem(disc_above_floor(0.02));
  const auto              indicator =
    indicator_of(problem.scene, problem.discretization, problem.surface, problem.dirichlet);
  const auto n_close = [&](const double speed) {
    const State state = moving(problem.discretization, 1., speed);
    return look(problem.discretization, indicator->evaluate({state, state, 0.}), 0).second;
  };
  EXPECT_EQ(n_close(-32.5), 0u);
  EXPECT_GE(n_close(-33.5), 2u);
}

TEST(Distance, BothBodiesOfAPair)
{
  auto scene = stacked<3>(block<3>("slave", {0.4, 0.4, 0.05}, {0.6, 0.6, 0.5}, {{2, 2, 2}}),
                          block<3>("master", {0., 0., -1.}, {1., 1., 0.}, {{5, 5, 5}}));
  scene.adaptivity.indicator = IndicatorKind::distance;
  const TwoBodies<3> bodies(scene);
  const auto         indicator =
    indicator_of(bodies.scene, bodies.discretization, bodies.surface, bodies.dirichlet);
  const State state = moving(bodies.discretization, 0., 0.);
  const auto  value = indicator->evaluate({state, state, 0.});
  // Three times the size of a cell over the gap: 3 * 0.15 / 0.05 and 3 * 0.2 / 0.05, at most 4.
  EXPECT_GE(look(bodies.discretization, value, 0).second, 4u);
  EXPECT_EQ(look(bodies.discretization, value, 1).first, 4.);
  EXPECT_EQ(look(bodies.discretization, value, 1).second,
            9u); // the cells around the middle one share nodes with it
}

TEST(Distance, TheMeshIsFineAtTheContactAndGoesBack)
{
  Scene<2> scene              = disc_above_floor(0.02);
  scene.adaptivity.hysteresis = 0.; // these are few cells
  Mesh<2>    mesh(scene.bodies, MPI_COMM_WORLD, scene.mapping, true);
  const auto cells = [&] { return mesh.triangulation().n_global_active_cells(); };
  const auto adapt = [&](const double height) {
    for (unsigned int times = 0; times < 6; ++times)
      {
        const Discretization<2>      discretization(mesh);
        const DirichletConditions<2> dirichlet(discretization);
        const ContactSurface<2> surface(discretization, dirichlet, scene.obstacles, scene.pairs);
        const State             state     = moving(discretization, height, 0.);
        const auto              indicator = indicator_of(scene, discretization, surface, dirichlet);
        if (!mark_cells(mesh, scene.adaptivity, indicator->evaluate({state, state, 0.})).any())
          return times;
        mesh.carry_out_flags();
      }
    return 6u;
  };
  const unsigned int initial = cells();
  EXPECT_EQ(adapt(0.), 2u); // from level 3 to 5
  EXPECT_GT(cells(), initial + 15);
  EXPECT_LT(cells(), initial + 200);
  EXPECT_EQ(adapt(0.5), 2u);
  EXPECT_EQ(cells(), initial);
}
