// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/momentum.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  namespace
  {
    std::array<double, 3> sum_over_processes(const std::array<double, 3> &values,
                                             const MPI_Comm               communicator)
    {
      std::array<double, 3> sums;
      dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(values.data(), 3),
                                  communicator,
                                  dealii::ArrayView<double>(sums.data(), 3));
      return sums;
    }
  } // namespace


  template <int dim>
  std::array<double, 3> resultant(const Discretization<dim> &discretization, const Vector &forces)
  {
    std::array<double, 3> sum{};
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        sum[c] += forces.local_element(dim * node + c);
    return sum_over_processes(sum, discretization.communicator());
  }


  template <int dim>
  Momentum momentum(const Discretization<dim> &discretization,
                    const State               &state,
                    const Vector              *displacement)
  {
    Momentum result;
    result.linear = resultant(discretization, state.momentum);
    std::array<double, 3> angular{};
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      {
        std::array<double, 3> x{}, p{};
        for (unsigned int c = 0; c < dim; ++c)
          {
            x[c] = discretization.node_positions()[node][c];
            if (displacement != nullptr)
              x[c] += displacement->local_element(dim * node + c);
            p[c] = state.momentum.local_element(dim * node + c);
          }
        for (unsigned int c = 0; c < 3; ++c)
          angular[c] += x[(c + 1) % 3] * p[(c + 2) % 3] - x[(c + 2) % 3] * p[(c + 1) % 3];
      }
    result.angular = sum_over_processes(angular, discretization.communicator());
    return result;
  }


  template Momentum              momentum(const Discretization<2> &, const State &, const Vector *);
  template Momentum              momentum(const Discretization<3> &, const State &, const Vector *);
  template std::array<double, 3> resultant(const Discretization<2> &, const Vector &);
  template std::array<double, 3> resultant(const Discretization<3> &, const Vector &);
} // namespace signorini
