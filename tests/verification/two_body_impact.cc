// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Two free bodies collide: contact forces are equal and opposite to round-off, so that every scheme
// keeps the linear momentum in every step, and the ledger explains every change of energy; also
// where nodes of the slave carry no multiplier. With contact-stabilized-projected, nodes that stay
// in contact have no relative normal velocity, whatever their neighbours do.

#include "../contact/two_bodies.h"

#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/energy_ledger.h>
#include <signorini/diagnostics/momentum.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/meshed_scene.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const double speed = 2.;

  /** The velocity of the slave, turned with the mesh. */
  template <int dim>
  Tensor<1, dim> impact_velocity(const double angle)
  {
    Tensor<1, dim> v;
    v[0]       = 0.3 * speed;
    v[dim - 1] = -speed;
    return rotation<dim>(angle) * v;
  }

  /**
   * Contact nodes that touch at both ends of a step have no relative normal velocity. @return
   * their number on this process
   */
  unsigned int expect_no_motion_of_staying_nodes(const DynamicalSystem &system,
                                                 const NormalGap       &gap_before,
                                                 const State           &state)
  {
    const NormalGap gap      = system.normal_gap(state.displacement),
                    approach = system.relative_normal(state.velocity);
    const double touching    = 1e-10 * system.length();
    unsigned int n           = 0;
    for (unsigned int k = 0; k < gap.size(); ++k)
      if (gap_before[k] <= touching && gap[k] <= touching)
        {
          EXPECT_LT(std::abs(approach[k]), 1e-10 * speed)
            << "step " << state.step << ", contact node " << k;
          ++n;
        }
    return n;
  }

  /** The slave flies, the master rests. */
  template <int dim>
  State state_before_impact(const TwoBodies<dim> &bodies, const double angle)
  {
    const auto &discretization = bodies.discretization;
    const auto &pattern        = discretization.matrices().pattern;
    const auto  slave          = bodies.nodes_of_body(0);
    State       state;
    state.displacement = discretization.make_vector();
    state.velocity     = state.displacement;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      for (unsigned int c = 0; slave[node] && c < dim; ++c)
        if (!pattern.is_empty(node))
          state.velocity.local_element(dim * node + c) = impact_velocity<dim>(angle)[c];
    state.contact_force  = state.displacement;
    state.momentum       = mass_times(discretization, state.velocity);
    state.internal_force = state.displacement;
    return state;
  }

  template <int dim>
  void expect_conservation(const Scene<dim>  &scene,
                           const double       angle,
                           const std::string &scheme,
                           const unsigned int n_steps)
  {
    SCOPED_TRACE(scheme);
    const TwoBodies<dim> bodies(scene, angle == 0. ? Map<dim>() : turn<dim>(angle));
    const auto          &discretization = bodies.discretization;
    Loads<dim>           loads(discretization);
    dealii::TimerOutput  timer(
      std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times);
    ElasticContactSystem<dim> system(
      discretization, bodies.surface, bodies.coordinates, loads, system_parameters(scene), timer);

    State state = state_before_impact(bodies, angle);
    bodies.surface.check_initial_gap(state.displacement);
    EnergyLedger ledger;
    ledger.open(state, nullptr);
    system.see({ledger.initial().total(), ledger.initial().total()});

    const auto   initial       = momentum(discretization, state).linear;
    const double scale         = total_mass(discretization) * speed;
    const bool   persistent    = scheme == "contact-stabilized-projected";
    double       largest_force = 0., work = 0.;
    unsigned int n_predicted = 0, n_staying = 0;
    const auto   method = make_time_scheme(scheme);
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const NormalGap  gap     = system.normal_gap(state.displacement);
        const StepReport report  = method->advance(system, state, scene.time.step_size);
        const auto       booking = ledger.book(state, report, nullptr);
        system.see({ledger.current().kinetic + ledger.current().elastic, ledger.current().elastic});
        EXPECT_FALSE(report.corrector.n_fallbacks || report.predictor.n_fallbacks) << step;
        EXPECT_LT(std::abs(booking.residual), 1e-10 * ledger.initial().total()) << step;
        n_predicted += report.predictor.n_active;
        work += booking.contact + booking.predictor;

        const auto now = momentum(discretization, state).linear;
        for (unsigned int c = 0; c < dim; ++c)
          EXPECT_NEAR(now[c], initial[c], 1e-11 * scale) << step;

        const Tensor<1, dim> on_slave  = bodies.resultant_on(0, state.contact_force),
                             on_master = bodies.resultant_on(1, state.contact_force);
        const ContactSummary summary   = contact_summary(bodies.surface, discretization, state);
        EXPECT_LE((on_slave + on_master).norm(), 1e-12 * summary.normal_force) << step;
        for (unsigned int c = 0; c < dim; ++c)
          EXPECT_NEAR(on_slave[c], summary.resultant[c], 1e-12 * summary.normal_force) << step;
        EXPECT_LT(summary.max_penetration, 1e-11) << step;
        EXPECT_LE(summary.max_tension, 0.) << step;
        if (persistent)
          n_staying += expect_no_motion_of_staying_nodes(system, gap, state);
        largest_force = std::max(largest_force, summary.normal_force);
      }
    EXPECT_GT(largest_force, 1.) << "they do meet";
    EXPECT_GT(bodies.resultant_on(1, state.momentum).norm(), 0.1 * scale) << "and exchange";
    EXPECT_TRUE(work < 0. || scheme == "newmark") << "implicit contact forces take energy";
    EXPECT_EQ(n_predicted > 0, scheme == "contact-stabilized" || persistent);
    EXPECT_EQ(dealii::Utilities::MPI::sum(n_staying, MPI_COMM_WORLD) > 20, persistent);
  }

  /**
   * Off-centre in every direction; the corner of the slave that looks past the master carries no
   * multiplier.
   */
  Scene<2> blocks_2d()
  {
    Scene<2> scene =
      stacked<2>(block<2>("slave", {0.45, 0.005}, {1.65, 1.}, {{5, 4}}),
                 block<2>("master", {-0.2, -1.}, {std::sqrt(2.) - 0.23, 0.}, {{7, 5}}));
    scene.time.step_size   = 0.002;
    scene.solver.tolerance = 1e-13;
    return scene;
  }

  Scene<3> blocks_3d()
  {
    auto slave  = block<3>("slave", {0.4, 0.3, 0.005}, {1.6, 1.3, 1.}, {{3, 2, 2}}),
         master = block<3>("master", {-0.2, -0.1, -1.}, {std::sqrt(2.) - 0.2, 1., 0.}, {{4, 5, 3}});
    slave.local_refinements = master.local_refinements = 1;
    slave.refine_where = master.refine_where = "x + 0.5*y - 1.1";
    Scene<3> scene                           = stacked<3>(slave, master);
    scene.time.step_size                     = 0.004;
    scene.solver.tolerance                   = 1e-13;
    return scene;
  }

  template <int dim>
  Scene<dim> balls()
  {
    auto upper = ball<dim>(dim == 2 ? 3 : 1), lower = ball<dim>(dim == 2 ? 4 : 2);
    upper.name                     = "upper";
    lower.name                     = "lower";
    ball_of(lower).centre[0]       = 0.3;
    ball_of(lower).centre[dim - 1] = dim == 2 ? -1. : -1.1;
    Scene<dim>      scene          = scene_of<dim>({upper, lower});
    PairDescription pair;
    pair.name   = "upper : lower";
    pair.slave  = 0;
    pair.master = 1;
    scene.pairs.push_back(pair);
    scene.time.step_size   = 0.01;
    scene.solver.tolerance = 1e-13;
    return scene;
  }

  const std::array<std::string, 4> colliding_schemes = {
    {"newmark", "contact-implicit", "contact-stabilized", "contact-stabilized-projected"}};
} // namespace

TEST(TwoBodyImpact, BlocksIn2d)
{
  for (const std::string &scheme : colliding_schemes)
    for (const double angle : {0., 0.7})
      expect_conservation(blocks_2d(), angle, scheme, 80);
}

TEST(TwoBodyImpact, BlocksIn3d)
{
  for (const std::string &scheme : colliding_schemes)
    expect_conservation(blocks_3d(), scheme == "newmark" ? 0. : 0.7, scheme, 40);
}

TEST(TwoBodyImpact, Discs)
{
  for (const std::string &scheme : colliding_schemes)
    expect_conservation(balls<2>(), 0., scheme, 60);
}

TEST(TwoBodyImpact, Balls)
{
  for (const std::string &scheme : colliding_schemes)
    expect_conservation(balls<3>(), 0., scheme, 40);
}
