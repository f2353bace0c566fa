// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_energy_ledger_h
#define signorini_diagnostics_energy_ledger_h

#include <signorini/base/archive.h>
#include <signorini/time/time_scheme.h>

#include <functional>

namespace signorini
{
  /** Energy of a state, E = 1/2 v'Mv + 1/2 u'Au - f'u. */
  struct Energy
  {
    double kinetic = 0., elastic = 0.;
    double external = 0.; ///< -f(t)'u

    double total() const { return kinetic + elastic + external; }
  };

  /**
   * Where the energy of one step went. The residual is what no other entry explains: the error of
   * the solver.
   */
  struct EnergyBooking
  {
    double contact   = 0.;
    double predictor = 0.;
    double friction  = 0.;
    double damping   = 0.; ///< viscous, of the bodies
    double scheme    = 0.; ///< by the rule of integration itself: numerical dissipation
    double external  = 0.; ///< work of prescribed nodes and moving obstacles, and change of loads:
                           ///< -(f_new - f)'(u + u_new)/2
    double geometry = 0.;  ///< in no balance: see StepReport::work_geometry
    double transfer = 0.;  ///< change by a new mesh
    double residual = 0.;

    /** Go on with the next step. */
    EnergyBooking &operator+=(const EnergyBooking &next);
  };

  /**
   * Accounts for every joule: balances the energies of consecutive states against the work that
   * the scheme reports.
   */
  class EnergyLedger
  {
  public:
    using ElasticEnergy = std::function<double(const State &)>;

    /** With u'Au/2 as the state has it. */
    EnergyLedger();

    /** @param elastic the elastic energy of a state, for who knows it better */
    explicit EnergyLedger(ElasticEnergy elastic)
      : elastic(std::move(elastic))
    {
    }

    /** Open the ledger with the initial state. `load`: f at its time, null without loads. */
    void open(const State &state, const Vector *load);

    /**
     * Take over a state that a new mesh has changed. What this did to the energy is booked with
     * the next step.
     */
    void transfer(const State &state, const Vector *load);

    /** Book a step. */
    EnergyBooking book(const State &state, const StepReport &report, const Vector *load);

    /** The balance so far, without the vectors. */
    void archive(Archive &archive) { archive(first, last, transferred); }

    /** Go on with a state whose energy is known: on the same mesh, made anew. */
    void go_on(const State &state, const Vector *load) { remember(state, load); }

    const Energy &initial() const { return first; }
    const Energy &current() const { return last; }

  private:
    ElasticEnergy elastic;
    Energy        first, last;
    double        transferred = 0.;             ///< by new meshes since the last step
    Vector        last_load, last_displacement; ///< kept only with loads

    Energy evaluate(const State &state, const Vector *load) const;
    void   remember(const State &state, const Vector *load);
  };
} // namespace signorini

#endif
