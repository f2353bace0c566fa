// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The patch test of contact: two stacked blocks of different materials under a uniform pressure
// have a linear displacement each and the same pressure everywhere on their common face. The mortar
// method transmits a uniform pressure exactly across any flat non-matching interface, so that the
// discrete solution is the exact one, and every scheme stays in this state of rest.

#include "../contact/stacked_blocks.h"

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
  /** The forces of the exact solution balance at all nodes, but for the reactions of the rollers.
   */
  template <int dim>
  void expect_balance(const Stack<dim> &stack, const TwoBodies<dim> &bodies)
  {
    Vector       balance = stiffness_times(bodies.discretization, stack.exact(bodies));
    const double scale   = balance.linfty_norm();
    balance -= Loads<dim>(bodies.discretization).at(0.);
    balance -= uniform_contact_force(bodies);
    bodies.coordinates.force_to_contact(balance);
    for (const unsigned int i : bodies.coordinates.dirichlet_entries())
      balance.local_element(i) = 0.;
    EXPECT_LT(balance.linfty_norm(), 1e-13 * scale);
  }

  template <int dim>
  void expect_static_solution(const Stack<dim> &stack, const bool guess)
  {
    const TwoBodies<dim> bodies(stack.scene(true), stack.map());
    const auto          &coordinates = bodies.coordinates;
    const auto          &matrices    = bodies.discretization.matrices();
    const unsigned int   n           = bodies.surface.nodes().size();
    expect_balance(stack, bodies);

    const StepOperator<dim> matrix(matrices, coordinates, {0., 1.});
    const auto              preconditioner =
      make_preconditioner(PreconditionerKind::jacobi, matrices, coordinates, {0., 1.});
    const Vector exact = stack.exact(bodies);
    Vector load = Loads<dim>(bodies.discretization).at(0.), u = bodies.discretization.make_vector(),
           residual     = u;
    const double energy = std::abs(load * exact);
    coordinates.force_to_contact(load);
    ActiveSet active(n, 1);
    for (unsigned int k = 0; k < n; ++k) // some of them, so that the upper block does not float
      active[k] = guess || bodies.surface.nodes()[k].position[0] < 0.6 * stack.side;
    PrimalDualActiveSet solver({50, 10000});
    const auto          report = solver.solve({matrix,
                                               *preconditioner,
                                               load,
                                               coordinates.normal_entries(),
                                               bodies.surface.normal_gap(u),
                                               coordinates.dirichlet_entries(),
                                               coordinates.dirichlet_values(0.),
                                               1e-12 * std::sqrt(energy),
                                               1e-13},
                                     active,
                                     u,
                                     residual);
    EXPECT_FALSE(report.n_fallbacks);
    EXPECT_EQ(report.n_active, bodies.surface.n_global_nodes());
    for (unsigned int k = 0; k < n; ++k)
      EXPECT_NEAR(residual.local_element(coordinates.normal_entries()[k])
                    / bodies.surface.nodes()[k].weight,
                  pressure,
                  1e-10 * pressure)
        << bodies.surface.nodes()[k].position;
    coordinates.displacement_to_cartesian(u);
    u -= exact;
    EXPECT_LT(u.linfty_norm(), 1e-10 * exact.linfty_norm());
  }

  /** Rest, or uniform motion along the interface, over 20 steps. */
  template <int dim>
  void expect_rest(const Stack<dim> &stack, const std::string &scheme, const double speed)
  {
    const TwoBodies<dim> bodies(stack.scene(false), stack.map());
    const auto          &discretization = bodies.discretization;
    Loads<dim>           loads(discretization);
    dealii::TimerOutput  timer(
      std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times);
    ElasticContactSystem<dim> system(discretization,
                                     bodies.surface,
                                     bodies.coordinates,
                                     loads,
                                     system_parameters(bodies.scene),
                                     timer);

    const Vector initial  = stack.exact(bodies);
    const Vector velocity = bodies.nodal([&](const Point<dim> &) {
      Tensor<1, dim> v;
      for (unsigned int d = 0; d < dim - 1; ++d)
        v[d] = speed / (1. + d);
      return v;
    });
    State        state;
    state.displacement   = initial;
    state.velocity       = velocity;
    state.contact_force  = uniform_contact_force(bodies);
    state.momentum       = mass_times(discretization, velocity);
    state.internal_force = stiffness_times(discretization, initial);
    const double elastic = 0.5 * (initial * state.internal_force),
                 mass    = total_mass(discretization);
    const double energy  = elastic + 0.5 * (velocity * state.momentum);
    system.see({energy, energy});
    const Vector force = state.contact_force;

    const double tau    = 0.01;
    const auto   method = make_time_scheme(scheme);
    for (unsigned int step = 0; step < 20; ++step)
      {
        const StepReport report = method->advance(system, state, tau);
        EXPECT_FALSE(report.corrector.n_fallbacks);
        ASSERT_EQ(report.corrector.n_active, bodies.surface.n_global_nodes())
          << scheme << " " << step;
        EXPECT_EQ(report.predictor.n_active, 0u) << scheme << " " << step;
      }
    Vector error = state.displacement;
    error -= initial;
    error.add(-20. * tau, velocity);
    EXPECT_LT(error.linfty_norm(), 1e-9 * initial.linfty_norm()) << scheme;
    error = state.velocity;
    error -= velocity;
    EXPECT_LT(error.linfty_norm(), 1e-9 * std::sqrt(2. * energy / mass)) << scheme;
    error = state.contact_force;
    error -= force;
    EXPECT_LT(error.linfty_norm(), 1e-8 * force.linfty_norm()) << scheme;
  }

  std::vector<std::pair<std::string, Stack<2>>> stacks_2d()
  {
    auto reversed           = stack<2>({{5, 2}}, {{3, 4}}, std::sqrt(2.));
    reversed.lower_is_slave = true;
    auto distorted          = stack<2>({{7, 3}}, {{3, 4}}, 1.);
    distorted.is_distorted  = true;
    return {{"1 to 3", stack<2>({{6, 3}}, {{2, 2}}, 1.)},
            {"3 to 1", stack<2>({{2, 3}}, {{6, 2}}, 1.)},
            {"irrational", stack<2>({{7, 2}}, {{4, 3}}, std::sqrt(2.))},
            {"slave below", reversed},
            {"distorted", distorted}};
  }

  std::vector<std::pair<std::string, Stack<3>>> stacks_3d()
  {
    auto hanging_slave = stack<3>({{3, 3, 2}}, {{2, 2, 2}}, 1.), hanging_master = hanging_slave,
         both = hanging_slave;
    for (auto *body : {&hanging_slave.upper, &hanging_master.lower, &both.upper, &both.lower})
      {
        body->local_refinements = 1;
        body->refine_where      = "0.7 - x - 0.5*y";
      }
    both.lower_is_slave    = true;
    auto distorted         = stack<3>({{3, 4, 2}}, {{2, 2, 3}}, 1.);
    distorted.is_distorted = true;
    return {{"1 to 3", stack<3>({{6, 3, 2}}, {{2, 1, 2}}, 1.)},
            {"irrational", stack<3>({{5, 3, 2}}, {{3, 4, 1}}, std::sqrt(2.))},
            {"hanging nodes on the slave", hanging_slave},
            {"hanging nodes on the master", hanging_master},
            {"hanging nodes on both, slave below", both},
            {"distorted", distorted}};
  }
} // namespace

TEST(PatchTest, StaticIn2d)
{
  for (const auto &[name, stack] : stacks_2d())
    for (const bool guess : {true, false})
      {
        SCOPED_TRACE(name);
        expect_static_solution(stack, guess);
      }
}

TEST(PatchTest, StaticIn3d)
{
  for (const auto &[name, stack] : stacks_3d())
    for (const bool guess : {true, false})
      {
        SCOPED_TRACE(name);
        expect_static_solution(stack, guess);
      }
}

TEST(PatchTest, StaysAtRestIn2d)
{
  for (const auto &[name, stack] : stacks_2d())
    for (const char *scheme : {"newmark", "contact-implicit", "contact-stabilized"})
      for (const double speed : {0., 0.3})
        {
          SCOPED_TRACE(name);
          expect_rest(stack, scheme, speed);
        }
}

TEST(PatchTest, StaysAtRestIn3d)
{
  for (const auto &[name, stack] : stacks_3d())
    for (const char *scheme : {"newmark", "contact-implicit", "contact-stabilized"})
      for (const double speed : {0., 0.3})
        {
          SCOPED_TRACE(name);
          expect_rest(stack, scheme, speed);
        }
}
