// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/multigrid/coarse_factor.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * What is left of the stiffness of held entries: where this level is as fine as the finest,
     * nothing else is.
     */
    constexpr double regularisation = 1e-6;

    /** What the processes have, one after the other. */
    template <typename T>
    std::vector<T> of_all_processes(const std::vector<T> &own, const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return own;
      std::vector<T> result;
      for (const auto &part : Utilities::MPI::all_gather(communicator, own))
        result.insert(result.end(), part.begin(), part.end());
      return result;
    }
  } // namespace


  template <int dim>
  CoarseFactor<dim>::CoarseFactor(const ElasticMatrices<dim> &matrices,
                                  const MatrixSum            &sum,
                                  const double                scale)
    : communicator(matrices.pattern.partitioner->get_mpi_communicator())
    , first_owned(matrices.pattern.partitioner->local_range().first)
    , matrix(matrices.pattern.partitioner->size(), matrices.pattern.partitioner->size())
  {
    const NodePattern                 &pattern = matrices.pattern;
    const Utilities::MPI::Partitioner &numbers = *pattern.partitioner;
    Entries                            own;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
        {
          const auto row    = numbers.local_to_global(dim * node),
                     column = numbers.local_to_global(dim * pattern.columns[k]);
          if (column < row)
            continue; // the owner of the column has it, too
          const auto block = matrices.combined_block(node, k, sum);
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              if (row != column || d >= c)
                own.push_back({scale * block[dim * d + c],
                               static_cast<unsigned int>(column + d),
                               static_cast<unsigned int>(row + c)});
        }
    matrix = gather(own);
    factor.compute(matrix);
    if (factor.info() != Eigen::Success)
      throw RunError("The matrix of the coarsest level has no factor.");
  }


  template <int dim>
  template <typename Number>
  void CoarseFactor<dim>::set_correction(const HeldCorrection<dim, Number> &correction)
  {
    // Many held entries share a few coarse nodes: their terms are summed in a small full matrix.
    std::vector<types::global_dof_index> nodes;
    correction.for_each_held(0, [&](const auto &measure, const auto &sum) {
      for (const auto *row : {&measure, &sum})
        for (const auto &part : *row)
          nodes.push_back(part.node);
    });
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto place = [&](const types::global_dof_index node) -> unsigned int {
      return dim * (std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
    };
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(dim * nodes.size(), dim * nodes.size());
    correction.for_each_held(0, [&](const auto &measure, const auto &sum) {
      std::vector<unsigned int> columns;
      for (const auto &b : sum)
        columns.push_back(place(b.node));
      for (const auto &a : measure)
        {
          const unsigned int row = place(a.node);
          for (std::size_t k = 0; k < columns.size(); ++k)
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                change(row + i, columns[k] + j) +=
                  correction.matrix_scale() * a.value[i] * sum[k].value[j];
        }
    });
    Entries own;
    for (unsigned int p = 0; p < change.rows(); ++p)
      for (unsigned int q = 0; q <= p; ++q)
        {
          double value = change(p, q) + change(q, p);
          if (p == q)
            value += regularisation * std::abs(value);
          if (value != 0.)
            own.push_back({value,
                           static_cast<unsigned int>(dim * nodes[p / dim] + p % dim),
                           static_cast<unsigned int>(dim * nodes[q / dim] + q % dim)});
        }
    factor.compute(matrix + gather(own));
    if (factor.info() != Eigen::Success)
      throw RunError("The matrix of the coarsest level has no factor under contact.");
  }


  template <int dim>
  Eigen::SparseMatrix<double> CoarseFactor<dim>::gather(const Entries &own) const
  {
    std::vector<Eigen::Triplet<double>> triplets;
    for (const Entry &entry : of_all_processes(own, communicator))
      triplets.emplace_back(entry.row, entry.column, entry.value);
    Eigen::SparseMatrix<double> result(matrix.rows(), matrix.cols());
    result.setFromTriplets(triplets.begin(), triplets.end());
    return result;
  }


  template <int dim>
  template <typename Number>
  void CoarseFactor<dim>::solve(const LevelVector<Number> &right_hand_side,
                                LevelVector<Number>       &solution) const
  {
    std::vector<double> own;
    for (unsigned int node = 0; 4 * node < right_hand_side.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        own.push_back(right_hand_side[4 * node + c]);
    const std::vector<double> all = of_all_processes(own, communicator);
    const Eigen::VectorXd     result =
      factor.solve(Eigen::Map<const Eigen::VectorXd>(all.data(), all.size()));
    for (unsigned int node = 0; 4 * node < solution.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        solution[4 * node + c] = result[first_owned + dim * node + c];
  }


#define INSTANTIATE(dim, Number)                                                                   \
  template void CoarseFactor<dim>::set_correction(const HeldCorrection<dim, Number> &);            \
  template void CoarseFactor<dim>::solve(const LevelVector<Number> &, LevelVector<Number> &) const;
  template class CoarseFactor<2>;
  template class CoarseFactor<3>;
  INSTANTIATE(2, float)
  INSTANTIATE(2, double)
  INSTANTIATE(3, float)
  INSTANTIATE(3, double)
#undef INSTANTIATE
} // namespace signorini
