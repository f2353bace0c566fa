// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_force_table_h
#define signorini_output_force_table_h

#include <signorini/diagnostics/force_balance.h>
#include <signorini/finite_elements/boundary_stress.h>
#include <signorini/output/step_table.h>

namespace signorini
{
  /**
   * forces.csv: the contact force on each body by three routes, in columns
   * force_<body>_multiplier_..., _stress_..., _momentum_..., and _spread, the largest distance
   * between two of the three over the longest.
   */
  template <int dim>
  class ForceTable : public StepTable<dim>
  {
  public:
    /**
     * @param balance          of momentum
     * @param force_before_end when the contact force of a step acts, before its end, as a part of
     *                         the step: the stress is that of this instant
     */
    ForceTable(const std::string                       &directory,
               const std::vector<BodyDescription<dim>> &bodies,
               const ForceBalance<dim>                 &balance,
               double                                   force_before_end,
               MPI_Comm                                 communicator);

    void use_mesh(const ObservedMesh<dim> &mesh, const State &state) override;
    void write(const State &state, const StepReport &report, bool is_due) override;
    std::vector<CsvTable *> files() override;

  private:
    CsvTable                              table;
    ForceBalance<dim>                     balance;
    const double                          force_before_end;
    std::function<const Vector *(double)> load;
    std::unique_ptr<BoundaryStress<dim>>  stress;
    Vector                                displacement_before;
  };
} // namespace signorini

#endif
