// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_observation_h
#define signorini_simulation_observation_h

#include <signorini/diagnostics/oscillation.h>
#include <signorini/output/history.h>
#include <signorini/simulation/meshed_scene.h>

#include <deal.II/base/timer.h>

namespace signorini
{
  /**
   * Watches the motion: evaluates all diagnostics after each step, writes the tables, and sums up
   * at the end.
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

    void observe(const State &state, const StepReport &report);

    const ContactSummary &contact() const { return contact_now; }

    /** Kinetic and elastic energy. */
    double energy_of_motion() const { return ledger.current().kinetic + ledger.current().elastic; }

    /**
     * Change of the total energy since the start, relative to the initial one (to that of the
     * motion if that is tiny).
     */
    double relative_energy_change() const;

    /** Writing of fields does not count as time of the run. */
    void pause_clock() { clock.stop(); }
    void resume_clock() { clock.start(); }

    /** Energy balance, contact and oscillation in words. */
    std::string summary() const;

  private:
    const Scene<dim>       &scene;
    MeshedScene<dim>       *meshed;
    std::vector<Probe<dim>> probes;
    History<dim>            history;
    EnergyLedger            ledger;
    ErrorEvaluation<dim>    errors;
    ContactSummary          contact_now;
    Momentum                initial_momentum;
    TotalVariation          force_variation;
    std::vector<Zigzag>     velocity_zigzags;
    dealii::Timer           clock;
    ProductCount
      products_before; ///< at the end of the last observation, whose own products do not count

    double largest_energy = 0., largest_change = 0., largest_residual = 0.,
           largest_penetration = 0., deepest = 0., farthest_sliding = 0., impulse = 0.;
    double        work_friction = 0., transferred = 0.;
    unsigned int  n_mesh_changes = 0;
    unsigned long fewest_cells = 0, most_cells = 0;
    unsigned int  most_sticking = 0, most_slipping = 0;
    double        standard_change = 0.; ///< change of the total energy with the consistent mass
    /** Of laursen-love, per node. */
    unsigned int n_impulse_solves = 0, n_impulse_iterations = 0, n_common_impulses = 0;
    double       first_contact = -1., last_contact = -1.;
    ErrorNorms   latest_errors;

    void write(const State &state, const StepReport &report, const EnergyBooking &booking);
    /** What makes the results doubtful, in words; empty if nothing does. */
    std::string warnings() const;
    /** The energy that changes are compared with. */
    double relative_scale() const;
    /** Products since the last observation. */
    ProductCount                   products_of_step() const;
    static std::vector<Probe<dim>> make_probes(const Scene<dim>       &scene,
                                               const MeshedScene<dim> &meshed);
  };
} // namespace signorini

#endif
