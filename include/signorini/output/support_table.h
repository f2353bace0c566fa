// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_support_table_h
#define signorini_output_support_table_h

#include <signorini/diagnostics/supports.h>
#include <signorini/output/step_table.h>

#include <memory>

namespace signorini
{
  /**
   * supports.csv: the force of each part of a boundary with prescribed displacements on its body,
   * support_<body>_<id>_x, ..., see add_support_force() for what it means in time. Zero at the
   * start, as contact forces are, unless the run starts in equilibrium.
   */
  template <int dim>
  class SupportTable : public StepTable<dim>
  {
  public:
    /** @param mean_contact_force whether the contact force of a step is the mean of both ends */
    SupportTable(const std::string                       &directory,
                 const std::vector<BodyDescription<dim>> &bodies,
                 bool                                     mean_contact_force,
                 MPI_Comm                                 communicator);

    void use_mesh(const ObservedMesh<dim> &mesh, const State &state) override;
    void write(const State &state, const StepReport &report, bool is_due) override;
    std::vector<CsvTable *> files() override;

  private:
    using Forces = typename Supports<dim>::Forces;

    CsvTable                       table;
    const bool                     mean_contact_force;
    std::unique_ptr<Supports<dim>> supports;
    Forces                         handed_on_before; ///< at the start of the step
  };
} // namespace signorini

#endif
