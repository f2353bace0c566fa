// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Effectivity of the residual estimate: its ratio to the true error stays between fixed bounds
// while the mesh is refined adaptively, for a static problem of Signorini and for one time step,
// from meshes that are coarse for a wave in a step to fine ones. With J the functional that the
// problem minimises, 2 (J(u_h) - J(u)) is the squared error in the energy norm, and with contact a
// bound of it; J(u) comes from further levels. The meshes are nested and the gaps linear, so that J
// decreases: with the standard element, whose energy is that of its displacement.

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/adaptivity/mark_cells.h>
#include <signorini/adaptivity/residual_estimate.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/meshed_scene.h>
#include <signorini/system/start_equilibrium.h>

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr unsigned int n_levels = 8, n_further_levels = 4;

  /** What is found on one mesh: the squared estimate of each cell, and the functional. */
  struct Found
  {
    dealii::Vector<double> squares;
    double                 functional;
  };

  /** All that belongs to one mesh. */
  struct OnMesh
  {
    OnMesh(const Mesh<2> &mesh, const Scene<2> &scene)
      : discretization(mesh)
      , dirichlet(discretization)
      , surface(discretization, dirichlet, scene.obstacles, scene.pairs)
      , coordinates(discretization, surface, dirichlet)
      , loads(discretization)
    {
    }

    const Discretization<2>      discretization;
    const DirichletConditions<2> dirichlet;
    const ContactSurface<2>      surface;
    const ContactCoordinates<2>  coordinates;
    Loads<2>                     loads;
  };

  Scene<2> block_on_floor(const dealii::Tensor<1, 2> &normal)
  {
    BodyDescription<2> body = block<2>("block", {}, {2., 1.}, {{4, 2}});
    body.element            = ElementKind::standard;
    Scene<2> scene = contact_scene<2>(body, {plane<2>("floor", {}, normal)}, {bottom_id<2>});
    scene.solver.tolerance         = 1e-12;
    scene.adaptivity.indicator     = IndicatorKind::residual;
    scene.adaptivity.maximum_level = 15;
    return scene;
  }

  /**
   * Refine adaptively, print a table, and check the effectivities. @return the errors and numbers
   * of cells by level
   */
  std::vector<std::pair<double, double>>
  expect_bounded_effectivity(const std::string                           &title,
                             const Scene<2>                              &scene,
                             const std::function<Found(OnMesh &on_mesh)> &solve,
                             const double                                 least,
                             const double                                 most)
  {
    Mesh<2>                   mesh(scene.bodies, MPI_COMM_WORLD, scene.mapping, true);
    std::vector<double>       estimates, functionals;
    std::vector<unsigned int> cells;
    for (unsigned int level = 0; level < n_levels + n_further_levels; ++level)
      {
        OnMesh      on_mesh(mesh, scene);
        const Found found = solve(on_mesh);
        estimates.push_back(std::sqrt(found.squares.l1_norm()));
        functionals.push_back(found.functional);
        cells.push_back(mesh.triangulation().n_active_cells());
        dealii::Vector<double> indicator = found.squares;
        for (double &value : indicator)
          value = std::sqrt(value);
        EXPECT_TRUE(mark_cells(mesh, scene.adaptivity, indicator).refines());
        mesh.carry_out_flags();
      }
    // The last meshes tell how far the limit is: the error of J is inverse to the number of cells.
    const std::size_t last  = functionals.size() - 1;
    const double      ratio = double(cells[last]) / cells[last - 1];
    const double      limit =
      functionals[last] - (functionals[last - 1] - functionals[last]) / (ratio - 1.);

    std::cout << title << "\n| cells | error | estimate | effectivity |\n|-|-|-|-|\n";
    std::vector<std::pair<double, double>> errors;
    for (unsigned int level = 0; level < n_levels; ++level)
      {
        const double error = std::sqrt(2. * (functionals[level] - limit));
        std::cout << "| " << cells[level] << " | " << std::setprecision(3) << error << " | "
                  << estimates[level] << " | " << estimates[level] / error << " |\n";
        EXPECT_GT(estimates[level], least * error) << cells[level] << " cells";
        EXPECT_LT(estimates[level], most * error) << cells[level] << " cells";
        errors.emplace_back(error, cells[level]);
      }
    return errors;
  }
} // namespace

// Pressed on the left, lifted on the right: the block touches the floor with a part of its lower
// face.
TEST(Effectivity, StaticContact)
{
  Scene<2> scene = block_on_floor(dealii::Point<2>(0., 1.));
  scene.bodies[0].dirichlet.push_back({0, {{"0", "-"}}});
  scene.bodies[0].traction.push_back({top_id<2>, {{"0", "-4*(1.5 - x)"}}});
  const auto solve = [&](OnMesh &on_mesh) {
    const auto &discretization = on_mesh.discretization;
    State       state;
    state.velocity     = discretization.make_vector();
    const Vector &load = on_mesh.loads.at(0.);
    start_in_equilibrium(
      discretization, on_mesh.surface, on_mesh.coordinates, scene.solver, &load, nullptr, state);
    const Vector &u = state.displacement;
    return Found{
      ResidualEstimate(discretization, on_mesh.surface, on_mesh.dirichlet)
        .squares(balance_at_rest(discretization, on_mesh.surface, u, state.contact_force),
                 ResidualWeights{}),
      0.5 * (u * stiffness_times(discretization, u)) - load * u};
  };
  const auto errors = expect_bounded_effectivity("static contact", scene, solve, 4., 9.5);
  // The order of the method in terms of the number of unknowns, whatever the corners.
  const auto &first = errors[1], &last = errors.back();
  EXPECT_GT(std::log(first.first / last.first) / std::log(last.second / first.second), 0.42);
}

// A block that falls on an inclined floor, one step: the part that would be below the floor is
// stopped, which sends a wave into the block.
TEST(Effectivity, OneTimeStep)
{
  Scene<2>     scene   = block_on_floor(dealii::Point<2>(-0.05, 1.) / std::sqrt(1.0025));
  const double tau     = 0.05;
  scene.time.step_size = tau;
  scene.time.scheme    = "contact-implicit";
  scene.bodies[0].initial_velocity = {{"0", "-2"}};
  const auto solve                 = [&](OnMesh &on_mesh) {
    const auto         &discretization = on_mesh.discretization;
    dealii::TimerOutput timer(
      std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times);
    ElasticContactSystem<2> system(discretization,
                                   on_mesh.surface,
                                   on_mesh.coordinates,
                                   on_mesh.loads,
                                   system_parameters(scene),
                                   timer);
    State                   start;
    start.displacement   = discretization.make_vector();
    start.velocity       = field<2>(discretization, scene.bodies[0].initial_velocity);
    start.contact_force  = discretization.make_vector();
    start.momentum       = mass_times(discretization, start.velocity);
    start.internal_force = discretization.make_vector();
    system.see({0.5 * (start.velocity * start.momentum), 0.});
    State end = start;
    make_time_scheme(scene.time.scheme)->advance(system, end, tau);
    // Squared norm of velocity and displacement: 4/tau^2 times that of the problem of the step.
    const Vector &d = end.displacement;
    return Found{ResidualEstimate(discretization, on_mesh.surface, on_mesh.dirichlet)
                   .squares(balance_of_step(discretization,
                                            on_mesh.surface,
                                            {start, end, tau},
                                            {scheme_info(scene.time.scheme).balance}),
                            ResidualWeights{tau}),
                 4. / (tau * tau)
                   * (0.5 * (d * mass_times(discretization, d)) - tau * (d * start.momentum)
                      + tau * tau / 8. * (d * end.internal_force))};
  };
  expect_bounded_effectivity("one time step", scene, solve, 4., 9.5);
}
