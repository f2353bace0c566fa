// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mass/owned_rows.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

namespace signorini
{
  template <int dim>
  MassChange sum_of_owned_rows(const MassChange                          &contributions,
                               const dealii::Utilities::MPI::Partitioner &partitioner)
  {
    using Entry =
      std::pair<std::pair<dealii::types::global_dof_index, dealii::types::global_dof_index>,
                double>;
    MassChange sums;
    for (const auto &part : dealii::Utilities::MPI::all_gather(
           partitioner.get_mpi_communicator(),
           std::vector<Entry>(contributions.begin(), contributions.end())))
      for (const auto &[entry, value] : part)
        if (partitioner.in_local_range(dim * entry.first))
          sums[entry] += value;
    return sums;
  }


  template MassChange sum_of_owned_rows<2>(const MassChange &,
                                           const dealii::Utilities::MPI::Partitioner &);
  template MassChange sum_of_owned_rows<3>(const MassChange &,
                                           const dealii::Utilities::MPI::Partitioner &);
} // namespace signorini
