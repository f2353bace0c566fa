// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/level_vector.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  using namespace dealii;

  GhostValues::GhostValues(const LocalNodes &nodes, const MPI_Comm communicator)
    : n_owned(nodes.n_owned)
    , alone(Utilities::MPI::n_mpi_processes(communicator) == 1)
  {
    const auto n_nodes = Utilities::MPI::sum(types::global_dof_index(nodes.n_owned), communicator);
    IndexSet   owned(4 * n_nodes), others(4 * n_nodes);
    owned.add_range(4 * nodes.first_owned, 4 * (nodes.first_owned + nodes.n_owned));
    for (const auto ghost : nodes.ghosts)
      others.add_range(4 * ghost, 4 * (ghost + 1));
    others.compress();
    partitioner = std::make_shared<Utilities::MPI::Partitioner>(owned, others, communicator);
  }


  template <typename Number>
  void GhostValues::fetch(const LevelVector<Number> &vector) const
  {
    if (alone)
      return;
    auto &[values, storage] = buffer<Number>();
    storage.resize(partitioner->n_import_indices());
    std::vector<MPI_Request> requests;
    partitioner->export_to_ghosted_array_start(0,
                                               ArrayView<const Number>(vector.data(), 4 * n_owned),
                                               ArrayView<Number>(storage.data(), storage.size()),
                                               ArrayView<Number>(values.data(), values.size()),
                                               requests);
    partitioner->export_to_ghosted_array_finish(ArrayView<Number>(values.data(), values.size()),
                                                requests);
  }


  std::vector<char> GhostValues::with_ghosts(const std::vector<char> &flags) const
  {
    LevelVector<float> numbers(4 * n_owned);
    for (unsigned int node = 0; node < n_owned; ++node)
      numbers[4 * node] = flags[node];
    fetch(numbers);
    std::vector<char> result = flags;
    for (unsigned int i = 0; i < buffer<float>().values.size(); i += 4)
      result.push_back(buffer<float>().values[i] != 0.F);
    return result;
  }


  template <typename Number>
  void GhostValues::add_to_owners(LevelVector<Number> &vector) const
  {
    if (alone)
      return;
    auto &[values, storage] = buffer<Number>();
    storage.resize(partitioner->n_import_indices());
    std::vector<MPI_Request> requests;
    partitioner->import_from_ghosted_array_start(VectorOperation::add,
                                                 0,
                                                 ArrayView<Number>(values.data(), values.size()),
                                                 ArrayView<Number>(storage.data(), storage.size()),
                                                 requests);
    partitioner->import_from_ghosted_array_finish(
      VectorOperation::add,
      ArrayView<const Number>(storage.data(), storage.size()),
      ArrayView<Number>(vector.data(), 4 * n_owned),
      ArrayView<Number>(values.data(), values.size()),
      requests);
  }


  template void GhostValues::fetch(const LevelVector<float> &) const;
  template void GhostValues::fetch(const LevelVector<double> &) const;
  template void GhostValues::add_to_owners(LevelVector<float> &) const;
  template void GhostValues::add_to_owners(LevelVector<double> &) const;
} // namespace signorini
