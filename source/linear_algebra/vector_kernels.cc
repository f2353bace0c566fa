// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>

#include <deal.II/base/mpi.h>

#include <array>

namespace signorini
{
  double dot(const Vector &x, const Vector &y)
  {
    AssertDimension(x.locally_owned_size(), y.locally_owned_size());
    // Several partial sums let the compiler use vector registers without changing the order of a
    // sum.
    constexpr unsigned int      n_lanes = 16;
    std::array<double, n_lanes> sums{};
    const double               *a = x.begin(), *b = y.begin();
    const unsigned int          n = x.locally_owned_size();
    unsigned int                i = 0;
    for (; i + n_lanes <= n; i += n_lanes)
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        sums[lane] += a[i + lane] * b[i + lane];
    double sum = 0.;
    for (; i < n; ++i)
      sum += a[i] * b[i];
    for (const double partial : sums)
      sum += partial;
    return dealii::Utilities::MPI::sum(sum, x.get_mpi_communicator());
  }


  void advance(const double factor, const Vector &p, Vector &x, const Vector &q, Vector &r)
  {
    AssertDimension(x.locally_owned_size(), p.locally_owned_size());
    AssertDimension(r.locally_owned_size(), q.locally_owned_size());
    AssertDimension(r.locally_owned_size(), x.locally_owned_size());
    // Without `restrict` the compiler would have to fear that one vector overwrites another.
    const double *__restrict direction = p.begin(), *__restrict product = q.begin();
    double *__restrict solution = x.begin(), *__restrict residual = r.begin();
    const unsigned int n = x.locally_owned_size();
    for (unsigned int i = 0; i < n; ++i)
      {
        solution[i] += factor * direction[i];
        residual[i] -= factor * product[i];
      }
  }


  void extend_direction(const Vector &z, const double factor, Vector &p)
  {
    AssertDimension(p.locally_owned_size(), z.locally_owned_size());
    const double *__restrict source = z.begin();
    double *__restrict direction    = p.begin();
    const unsigned int n            = p.locally_owned_size();
    for (unsigned int i = 0; i < n; ++i)
      direction[i] = source[i] + factor * direction[i];
  }
} // namespace signorini
