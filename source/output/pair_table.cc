// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/pair_table.h>

namespace signorini
{
  namespace
  {
    std::vector<std::string> columns_of_pairs(const unsigned int n_pairs)
    {
      std::vector<std::string> names = {"step", "time"};
      for (unsigned int k = 0; k < n_pairs; ++k)
        {
          const std::string pair = "pair_" + std::to_string(k) + "_";
          add_vector_columns(pair + "force", names);
          add_vector_columns(pair + "moment", names);
          for (const char *quantity : {"normal_force",
                                       "friction_force",
                                       "active_nodes",
                                       "smallest_gap",
                                       "max_penetration",
                                       "depth"})
            names.push_back(pair + quantity);
        }
      return names;
    }
  } // namespace


  template <int dim>
  PairTable<dim>::PairTable(const std::string &directory,
                            const unsigned int n_pairs,
                            const MPI_Comm     communicator)
    : table(directory + "/pairs.csv", columns_of_pairs(n_pairs), communicator)
  {
  }


  template <int dim>
  void PairTable<dim>::use_mesh(const ObservedMesh<dim> &mesh, const State & /*state*/)
  {
    reader = std::make_unique<PairReader<dim>>(mesh.discretization, mesh.surface);
  }


  template <int dim>
  void PairTable<dim>::write(const State &state, const StepReport & /*report*/, const bool is_due)
  {
    std::vector<double> values = {static_cast<double>(state.step), state.time};
    for (const PairContact &pair : reader->read(state))
      {
        add_values(pair.force, values);
        add_values(pair.moment, values);
        values.insert(values.end(),
                      {pair.normal_force,
                       pair.friction_force,
                       static_cast<double>(pair.n_active),
                       pair.smallest_gap,
                       pair.max_penetration,
                       pair.depth});
      }
    table.write_row(values, is_due);
  }


  template <int dim>
  std::vector<CsvTable *> PairTable<dim>::files()
  {
    return {&table};
  }


  template class PairTable<2>;
  template class PairTable<3>;
} // namespace signorini
