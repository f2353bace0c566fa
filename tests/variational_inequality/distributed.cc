// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Distributed problems have the same answer as the same problem on one process: active sets, sums
// and decisions are those of all processes.

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include "solvers.h"

using namespace signorini;

namespace
{
  constexpr unsigned int n = 12;

  /**
   * Springs in a row, each entry coupled with its neighbours, also across processes; entries in
   * equal shares.
   */
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
      partitioner =
        std::make_shared<dealii::Utilities::MPI::Partitioner>(owned, ghosts, communicator);
    }

    void vmult(Vector &destination, const Vector &source) const override
    {
      Vector ghosted(partitioner);
      ghosted = source;
      ghosted.update_ghost_values();
      for (const auto i : partitioner->locally_owned_range())
        destination(i) =
          2.1 * ghosted(i) - (i > 0 ? ghosted(i - 1) : 0.) - (i + 1 < n ? ghosted(i + 1) : 0.);
    }

    void diagonal(Vector &destination) const override { destination = 2.1; }

    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
  };

  /**
   * The whole problem. Odd seeds bound entries of the last process only: the others must go along
   * with its decisions.
   */
  DenseProblem springs_problem(const unsigned int seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> number(-1., 1.);
    DenseProblem                           problem;
    problem.matrix = 2.1 * Eigen::MatrixXd::Identity(n, n);
    problem.matrix.diagonal(1).setConstant(-1.);
    problem.matrix.diagonal(-1).setConstant(-1.);
    problem.right_hand_side =
      Eigen::VectorXd::NullaryExpr(n, [&] { return 0.4 + number(generator); });
    for (unsigned int i = seed % 2 ? n / 2 : 0; i + 1 < n; ++i)
      {
        problem.bounded_entries.push_back(i);
        problem.upper_bounds.push_back(i == 7 ? infinity : 0.5 * number(generator));
      }
    problem.fixed_entries = {n - 1};
    problem.fixed_values  = {0.3};
    return problem;
  }

  /** The share of this process: local indices of its entries, and their values. */
  void restrict_to_owned(const dealii::Utilities::MPI::Partitioner &partitioner,
                         std::vector<unsigned int>                 &entries,
                         std::vector<double>                       &values)
  {
    std::vector<unsigned int> owned_entries;
    std::vector<double>       owned_values;
    for (unsigned int k = 0; k < entries.size(); ++k)
      if (partitioner.in_local_range(entries[k]))
        {
          owned_entries.push_back(partitioner.global_to_local(entries[k]));
          owned_values.push_back(values[k]);
        }
    entries = owned_entries;
    values  = owned_values;
  }

  class Distributed : public testing::TestWithParam<SolverCase>
  {
  };
} // namespace

TEST_P(Distributed, SolutionIsThatOfTheWholeProblem)
{
  unsigned int n_inactive = 0;
  for (unsigned int seed = 0; seed < 10; ++seed)
    {
      const Springs         matrix(MPI_COMM_WORLD);
      const auto           &partitioner = *matrix.partitioner;
      DenseProblem          problem     = springs_problem(seed);
      const Eigen::VectorXd exact       = brute_force(problem);
      const Eigen::VectorXd forces      = problem.right_hand_side - problem.matrix * exact;
      unsigned int          n_active    = 0;
      for (unsigned int k = 0; k < problem.bounded_entries.size(); ++k)
        n_active += forces[problem.bounded_entries[k]] > 1e-10;
      EXPECT_GT(n_active, 0u);
      n_inactive += problem.bounded_entries.size() - 1 - n_active;

      restrict_to_owned(partitioner, problem.bounded_entries, problem.upper_bounds);
      restrict_to_owned(partitioner, problem.fixed_entries, problem.fixed_values);
      Vector b(matrix.partitioner), x(matrix.partitioner), s(matrix.partitioner);
      for (const auto i : partitioner.locally_owned_range())
        b(i) = problem.right_hand_side[i];
      const unsigned int owned = partitioner.locally_owned_size();
      DenseInverse       preconditioner(2.1 * Eigen::MatrixXd::Identity(owned, owned));
      ActiveSet          active(problem.bounded_entries.size(), 0);
      const SolveReport  report = GetParam().make_solver()->solve({matrix,
                                                                   preconditioner,
                                                                   b,
                                                                   problem.bounded_entries,
                                                                   problem.upper_bounds,
                                                                   problem.fixed_entries,
                                                                   problem.fixed_values,
                                                                   1e-11,
                                                                   1e-12},
                                                                 active,
                                                                 x,
                                                                 s);
      EXPECT_EQ(report.n_active, n_active);
      for (const auto i : partitioner.locally_owned_range())
        {
          EXPECT_NEAR(x(i), exact[i], 1e-10);
          EXPECT_NEAR(s(i), forces[i], 1e-9);
        }
    }
  EXPECT_GT(n_inactive, 5u);
}

INSTANTIATE_TEST_SUITE_P(All,
                         Distributed,
                         testing::Values(solver_cases[1], solver_cases[3], solver_cases[4]),
                         testing::PrintToStringParamName());
