// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/variational_inequality/attainable_norm.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace signorini
{
  double attainable_norm(const ConstrainedProblem &problem, const Vector &solution)
  {
    constexpr double unit_round_off = 0.5 * std::numeric_limits<double>::epsilon();
    Vector           diagonal;
    diagonal.reinit(solution, true);
    problem.matrix.diagonal(diagonal);
    double square = 0.;
    for (unsigned int i = 0; i < solution.locally_owned_size(); ++i)
      {
        const double stiffness = diagonal.local_element(i);
        const double delta     = unit_round_off
                             * (std::abs(problem.right_hand_side.local_element(i))
                                + stiffness * std::abs(solution.local_element(i)));
        square += delta * delta / stiffness;
      }
    return std::sqrt(dealii::Utilities::MPI::sum(square, solution.get_mpi_communicator()));
  }
} // namespace signorini
