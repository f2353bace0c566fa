// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/variational_inequality/status_record.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace signorini
{
  unsigned int StatusRecord::n_closed(const ActiveSet &status) const
  {
    const auto n = std::count_if(status.begin(), status.end(), contact_status::is_closed);
    return dealii::Utilities::MPI::sum(static_cast<unsigned int>(n), like.get_mpi_communicator());
  }


  std::uint64_t StatusRecord::fingerprint(const ActiveSet &status) const
  {
    const auto    first = like.get_partitioner()->local_range().first;
    std::uint64_t sum   = 0;
    for (std::size_t k = 0; k < status.size(); ++k)
      if (status[k] != contact_status::open)
        {
          std::uint64_t x = (static_cast<std::uint64_t>(first) << 32) + 4 * k + status[k]
                            + 0x9e3779b97f4a7c15ull; // splitmix64
          x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
          x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
          sum += x ^ (x >> 31);
        }
    return dealii::Utilities::MPI::sum(sum, like.get_mpi_communicator());
  }
} // namespace signorini
