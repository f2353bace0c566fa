// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>
#include <signorini/linear_algebra/hessenberg.h>
#include <signorini/sweeps/rough_gmres.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    using SingleVector = RoughGmres::Vectors;

    /** A direction of which so little is new is round-off. */
    constexpr double exhausted = 1e-5;

    double dot_in_single(const SingleVector &a, const SingleVector &b)
    {
      double sums[4] = {0., 0., 0., 0.};
      for (std::size_t i = 0; i < a.size(); i += 4)
        for (unsigned int c = 0; c < 4; ++c)
          sums[c] += static_cast<double>(a[i + c]) * b[i + c];
      return (sums[0] + sums[1]) + (sums[2] + sums[3]);
    }


    void add_in_single(const double factor, const SingleVector &from, SingleVector &to)
    {
      const float single = static_cast<float>(factor);
      for (std::size_t i = 0; i < to.size(); ++i)
        to[i] += single * from[i];
    }


    void scale_in_single(const double factor, SingleVector &vector)
    {
      const float single = static_cast<float>(factor);
      for (float &value : vector)
        value *= single;
    }


    double norm_in_single(const SingleVector &vector, const MPI_Comm communicator)
    {
      return std::sqrt(dealii::Utilities::MPI::sum(dot_in_single(vector, vector), communicator));
    }


    /**
     * Take out of the last vector of a basis what the others have of it, in two messages.
     * @return the components, and behind them the norm of what is left
     */
    Eigen::VectorXd orthogonalise(std::vector<SingleVector> &basis,
                                  const unsigned int         last,
                                  const MPI_Comm             communicator)
    {
      std::vector<double> own, all(last);
      for (unsigned int i = 0; i < last; ++i)
        own.push_back(dot_in_single(basis[last], basis[i]));
      dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(own.data(), last),
                                  communicator,
                                  dealii::ArrayView<double>(all.data(), last));
      Eigen::VectorXd result(last + 1);
      for (unsigned int i = 0; i < last; ++i)
        {
          add_in_single(-all[i], basis[i], basis[last]);
          result[i] = all[i];
        }
      result[last] = norm_in_single(basis[last], communicator);
      return result;
    }
  } // namespace


  RoughSolver::Report RoughGmres::solve(const Operator    &matrix,
                                        const Vectors     &right_hand_side,
                                        Vectors           &solution,
                                        const double       reduction,
                                        const unsigned int maximum_iterations,
                                        const MPI_Comm     communicator)
  {
    const unsigned int most = std::min(most_vectors, maximum_iterations);
    basis.resize(std::max<std::size_t>(basis.size(), 1));
    basis[0]           = right_hand_side;
    const double start = norm_in_single(basis[0], communicator);
    if (start > 0.)
      scale_in_single(1. / start, basis[0]);

    Hessenberg hessenberg(start, most);
    while (hessenberg.n_columns() < most && hessenberg.norm() > reduction * start)
      {
        heed_interruption(communicator);
        const unsigned int j = hessenberg.n_columns() + 1;
        if (basis.size() <= j)
          basis.emplace_back();
        basis[j].resize(right_hand_side.size());
        matrix(basis[j - 1], basis[j]);
        const Eigen::VectorXd column = orthogonalise(basis, j, communicator);
        hessenberg.add(column);
        if (!(column[j] > exhausted * column.norm()))
          break;
        scale_in_single(1. / column[j], basis[j]);
      }
    const Eigen::VectorXd factors = hessenberg.solution();
    solution.assign(right_hand_side.size(), 0.f);
    for (unsigned int i = 0; i < factors.size(); ++i)
      add_in_single(factors[i], basis[i], solution);
    RoughSolver::Report report;
    report.iterations = hessenberg.n_columns();
    report.reached    = hessenberg.norm() <= reduction * start;
    return report;
  }
} // namespace signorini
