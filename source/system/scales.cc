// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/scales.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace signorini
{
  double response_size(const LinearOperator            &matrix,
                       MaskedPreconditioner            &preconditioner,
                       const Vector                    &right_hand_side,
                       const std::vector<unsigned int> &prescribed_entries,
                       const std::vector<double>       &prescribed_values)
  {
    AssertDimension(prescribed_values.size(), prescribed_entries.size());
    Vector response(right_hand_side), force(right_hand_side);
    response = 0.;
    Mask mask(response.locally_owned_size(), 0);
    for (std::size_t j = 0; j < prescribed_entries.size(); ++j)
      {
        response.local_element(prescribed_entries[j]) = prescribed_values[j];
        mask[prescribed_entries[j]]                   = 1;
      }
    matrix.vmult(force, response);
    force.sadd(-1., 1., right_hand_side);
    preconditioner.set_mask(mask);
    preconditioner.vmult(response, force);
    return std::sqrt(std::max(0., dot(response, force)));
  }


  double rough_response_size(const LinearOperator            &matrix,
                             const Vector                    &right_hand_side,
                             const std::vector<unsigned int> &prescribed_entries,
                             const std::vector<double>       &prescribed_values)
  {
    Vector diagonal(right_hand_side.get_partitioner());
    matrix.diagonal(diagonal);
    double square = 0.;
    for (unsigned int i = 0; i < diagonal.locally_owned_size(); ++i)
      {
        const double force = right_hand_side.local_element(i);
        square += force * force / diagonal.local_element(i);
      }
    for (std::size_t j = 0; j < prescribed_entries.size(); ++j)
      {
        const double value = prescribed_values[j];
        square += diagonal.local_element(prescribed_entries[j]) * value * value;
      }
    return std::sqrt(dealii::Utilities::MPI::sum(square, diagonal.get_mpi_communicator()));
  }
} // namespace signorini
