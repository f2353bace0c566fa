// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/run_summary.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace signorini
{
  namespace
  {
    double energy_of_motion(const HistoryRow &row)
    {
      return row.energy.kinetic + row.energy.elastic;
    }
  } // namespace


  void RunSummary::start(const HistoryRow &row)
  {
    initial_energy = row.energy.total();
    largest_energy = energy_of_motion(row);
    fewest_cells = most_cells = row.cells;
  }


  void RunSummary::add(const HistoryRow &row)
  {
    change           = row.energy.total() - initial_energy;
    standard_change  = row.standard_kinetic_energy - row.energy.kinetic + change;
    largest_change   = std::max(largest_change, change);
    largest_energy   = std::max(largest_energy, energy_of_motion(row));
    largest_residual = std::max(largest_residual, std::abs(row.booking.residual));
    work_friction += row.booking.friction;
    transferred += row.booking.transfer;
    n_impulse_solves += row.report.impulse_iterations > 0;
    n_impulse_iterations += row.report.impulse_iterations;
    n_common_impulses += row.report.common_impulses;
    add_contact(row);
  }


  void RunSummary::add_contact(const HistoryRow &row)
  {
    const ContactSummary &contact = row.contact;
    impulse += row.report.step_size * contact.normal_force;
    force_variation.add(contact.normal_force);
    most_sticking       = std::max(most_sticking, contact.n_stick);
    most_slipping       = std::max(most_slipping, contact.n_slip);
    largest_penetration = std::max(largest_penetration, contact.max_penetration);
    deepest             = std::max(deepest, contact.geometric_penetration);
    farthest_sliding    = std::max(farthest_sliding, contact.sliding);
    largest_slip        = contact.max_slip;
    if (contact.n_active == 0)
      return;
    if (first_contact < 0.)
      first_contact = row.state.time;
    last_contact = row.state.time;
  }


  void RunSummary::change_mesh(const unsigned long cells)
  {
    ++n_mesh_changes;
    fewest_cells = std::min(fewest_cells, cells);
    most_cells   = std::max(most_cells, cells);
  }


  double RunSummary::scale() const
  {
    // Bodies that start at rest bring hardly any energy of their own; then the largest energy of
    // the motion is the measure.
    const double initial = std::abs(initial_energy);
    return initial > 1e-3 * largest_energy ? initial : largest_energy;
  }


  double RunSummary::relative(const double energy) const
  {
    return scale() > 0. ? energy / scale() : 0.;
  }


  std::string RunSummary::warnings() const
  {
    std::ostringstream text;
    text << std::setprecision(4);
    if (largest_residual > 1e-6 * largest_energy)
      text << "  warning: a step changed the energy by " << largest_residual / largest_energy
           << " of it without an explanation. "
           << (subject.own_tolerance.empty()
                 ? "The solver was not accurate enough, or the\n"
                   "           scheme is at fault: do not trust this run, and report it.\n"
                 : "Reduce `" + subject.own_tolerance + "` or the step size.\n");
    if (deepest > 1e-2 * subject.body_size)
      text << "  warning: by the true geometry a contact node was " << deepest
           << " deep in an obstacle. Contact is linearised about the\n"
           << "           initial configuration, with one obstacle per node: do not trust motion "
              "along a curved obstacle or in a corner.\n";
    if (farthest_sliding > 1.)
      text << "  warning: bodies in contact slid along each other by " << farthest_sliding
           << " times the size of a face. The faces that meet are\n"
           << "           chosen once, in the initial configuration: do not trust the places where "
              "forces act after that.\n";
    return text.str();
  }


  std::string RunSummary::text() const
  {
    std::ostringstream text;
    text << std::setprecision(4) << "  energy            changed by "
         << 100. * relative_energy_change() << " % (" << 100. * relative(largest_change)
         << " % at most); largest unexplained part of a step "
         << (largest_energy > 0. ? largest_residual / largest_energy : 0.) << " of the energy\n";
    if (n_mesh_changes > 0)
      text << "  mesh              changed " << n_mesh_changes << " times, between " << fewest_cells
           << " and " << most_cells << " cells; this changed the energy by "
           << 100. * relative(transferred) << " %\n";
    if (subject.massless_contact_nodes)
      text << "                    (with the mass of the scheme; with the consistent one it "
              "changed by "
           << 100. * relative(standard_change) << " %)\n";
    if (first_contact >= 0.)
      text << "  contact           from " << first_contact << " to " << last_contact
           << ", largest force " << force_variation.largest() << ", impulse " << impulse << "\n"
           << "  oscillation       total variation of the force over twice its maximum: "
           << force_variation.measure() << "\n"
           << "  penetration       " << largest_penetration << " at most\n";
    else
      text << "  contact           none\n";
    if (subject.friction)
      text << "  friction          dissipated " << -work_friction + 0. << ", at most "
           << most_sticking << " nodes sticking, " << most_slipping
           << " slipping, largest accumulated slip " << largest_slip << "\n";
    if (n_impulse_solves > 0)
      text << "  impulses          of single nodes in " << n_impulse_solves << " steps, "
           << static_cast<double>(n_impulse_iterations) / n_impulse_solves << " iterations each\n";
    if (n_common_impulses > 0)
      text << "  warning: in " << n_common_impulses
           << " of these steps the equations of the single nodes were not solved; the common "
              "factor of\n"
           << "           `Time/Impulses = common` was taken instead. The energy is right, the "
              "share of each node is not.\n";
    return text.str() + warnings();
  }
} // namespace signorini
