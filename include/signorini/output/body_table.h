// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_body_table_h
#define signorini_output_body_table_h

#include <signorini/output/step_table.h>

namespace signorini
{
  /** bodies.csv: energies, momenta and the place of each body, see BodyReading, in columns
   * body_<name>_... */
  template <int dim>
  class BodyTable : public StepTable<dim>
  {
  public:
    BodyTable(const std::string                       &directory,
              const std::vector<BodyDescription<dim>> &bodies,
              MPI_Comm                                 communicator);

    void use_mesh(const ObservedMesh<dim> &mesh, const State &state) override;
    void write(const State &state, const StepReport &report, bool is_due) override;
    std::vector<CsvTable *> files() override;

  private:
    CsvTable               table;
    const BodyMotion<dim> *motion = nullptr;
  };
} // namespace signorini

#endif
