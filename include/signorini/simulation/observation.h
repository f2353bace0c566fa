// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_observation_h
#define signorini_simulation_observation_h

#include <signorini/diagnostics/alternation.h>
#include <signorini/diagnostics/body_motion.h>
#include <signorini/diagnostics/missing_pairs.h>
#include <signorini/diagnostics/oscillation.h>
#include <signorini/diagnostics/turning_normals.h>
#include <signorini/diagnostics/unseen_overlap.h>
#include <signorini/diagnostics/validity.h>
#include <signorini/output/history.h>
#include <signorini/output/run_summary.h>
#include <signorini/simulation/law_watch.h>
#include <signorini/simulation/step_tables.h>

#include <deal.II/base/timer.h>

namespace signorini
{
  /**
   * Watches the motion: evaluates all diagnostics after each step and writes the tables.
   */
  template <int dim>
  class Observation
  {
  public:
    /** The scene must outlive the observation. */
    Observation(const Scene<dim> &scene, MeshedScene<dim> &meshed);

    void start(const State &state);

    /** Go on with what was built on a changed mesh, and with the state on it. */
    void change_mesh(MeshedScene<dim> &meshed, const State &state);

    /** Go on with what was built anew on the same mesh, and with the same state. */
    void go_on(MeshedScene<dim> &meshed, const State &state);

    /** All that was observed so far. Collective. */
    void archive(Archive &archive);

    /**
     * @param is_last the run ends with this step
     * @return what begins to be doubtful with it, see Validity and MissingPairs
     */
    std::vector<std::string> observe(const State &state, const StepReport &report, bool is_last);

    /** The run ends early: the last step gets its rows, whether they were due or not. */
    void finish();

    /** The laws of the scheme that the latest step is the first one to break, a diagnosis each. */
    const std::vector<std::string> &broken_laws() const { return broken; }

    const ContactSummary &contact() const { return contact_now; }

    /** Kinetic and elastic energy. */
    MotionEnergies energies() const
    {
      return {ledger.current().kinetic + ledger.current().elastic, ledger.current().elastic};
    }

    /** See RunSummary. */
    double relative_energy_change() const { return run_summary.relative_energy_change(); }

    /** Writing of fields does not count as time of the run. */
    void pause_clock() { clock.stop(); }
    void resume_clock() { clock.start(); }

    /** The run in words, when it has ended. */
    std::string summary() const;

    /** What makes its results doubtful, a sentence each. */
    std::vector<std::string> warnings() const;

  private:
    const Scene<dim>        &scene;
    MeshedScene<dim>        *meshed;
    std::vector<Probe<dim>>  probes;
    History<dim>             history;
    EnergyLedger             ledger;
    ErrorEvaluation<dim>     errors;
    ContactSummary           contact_now;
    Momentum                 initial_momentum;
    RunSummary               run_summary;
    LawWatch<dim>            law_watch;
    std::vector<std::string> broken;
    BodyMotion<dim>          body_motion;
    StepTables<dim>          tables;
    Validity                 validity;
    MissingPairs<dim>        missing_pairs;
    UnseenOverlap<dim>       unseen_overlap;
    std::vector<double>      strains; ///< of the bodies, when they were last evaluated
    double                   energy_of_strains = 0.; ///< elastic, at that time
    std::vector<Zigzag>      velocity_zigzags;
    Alternation              alternation;         ///< of contact nodes
    Alternation              of_prescribed{true}; ///< of prescribed ones
    TurningNormals<dim>      turning_normals;
    dealii::Timer            clock;
    double                   earlier_time = 0.; ///< on the clock, before the run was resumed
    ProductCount
      products_before; ///< at the end of the last observation, whose own products do not count

    ErrorNorms latest_errors;

    void       use(MeshedScene<dim> &new_meshed, const State &state);
    HistoryRow evaluate(const State &state, const StepReport &report, const EnergyBooking &booking);
    /** Into all tables, if it is time to. */
    void write(const HistoryRow &row, bool always);
    /** In a run that starts in equilibrium, its reactions; else nothing. */
    StepReport report_of_start(const State &state);
    /** With the consistent mass, whatever the mass of the scheme. */
    double standard_kinetic_energy(const State &state) const;
    /** At the present positions where contact follows the motion. */
    Momentum momentum_of(const State &state) const;
    /** What the method takes to be small. */
    ValidityReading validity_reading(const State &state);
    /** Products since the last observation. */
    ProductCount                   products_of_step() const;
    static std::vector<Probe<dim>> make_probes(const Scene<dim>       &scene,
                                               const MeshedScene<dim> &meshed);
  };
} // namespace signorini

#endif
