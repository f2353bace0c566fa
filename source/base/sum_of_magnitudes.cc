// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/sum_of_magnitudes.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace signorini
{
  double sum_of_magnitudes(const Vector &vector, const unsigned int n_components)
  {
    AssertDimension(vector.locally_owned_size() % n_components, 0);
    double sum = 0.;
    for (unsigned int first = 0; first < vector.locally_owned_size(); first += n_components)
      {
        double square = 0.;
        for (unsigned int i = first; i < first + n_components; ++i)
          square += vector.local_element(i) * vector.local_element(i);
        sum += std::sqrt(square);
      }
    return dealii::Utilities::MPI::sum(sum, vector.get_mpi_communicator());
  }
} // namespace signorini
