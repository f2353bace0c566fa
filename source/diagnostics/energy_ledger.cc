// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/energy_ledger.h>

#include <utility>

namespace signorini
{
  EnergyBooking &EnergyBooking::operator+=(const EnergyBooking &next)
  {
    contact += next.contact;
    predictor += next.predictor;
    friction += next.friction;
    damping += next.damping;
    scheme += next.scheme;
    external += next.external;
    geometry += next.geometry;
    transfer += next.transfer;
    residual += next.residual;
    return *this;
  }


  EnergyLedger::EnergyLedger()
    : EnergyLedger(
      [](const State &state) { return 0.5 * (state.displacement * state.internal_force); })
  {
  }


  void EnergyLedger::open(const State &state, const Vector *load)
  {
    first = last = evaluate(state, load);
    remember(state, load);
  }


  void EnergyLedger::transfer(const State &state, const Vector *load)
  {
    const Energy now = evaluate(state, load);
    transferred += now.total() - last.total();
    last = now;
    remember(state, load);
  }


  EnergyBooking EnergyLedger::book(const State &state, const StepReport &report, const Vector *load)
  {
    const Energy  now = evaluate(state, load);
    EnergyBooking booking;
    booking.contact   = report.work_contact;
    booking.predictor = report.work_predictor;
    booking.friction  = report.work_friction;
    booking.damping   = report.work_damping;
    booking.scheme    = report.work_scheme;
    booking.geometry  = report.work_geometry;
    booking.external  = report.work_dirichlet + report.work_obstacles;
    if (load != nullptr)
      {
        // The loads act with their mean, so that E with -f'u changes by the work of the change of
        // f.
        Vector change = *load;
        change -= last_load;
        booking.external -= 0.5 * (change * last_displacement + change * state.displacement);
      }
    booking.residual = now.total() - last.total() - booking.contact - booking.predictor
                       - booking.friction - booking.damping - booking.scheme - booking.external;
    booking.transfer = std::exchange(transferred, 0.); // `last` contains it
    last             = now;
    remember(state, load);
    return booking;
  }


  Energy EnergyLedger::evaluate(const State &state, const Vector *load) const
  {
    Energy energy;
    energy.kinetic = 0.5 * (state.velocity * state.momentum);
    energy.elastic = elastic(state);
    if (load != nullptr)
      energy.external = -(*load * state.displacement);
    return energy;
  }


  void EnergyLedger::remember(const State &state, const Vector *load)
  {
    if (load == nullptr)
      return;
    last_load         = *load;
    last_displacement = state.displacement;
  }
} // namespace signorini
