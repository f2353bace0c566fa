// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_history_h
#define signorini_output_history_h

#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/energy_ledger.h>
#include <signorini/diagnostics/error_norms.h>
#include <signorini/diagnostics/momentum.h>
#include <signorini/diagnostics/probe.h>
#include <signorini/output/csv_table.h>

#include <memory>
#include <vector>

namespace signorini
{
  /** One row of history.csv: what is known about a state and about the step that led to it. */
  struct HistoryRow
  {
    const State  &state;
    unsigned long cells = 0, dofs = 0;
    Energy        energy                  = {}; ///< with the mass of the scheme
    double        standard_kinetic_energy = 0.; ///< with the consistent mass
    EnergyBooking booking                 = {};
    Momentum      momentum                = {};
    double        angular_momentum_drift = 0.; ///< |change of the angular momentum since the start|
    ContactSummary contact               = {};
    StepReport     report                = {};
    ProductCount   products              = {}; ///< matrix-vector products of this step
    double         wall_time             = 0.;
    ErrorNorms     errors                = {}; ///< written only if the scene has an exact solution
  };

  /** What adds up over steps. */
  struct StepSums
  {
    EnergyBooking booking;
    ProductCount  products;
    unsigned int  active_set_iterations = 0, linear_iterations = 0, predictor_iterations = 0;
    unsigned int  rejected_steps = 0, fallbacks = 0;

    void add(const HistoryRow &row);
  };

  /**
   * The table history.csv, and probe_<name>.csv for each probe, with slip if there is friction.
   * All functions are collective.
   */
  template <int dim>
  class History
  {
  public:
    History(const std::string             &directory,
            bool                           with_errors,
            bool                           with_friction,
            const std::vector<Probe<dim>> &probes,
            MPI_Comm                       communicator);

    /**
     * @param is_due else the step has no row of its own (see CsvTable), and what adds up is part of
     * the next one
     */
    void write(const HistoryRow &row, bool is_due);
    void write_probe(unsigned int probe, double time, const ProbeReading &reading, bool is_due);
    void finish();
    /** See CsvTable; and what the next row is going to sum. */
    void archive(Archive &archive);

  private:
    const bool                             with_errors, with_friction;
    StepSums                               since_last_row;
    std::unique_ptr<CsvTable>              history;
    std::vector<std::unique_ptr<CsvTable>> probe_tables;
  };
} // namespace signorini

#endif
