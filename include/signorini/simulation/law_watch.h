// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_law_watch_h
#define signorini_simulation_law_watch_h

#include <signorini/diagnostics/body_motion.h>
#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/energy_ledger.h>
#include <signorini/diagnostics/force_balance.h>
#include <signorini/diagnostics/law_guard.h>
#include <signorini/output/run_log.h>
#include <signorini/simulation/meshed_scene.h>

namespace signorini
{
  /** The laws that a scene's scheme keeps; those of momentum and penetration only where they hold.
   */
  template <int dim>
  std::set<Law> proved_laws(const Scene<dim> &scene);

  /** What becomes of broken laws: the run stops, or the log warns. @throws RunError */
  void heed(const std::vector<std::string> &diagnoses, GuardAction action, RunLog &log);

  /** Reads after each step how far it is from the laws of its scheme. */
  template <int dim>
  class LawWatch
  {
  public:
    explicit LawWatch(const Scene<dim> &scene);

    /** Begin with a state, also on a new mesh, which must live until the next one. Collective. */
    void start(MeshedScene<dim> &meshed, const BodyMotion<dim> &motion, const State &state);

    /**
     * Of a step that led to a state. Collective.
     * @param largest_energy of the motion, or brought from outside
     */
    LawReading read(const State          &state,
                    const StepReport     &report,
                    const EnergyBooking  &booking,
                    const ContactSummary &contact,
                    double                largest_energy);

    /** What it remembers of earlier steps. */
    void archive(Archive &archive) { archive(largest_force, largest_flow); }

    /** See LawGuard. */
    std::vector<std::string> judge(const LawReading &reading) { return guard.judge(reading); }

  private:
    const bool          has_inertia;
    MeshedScene<dim>   *meshed = nullptr;
    std::vector<double> masses; ///< of the bodies
    ForceBalance<dim>   balance;
    LawGuard            guard;
    double              largest_force           = 0.; ///< of a contact node, in the whole run
    double              largest_flow            = 0.; ///< of energy in a step, in the whole run
    double              courant_number_per_time = 0.; ///< zero without inertia

    /**
     * Of a body whose nodes move by the round-off of its size in the time of a wave through the
     * smallest cell: nothing that has less of it moves.
     */
    double energy_of_round_off() const;
    double momentum_residual(const State &state, const StepReport &report, double energy_scale);
  };
} // namespace signorini

#endif
