// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_step_tables_h
#define signorini_simulation_step_tables_h

#include <signorini/output/step_table.h>
#include <signorini/simulation/meshed_scene.h>

#include <memory>

namespace signorini
{
  /** The tables beside history.csv that a scene asks for. All functions are collective. */
  template <int dim>
  class StepTables
  {
  public:
    StepTables(const Scene<dim> &scene, MPI_Comm communicator);

    /** See StepTable. Mesh and motion must live until the next mesh. */
    void use_mesh(MeshedScene<dim> &meshed, const BodyMotion<dim> &motion, const State &state);
    void write(const State &state, const StepReport &report, bool is_due);
    void finish();
    /** See CsvTable. */
    void archive(Archive &archive);

  private:
    std::vector<std::unique_ptr<StepTable<dim>>> tables;
  };
} // namespace signorini

#endif
