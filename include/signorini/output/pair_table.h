// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_pair_table_h
#define signorini_output_pair_table_h

#include <signorini/diagnostics/pair_contact.h>
#include <signorini/output/step_table.h>

#include <memory>

namespace signorini
{
  /**
   * pairs.csv: the contact of each pair, see PairContact, in columns pair_<k>_... with k = 0, 1,
   * ... in the order of `Contact/Pairs`.
   */
  template <int dim>
  class PairTable : public StepTable<dim>
  {
  public:
    PairTable(const std::string &directory, unsigned int n_pairs, MPI_Comm communicator);

    void use_mesh(const ObservedMesh<dim> &mesh, const State &state) override;
    void write(const State &state, const StepReport &report, bool is_due) override;
    std::vector<CsvTable *> files() override;

  private:
    CsvTable                         table;
    std::unique_ptr<PairReader<dim>> reader;
  };
} // namespace signorini

#endif
