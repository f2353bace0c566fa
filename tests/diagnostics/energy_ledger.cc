// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The ledger accounts for the change of energy by the work that is reported, including that of a
// changing load; what remains, and only that, is the residual.

#include "../discretization/bodies.h"

#include <signorini/diagnostics/energy_ledger.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** A state of a cube of mass 2 with elastic energy: u = a (x, 0, 0), v = (b, 0, 0). */
  State
  state_of(const Discretization<3> &discretization, const std::string &a, const std::string &b)
  {
    State state;
    state.displacement   = field<3>(discretization, {{a + "*x", "0", "0"}});
    state.velocity       = field<3>(discretization, {{b, "0", "0"}});
    state.momentum       = mass_times(discretization, state.velocity);
    state.internal_force = stiffness_times(discretization, state.displacement);
    return state;
  }

  double stiffness_of_uniaxial_strain(const Discretization<3> &discretization)
  {
    const Material &material = discretization.mesh().bodies()[0].material;
    return material.lambda() + 2. * material.mu();
  }
} // namespace

TEST(EnergyLedger, AddsUpTheEnergies)
{
  const Assembled<3> assembled(box<3>());
  EnergyLedger       ledger;
  ledger.open(state_of(assembled.discretization, "0.1", "3"), nullptr);
  EXPECT_NEAR(ledger.initial().kinetic, 9., 1e-12);
  EXPECT_NEAR(ledger.initial().elastic,
              0.005 * stiffness_of_uniaxial_strain(assembled.discretization),
              1e-12);
  EXPECT_EQ(ledger.initial().external, 0.);
}

TEST(EnergyLedger, ResidualIsWhatNobodyReports)
{
  const Assembled<3> assembled(box<3>());
  EnergyLedger       ledger;
  ledger.open(state_of(assembled.discretization, "0", "3"), nullptr);
  StepReport report;
  report.work_contact   = -4.;
  report.work_predictor = -1.5;
  report.work_dirichlet = 0.5;
  const EnergyBooking booking =
    ledger.book(state_of(assembled.discretization, "0", "2"), report, nullptr);
  EXPECT_EQ(booking.contact, -4.);
  EXPECT_EQ(booking.predictor, -1.5);
  EXPECT_EQ(booking.external, 0.5);
  EXPECT_NEAR(booking.residual, 4. - 9. + 5., 1e-12);
  EXPECT_NEAR(
    ledger.book(state_of(assembled.discretization, "0", "1"), StepReport(), nullptr).residual,
    -3.,
    1e-12);
  EXPECT_NEAR(ledger.initial().total(), 9., 1e-12);
}

// The mean load (f + f_new)/2 does the work (f + f_new)'(u_new - u)/2 on the body; of -f'u that
// leaves -(f_new - f)'(u + u_new)/2.
TEST(EnergyLedger, WorkOfAChangingLoad)
{
  const Assembled<3> assembled(box<3>());
  const auto        &discretization = assembled.discretization;
  const State        start          = state_of(discretization, "0.1", "3"),
              end                   = state_of(discretization, "0.3", "3");
  const Vector f                    = field<3>(discretization, {{"2", "0", "0"}}),
               f_new                = field<3>(discretization, {{"5*x", "0", "0"}});

  EnergyLedger ledger;
  ledger.open(start, &f);
  EXPECT_NEAR(ledger.initial().external, -(f * start.displacement), 1e-13);
  const EnergyBooking booking = ledger.book(end, StepReport(), &f_new);

  Vector mean = f, increment = end.displacement;
  mean += f_new;
  mean *= 0.5;
  increment -= start.displacement;
  const double work    = mean * increment;
  const double elastic = 0.5 * (0.09 - 0.01) * stiffness_of_uniaxial_strain(discretization);
  EXPECT_NEAR(booking.residual, elastic - work, 1e-11)
    << "kinetic and elastic energy grow by the work of the load";
}
