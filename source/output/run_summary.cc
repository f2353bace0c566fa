// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/diagnostics/resolution.h>
#include <signorini/output/run_summary.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Per cent: of what is exactly nothing only round-off is left. */
    double without_round_off(const double value)
    {
      return std::abs(value) < 1e-9 ? 0. : value;
    }

    /** Where there were forces, but none that counts: see unnoticed_force. */
    std::string about_unnoticed_forces(const double largest)
    {
      std::ostringstream text;
      text << std::setprecision(3) << " that counts: the largest force, " << largest
           << ", is below 1e-7 of the energy of the motion over the size of the bodies";
      return text.str();
    }

    /** Of the iterations of a run: what is worth a line. */
    constexpr double hardly_saved = 0.01;

    /** Parts of the energy: StepReport::work_geometry that is worth a line, and a warning. */
    constexpr double hardly_missed = 1e-4, much_missed = 1e-2;

    /** @param part of the energy */
    std::string about_missed_gaps(const double part)
    {
      std::ostringstream text;
      text
        << std::setprecision(3)
        << "contact of bodies misses their true gaps: forces times what is missed are up to "
        << 100. * part
        << " % of the energy in a step. Forces act between nodes that are apart, or bodies "
           "overlap. Finer contact surfaces help (`Refinements`, `Local refinements`, or section "
           "Adaptivity), smaller steps do not.";
      return text.str();
    }

    /** Elastic energy in flight that is worth a line, as part of the largest energy of motion. */
    constexpr double noticed_vibration = 1e-3;
    /** Than steps in contact: what they resolve is lost by such steps. */
    constexpr double much_longer = 3.;
    /** Times the target: an error by steps that asks for shorter ones. */
    constexpr double missed = 1.5;
    /** A larger estimate of an error means little. */
    constexpr double most_credible = 0.3;

    /** Part of the energy: gains by changes of the mesh that are worth a warning. */
    constexpr double much_brought = 5e-3;

    /** Gains by all changes and by the one that brought most: parts of the energy. */
    std::string about_transfer(const double all, const double largest, const double time)
    {
      std::ostringstream text;
      text << std::setprecision(3) << "changes of the mesh brought " << 100. * all
           << " % of the energy, that before time " << time << ' ' << 100. * largest
           << " %. What the finer cells need more to keep a contact of few nodes, or "
              "the coarser ones of a round body that has turned, could not be taken out of the "
              "vibration. Let `Refinements` or `Local refinements` begin with finer cells at the "
              "contact, or take `Element = standard` if it is another; a round body that turns "
              "wants finer cells "
              "all over.";
      return text.str();
    }

    /** Part of the energy: what takes more of it is worth a warning. */
    constexpr double much_lost = 0.1;

    /** @param part of the energy */
    std::string about_lost_waves(const double part)
    {
      std::ostringstream text;
      text
        << std::setprecision(3) << "changes of the mesh took " << 100. * part
        << " % of the energy: waves that coarsened cells cannot carry. If this vibration counts, "
           "also for contacts to come, give a smaller `Adaptivity/Coarsen ratio`, or a finer body "
           "to begin with (`Refinements`).";
      return text.str();
    }

    /** @param part of the energy @param by_choice there is a key for what the scheme damps */
    std::string about_damping(const double part, const bool by_choice)
    {
      std::ostringstream text;
      text
        << std::setprecision(3) << "the damping of the scheme took " << 100. * part
        << " % of the energy. It is meant for what is faster than a step: give smaller steps, or "
        << (by_choice ? "`Time/Spectral radius = 1`" : "take another `Time/Scheme`")
        << " if the vibration counts.";
      return text.str();
    }

    double energy_of_motion(const HistoryRow &row)
    {
      return row.energy.kinetic + row.energy.elastic;
    }
  } // namespace


  void RunSummary::start(const HistoryRow &row)
  {
    initial_energy    = row.energy.total();
    initial_potential = row.energy.external;
    largest_energy    = energy_of_motion(row);
    fewest_cells = most_cells = row.cells;
    error_of_steps.start(row.state.time, row.contact.normal_force);
  }


  void RunSummary::add(const HistoryRow &row)
  {
    change           = row.energy.total() - initial_energy;
    standard_change  = row.standard_kinetic_energy - row.energy.kinetic + change;
    largest_change   = std::max(largest_change, change);
    largest_energy   = std::max(largest_energy, energy_of_motion(row));
    largest_residual = std::max(largest_residual, std::abs(row.booking.residual));
    booked_from_outside += row.booking.external;
    largest_brought = std::max(
      largest_brought, std::abs(booked_from_outside - (row.energy.external - initial_potential)));
    largest_missed_gap = std::max(largest_missed_gap, std::abs(row.booking.geometry));
    work_friction += row.booking.friction;
    largest_gain =
      std::max(largest_gain, row.booking.contact + row.booking.predictor + row.booking.friction);
    work_damping += row.booking.damping;
    work_scheme += row.booking.scheme;
    transferred += row.booking.transfer;
    brought_by_meshes += std::max(0., row.booking.transfer);
    if (row.booking.transfer > largest_transfer)
      {
        largest_transfer = row.booking.transfer;
        time_of_transfer = row.state.time;
      }
    n_impulse_solves += row.report.impulse_iterations > 0;
    n_impulse_iterations += row.report.impulse_iterations;
    n_common_impulses += row.report.common_impulses;
    n_rejected += row.report.rejected_steps;
    n_fallbacks += row.report.n_fallbacks();
    iterations += row.report.corrector.linear_iterations;
    saved_iterations += row.report.corrector.saved_iterations;
    add_contact(row);
  }


  void RunSummary::add_contact(const HistoryRow &row)
  {
    const ContactSummary &contact = row.contact;
    impulse += row.report.step_size * contact.normal_force;
    force_variation.add(contact.normal_force);
    error_of_steps.add({row.state.time - subject.before_end * row.report.step_size,
                        row.report.step_size,
                        row.report.force_delay,
                        contact.normal_force});
    most_sticking       = std::max(most_sticking, contact.n_stick);
    most_slipping       = std::max(most_slipping, contact.n_slip);
    largest_penetration = std::max(largest_penetration, contact.max_penetration);
    largest_slip        = contact.max_slip;
    work_contact += row.booking.contact + row.booking.predictor;
    phase = contact.n_active > 0 ? phase + 1 : 0;
    if (contact.n_active == 0 && first_contact >= 0.
        && row.energy.elastic > noticed_vibration * largest_energy
        && row.report.step_size > much_longer * mean_step)
      loses_phases = true;
    longest_phase = std::max(longest_phase, phase);
    if (contact.n_active == 0)
      return;
    has_lost_phases = has_lost_phases || loses_phases;
    loses_phases    = false;
    ++n_contact_steps;
    mean_step += (row.report.step_size - mean_step) / n_contact_steps;
    if (contact.normal_force > largest_contact.normal_force)
      largest_contact = contact;
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
    return std::max(largest_energy, largest_brought);
  }


  double RunSummary::relative(const double energy) const
  {
    return scale() > 0. ? energy / scale() : 0.;
  }


  std::vector<std::string> RunSummary::about_meshes() const
  {
    std::vector<std::string> result;
    const double             taken = relative(brought_by_meshes - transferred);
    if (const double all = relative(brought_by_meshes); all > much_brought)
      result.push_back(about_transfer(all, relative(largest_transfer), time_of_transfer));
    if (subject.has_inertia && taken > much_lost)
      result.push_back(about_lost_waves(taken));
    return result;
  }


  std::vector<std::string> RunSummary::warnings() const
  {
    std::vector<std::string> result;
    const auto               say = [&](const auto &...parts) {
      std::ostringstream text;
      text << std::setprecision(3);
      (text << ... << parts);
      result.push_back(text.str());
    };
    if (largest_residual > 1e-6 * largest_energy)
      say("a step changed the energy by ",
          largest_residual / largest_energy,
          " of it without an explanation. ",
          subject.own_tolerance.empty()
            ? "The solver was not accurate enough, or the scheme is at fault: do not trust this "
              "run, and report it."
            : "Reduce `" + subject.own_tolerance + "` or the step size.");
    if (n_common_impulses > 0)
      say("in ",
          n_common_impulses,
          " steps the equations of the impulses of single nodes were not solved; the common factor "
          "of `Time/Impulses = common` was taken instead. The energy is right, the share of each "
          "node is not.");
    if (largest_contact.n_active < few_nodes(subject.dimension)
        && 2 * largest_contact.n_active < largest_contact.n_nodes)
      say("at the largest force only ",
          largest_contact.n_active,
          " of ",
          largest_contact.n_nodes,
          " contact nodes carried it. Force and duration of such a contact may be wrong by 30 %: "
          "refine the mesh where the bodies touch (`Local refinements`, section Adaptivity).");
    if (!subject.may_gain && largest_gain > 1e-6 * largest_energy)
      say("contact brought ",
          100. * largest_gain / largest_energy,
          " % of the energy in one step, which this scheme never does where a body keeps to its "
          "obstacle: it passed an edge or a corner, or began inside. Do not trust what follows.");
    for (const std::string &warning : about_meshes())
      result.push_back(warning);
    if (relative(largest_missed_gap) > much_missed)
      result.push_back(about_missed_gaps(relative(largest_missed_gap)));
    if (!subject.has_inertia)
      return result;
    if (relative(-work_scheme) > much_lost)
      result.push_back(about_damping(relative(-work_scheme), subject.damps_by_choice));
    if (first_contact >= 0. && phase == 0 && longest_phase < few_steps)
      say("the longest contact lasted ",
          longest_phase,
          longest_phase == 1 ? " step" : " steps",
          ". Force and impulse need some twenty: reduce `Time/Step size`.");
    if (relative(-work_contact) > much_lost)
      say("contact took ",
          100. * relative(-work_contact),
          " % of the energy, in ",
          n_contact_steps,
          " steps with contact. What the scheme takes becomes less with smaller steps and cells.");
    return result;
  }


  void RunSummary::archive(Archive &archive)
  {
    archive(force_variation, mean_step, loses_phases, has_lost_phases);
    error_of_steps.archive(archive);
    archive(initial_energy, largest_energy, change, largest_change, largest_residual);
    archive(largest_penetration, work_contact, impulse, work_friction, transferred, largest_slip);
    archive(work_damping, work_scheme, initial_potential, booked_from_outside, largest_brought);
    archive(largest_missed_gap, largest_gain, standard_change);
    archive(brought_by_meshes, largest_transfer, time_of_transfer);
    archive(n_mesh_changes, most_sticking, most_slipping, fewest_cells, most_cells);
    archive(n_impulse_solves, n_impulse_iterations, n_common_impulses, n_rejected, n_fallbacks);
    archive(iterations, saved_iterations);
    archive(first_contact, last_contact, n_contact_steps, phase, longest_phase);
    largest_contact.archive(archive);
  }


  std::string RunSummary::about_steps() const
  {
    const double error = error_of_steps.relative_error();
    if (!subject.has_inertia || !subject.own_tolerance.empty() || !error_of_steps.is_known())
      return "";
    std::ostringstream text;
    text << std::setprecision(2) << "  error by steps    " << about_per_cent(error)
         << " of the contact force (estimated; L2 in time)\n";
    if (error_of_steps.comes_from_earlier_contacts())
      text << "                    most of it because earlier contacts have errors, and later ones "
              "do not come in time\n";
    if (has_lost_phases)
      text
        << "                    without what long steps in flight have lost: bodies vibrated, and "
           "later contacts may be others\n";
    if (subject.target > 0. && error > missed * subject.target)
      text << "                    the target was " << 100. * subject.target
           << " %: give a `Time/Step size` of about " << std::setprecision(1)
           << mean_step * subject.target / error
           << (subject.steps_for_target ? "\n" : ", or `Step size control = goal`\n");
    if (error > most_credible)
      text << "                    that is no more than a sign of steps that are much too long, or "
              "of a force that rings\n";
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
    if (subject.has_inertia && (work_damping != 0. || std::abs(work_scheme) > 1e-9 * scale()))
      text << "  damping           changed the energy by "
           << without_round_off(100. * relative(work_scheme)) << " % (of the scheme) and "
           << without_round_off(100. * relative(work_damping)) << " % (of the bodies)\n";
    if (subject.massless_contact_nodes)
      text << "                    (with the mass of the scheme; with the consistent one it "
              "changed by "
           << 100. * relative(standard_change) << " %)\n";
    if (first_contact >= 0.)
      text << "  contact           from " << first_contact << " to " << last_contact
           << ", largest force " << force_variation.largest() << ", impulse " << impulse
           << "\n                    in " << n_contact_steps << " steps, "
           << largest_contact.n_active << " of " << largest_contact.n_nodes
           << " nodes at the largest force; changed the energy by "
           << without_round_off(100. * relative(work_contact)) << " %\n"
           << "  oscillation       total variation of the force over twice its maximum: "
           << force_variation.measure() << "\n"
           << "  penetration       " << largest_penetration << " at most\n"
           << about_steps();
    else
      text << "  contact           none"
           << (force_variation.largest() > 0. ? about_unnoticed_forces(force_variation.largest())
                                              : "")
           << "\n";
    if (relative(largest_missed_gap) > hardly_missed)
      text << "  missed gaps       forces of contact between bodies times what is missed of their "
              "gaps: "
           << 100. * relative(largest_missed_gap) << " % of the energy in a step at most\n";
    if (saved_iterations > hardly_saved * iterations)
      text << "  separate bodies   " << 100. * saved_iterations / iterations
           << " % of the work in iterations left out: bodies that move freely, rest, or were "
              "solved before others\n";
    if (n_rejected > 0)
      text << "  rejected          " << n_rejected
           << " attempts at steps, which were repeated in parts, with another size or on another "
              "mesh\n";
    if (n_fallbacks > 0)
      text << "  fallbacks         " << n_fallbacks
           << " times another method had to solve what the first one could not\n";
    if (subject.friction)
      text << "  friction          dissipated " << -work_friction + 0. << ", at most "
           << most_sticking << " nodes sticking, " << most_slipping
           << " slipping, largest accumulated slip " << largest_slip << "\n";
    if (n_impulse_solves > 0)
      text << "  impulses          of single nodes in " << n_impulse_solves << " steps, "
           << static_cast<double>(n_impulse_iterations) / n_impulse_solves << " iterations each\n";
    return text.str();
  }
} // namespace signorini
