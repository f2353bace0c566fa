// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Distributed problems have the same answer as the same problem on one process: active sets, sums and decisions are those
// of all processes.

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include "solvers.h"

using namespace signorini;

namespace
{
  constexpr unsigned int n = 12;

  /** Springs in a row, each entry coupled with its neighbours, also across processes; entries in equal shares. */
  class Springs : public LinearOperator
  {
  public:
    explicit Springs(const MPI_Comm communicator)
    {
      const auto       share = n / dealii::Utilities::MPI::n_mpi_processes(communicator);
      const auto       first = share * dealii::Utilities::MPI::this_mpi_process(communicator);
      dealii::IndexSet owned(n), ghosts(n);
      owned.add_range(first, first + share);
      ghosts.add_range(first > 0 ? first - 1 : 0, std::min(n, first + share + 1));
      ghosts.subtract_set(owned);
      partitioner = std::make_shared<dealii::Utilities::MPI::Partitioner>(owned, ghosts, communicator);
    }

    void vmult(Vector &destination, const Vector &source) const override
    {
      Vector ghosted(partitioner);
      ghosted = source;
      ghosted.update_ghost_values();
      for (const auto i : partitioner->locally_owned_range())
        destination(i) = 2.1 * ghosted(i) - (i > 0 ? ghosted(i - 1) : 0.) - (i + 1 < n ? ghosted(i + 1) : 0.);
    }

    void diagonal(Vector &destination) const override { destination = 2.1; }

    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
  };

  /** The answer on all processes: solution, residual, number of active entries. Bounds and forces by global index. */
  Eigen::MatrixXd solve_springs(const MPI_Comm communicator, const SolverCase &solver_case, SolveReport &report)
  {
    const Springs             matrix(communicator);
    const auto               &partitioner = matrix.partitioner;
    Vector                    b(partitioner), x(partitioner), s(partitioner);
    std::vector<unsigned int> bounded, fixed;
    std::vector<double>       bounds, values;
    for (const unsigned int i : partitioner->locally_owned_range())
      {
        b(i)            = std::sin(1.3 * i) + 0.5;
        const auto here = partitioner->global_to_local(i);
        if (i == n - 1)
          {
            fixed.push_back(here);
            values.push_back(0.3);
          }
        else if (i != 4)
          {
            bounded.push_back(here);
            bounds.push_back(i == 7 ? infinity : 0.2 * std::cos(2.7 * i));
          }
      }
    const unsigned int owned = partitioner->locally_owned_size();
    DenseInverse       preconditioner(2.1 * Eigen::MatrixXd::Identity(owned, owned));
    ActiveSet          active(bounded.size(), 0);
    report = make_solver(solver_case)
               ->solve({matrix, preconditioner, b, bounded, bounds, fixed, values, 1e-11, 1e-12}, active, x, s);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, 2);
    for (const unsigned int i : partitioner->locally_owned_range())
      result.row(i) << x(i), s(i);
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(result.data(), result.size()),
                                communicator,
                                dealii::ArrayView<double>(result.data(), result.size()));
    return result;
  }

  class Distributed : public testing::TestWithParam<SolverCase>
  {
  };
} // namespace

TEST_P(Distributed, CoupledProblem)
{
  SolveReport           report, serial_report;
  const Eigen::MatrixXd answer = solve_springs(MPI_COMM_WORLD, GetParam(), report);
  const Eigen::MatrixXd serial = solve_springs(MPI_COMM_SELF, GetParam(), serial_report);
  EXPECT_LT((answer - serial).norm(), 1e-9);
  EXPECT_EQ(report.n_active, serial_report.n_active);
  EXPECT_GT(report.n_active, 2u);
  EXPECT_LT(report.n_active, n - 2);
}

INSTANTIATE_TEST_SUITE_P(All,
                         Distributed,
                         testing::Values(solver_cases[1], solver_cases[2]),
                         testing::PrintToStringParamName());
