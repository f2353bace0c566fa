// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_point_probe_table_h
#define signorini_output_point_probe_table_h

#include <signorini/output/point_probe.h>
#include <signorini/output/step_table.h>

#include <memory>

namespace signorini
{
  /**
   * probe_<name>.csv for each probe in a body, see PointReading. Like the tables of contact probes
   * they begin with the time.
   */
  template <int dim>
  class PointProbeTable : public StepTable<dim>
  {
  public:
    PointProbeTable(const std::string                             &directory,
                    const std::vector<PointProbeDescription<dim>> &descriptions,
                    MPI_Comm                                       communicator);

    void use_mesh(const ObservedMesh<dim> &mesh, const State &state) override;
    void write(const State &state, const StepReport &report, bool is_due) override;
    std::vector<CsvTable *> files() override;

  private:
    const std::vector<PointProbeDescription<dim>> descriptions;
    std::vector<std::unique_ptr<CsvTable>>        tables;
    std::vector<PointProbe<dim>>                  probes;
    const Discretization<dim>                    *discretization = nullptr;
  };
} // namespace signorini

#endif
