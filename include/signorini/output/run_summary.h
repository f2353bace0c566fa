// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_run_summary_h
#define signorini_output_run_summary_h

#include <signorini/base/archive.h>
#include <signorini/diagnostics/oscillation.h>
#include <signorini/output/history.h>
#include <signorini/time/error_of_steps.h>

#include <string>
#include <vector>

namespace signorini
{
  /** What a run was about: it decides which lines its summary has. */
  struct RunSubject
  {
    bool        friction               = false;
    bool        massless_contact_nodes = false;
    std::string own_tolerance =
      {}; ///< the key with which the scheme controls its own error, if any
    unsigned int dimension   = 3;
    bool         has_inertia = true; ///< else what contact and scheme do to energies means nothing
    bool         may_gain    = true; ///< contact may add energy to the scheme
    double       before_end  = 0.;   ///< see force_before_end()
    double       target      = 0.;   ///< error of the contact force that is aimed at, if any
    bool         steps_for_target = false; ///< steps follow it already
    bool         damps_by_choice  = true;  ///< there is a key for what the scheme damps
  };

  /**
   * What a run amounts to, in words: extremes and sums over all steps, whether they are written
   * into the history or not, and what makes the results doubtful.
   */
  class RunSummary
  {
  public:
    explicit RunSummary(const RunSubject &subject)
      : subject(subject)
    {
    }

    /** The initial state. */
    void start(const HistoryRow &row);

    /** A step. */
    void add(const HistoryRow &row);

    /** The mesh was changed. @param cells on all processes */
    void change_mesh(unsigned long cells);

    /**
     * Change of the total energy since the start, relative to the largest energy that the bodies
     * have had or have been given until now: of their motion, or work from outside.
     */
    double relative_energy_change() const { return relative(change); }

    /**
     * The energy that changes are compared with: the largest one of the motion, or the largest
     * work from outside since the start, if that is more. The work of loads is what their potential
     * has lost, but for what their own changes did to it (booked as external, as is the work of
     * prescribed nodes and moving obstacles). For a free body this is the energy that it starts
     * with; what starts at rest, or is driven slowly, is measured by what drives it.
     */
    double scale() const;

    /** Kinetic and elastic. */
    double largest_energy_of_motion() const { return largest_energy; }

    /** Energy balance, contact and oscillation. */
    std::string text() const;

    /** What makes the results doubtful, a sentence each; none if nothing does. */
    std::vector<std::string> warnings() const;

    /** The run so far. */
    void archive(Archive &archive);

  private:
    const RunSubject subject;
    TotalVariation   force_variation;
    ErrorOfSteps     error_of_steps;

    double initial_energy = 0., largest_energy = 0., change = 0., largest_change = 0.,
           largest_residual = 0., largest_penetration = 0., work_contact = 0., impulse = 0.,
           work_friction = 0., transferred = 0., largest_slip = 0.;
    double        work_damping = 0., work_scheme = 0.;
    double        initial_potential   = 0.; ///< of the loads, where the bodies are at the start
    double        booked_from_outside = 0., largest_brought = 0.; ///< see scale()
    double        largest_missed_gap = 0.; ///< StepReport::work_geometry of a step, its size
    double        largest_gain       = 0.; ///< by contact and friction in a step
    double        brought_by_meshes  = 0.; ///< sum of what changes of the mesh gained
    double        largest_transfer = 0., time_of_transfer = 0.; ///< the most by one of them
    double        standard_change = 0.; ///< change of the total energy with the consistent mass
    double        iterations = 0., saved_iterations = 0.; ///< of StepReport::corrector
    unsigned int  n_mesh_changes = 0, most_sticking = 0, most_slipping = 0;
    unsigned long fewest_cells = 0, most_cells = 0;
    /** Of laursen-love, per node. */
    unsigned int n_impulse_solves = 0, n_impulse_iterations = 0, n_common_impulses = 0;
    unsigned int n_rejected = 0, n_fallbacks = 0;
    double       mean_step = 0.; ///< in contact
    /** In flight between contacts, since the last one and before it: steps that lose vibrations. */
    bool           loses_phases = false, has_lost_phases = false;
    double         first_contact = -1., last_contact = -1.;
    unsigned int   n_contact_steps = 0, phase = 0, longest_phase = 0; ///< steps with contact
    ContactSummary largest_contact;                                   ///< at the largest force

    double relative(double energy) const;
    void   add_contact(const HistoryRow &row);
    /** Warnings of what changes of the mesh did to the energy. */
    std::vector<std::string> about_meshes() const;
    /** A line on the error of the contact force by the steps. */
    std::string about_steps() const;
  };
} // namespace signorini

#endif
