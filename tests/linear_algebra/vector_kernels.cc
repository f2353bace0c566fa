// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The fused loops compute what their formulas say, for owned entries only: ghosts must not be
// counted twice.

#include <signorini/linear_algebra/vector_kernels.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  constexpr unsigned int n = 37; // not a multiple of the lanes

  /**
   * Entries of this process are offset ... offset + n; the first entry of the next process is a
   * ghost.
   */
  Vector make_vector(const double a, const double b)
  {
    const auto       rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const auto       size = n * dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    dealii::IndexSet owned(size), ghosts(size);
    owned.add_range(n * rank, n * (rank + 1));
    ghosts.add_index(n * (rank + 1) % size);
    ghosts.subtract_set(owned);
    Vector result(owned, ghosts, MPI_COMM_WORLD);
    for (const auto i : owned)
      result(i) = std::cos(a * i + b);
    result.update_ghost_values();
    return result;
  }
} // namespace

TEST(VectorKernels, Dot)
{
  const Vector x = make_vector(1., 0.), y = make_vector(0.3, 2.);
  double       sum = 0.;
  for (unsigned int i = 0; i < x.size(); ++i)
    sum += std::cos(i) * std::cos(0.3 * i + 2.);
  EXPECT_NEAR(dot(x, y), sum, 1e-13);
}

TEST(VectorKernels, AdvanceAndExtendDirection)
{
  const Vector p = make_vector(1., 0.), q = make_vector(2., 1.), z = make_vector(3., 2.);
  Vector       x = make_vector(4., 3.), r = make_vector(5., 4.), direction = p;
  advance(0.7, p, x, q, r);
  extend_direction(z, -0.2, direction);
  for (const auto i : x.locally_owned_elements())
    {
      EXPECT_NEAR(x(i), std::cos(4. * i + 3.) + 0.7 * std::cos(1. * i), 1e-15);
      EXPECT_NEAR(r(i), std::cos(5. * i + 4.) - 0.7 * std::cos(2. * i + 1.), 1e-15);
      EXPECT_NEAR(direction(i), std::cos(3. * i + 2.) - 0.2 * std::cos(1. * i), 1e-15);
    }
}
