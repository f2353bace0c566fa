// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/condensation/nodal_factor.h>

namespace signorini
{
  namespace
  {
    constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

    /** The nodes that are eliminated, in an order that leaves few new couplings. */
    std::vector<unsigned int> elimination_order(const NodePattern       &pattern,
                                                const std::vector<char> &is_last)
    {
      std::vector<unsigned int> nodes, place(pattern.n_owned, none);
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        if (!pattern.is_empty(node) && !is_last[node])
          {
            place[node] = nodes.size();
            nodes.push_back(node);
          }
      std::vector<Eigen::Triplet<double>> couplings;
      for (const unsigned int row : nodes)
        for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
          if (const unsigned int column = place[pattern.columns[k]]; column != none)
            couplings.emplace_back(column, place[row], 1.);
      Eigen::SparseMatrix<double> graph(nodes.size(), nodes.size());
      graph.setFromTriplets(couplings.begin(), couplings.end());
      Eigen::AMDOrdering<int>::PermutationType order;
      if (!nodes.empty())
        Eigen::AMDOrdering<int>()(graph, order);
      std::vector<unsigned int> result;
      for (Eigen::Index k = 0; k < order.size(); ++k)
        result.push_back(nodes[order.indices()[k]]);
      return result;
    }


    /** Call action with the size of a group as a constant. */
    template <typename Action>
    void with_size(const int size, const Action &action)
    {
      if (size == 1)
        action(std::integral_constant<int, 1>());
      else if (size == 2)
        action(std::integral_constant<int, 2>());
      else if (size == 3)
        action(std::integral_constant<int, 3>());
      else
        action(std::integral_constant<int, 4>());
    }
  } // namespace


  template <int dim>
  NodalFactor<dim>::NodalFactor(const ElasticMatrices<dim>      &matrices,
                                const MatrixSum                 &sum,
                                const std::vector<char>         &prescribed,
                                const std::vector<unsigned int> &last)
  {
    const NodePattern &pattern = matrices.pattern;
    AssertDimension(pattern.n_owned, pattern.n_local);
    AssertDimension(prescribed.size(), dim * pattern.n_owned);
    std::vector<char> is_last(pattern.n_owned, 0);
    for (const unsigned int node : last)
      is_last[node] = 1;
    std::vector<unsigned int> position(dim * pattern.n_owned, none);
    const auto                add = [&](const unsigned int node) {
      for (unsigned int entry = dim * node; entry < dim * (node + 1); ++entry)
        if (is_last[node] || !prescribed[entry])
          {
            position[entry] = entries.size();
            entries.push_back(entry);
          }
    };
    for (const unsigned int node : elimination_order(pattern, is_last))
      add(node);
    n_eliminated = entries.size();
    for (const unsigned int node : last)
      add(node);

    std::vector<Eigen::Triplet<double>> lower;
    for (unsigned int row = 0; row < pattern.n_owned; ++row)
      for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
        {
          const unsigned int column = pattern.columns[k];
          const auto         block  = matrices.combined_block(row, k, matrices.at_node(row, sum));
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = row == column ? c : 0; d < dim; ++d)
              {
                const unsigned int i = dim * row + c, j = dim * column + d;
                const bool         is_held = prescribed[i] || prescribed[j];
                if (position[i] != none && position[j] != none && (i == j || !is_held))
                  lower.emplace_back(std::max(position[i], position[j]),
                                     std::min(position[i], position[j]),
                                     block[dim * d + c]);
              }
        }
    Eigen::SparseMatrix<double> matrix(entries.size(), entries.size());
    matrix.setFromTriplets(lower.begin(), lower.end());
    lower = {};
    cholesky.compute(matrix);
    if (cholesky.info() != Eigen::Success)
      throw StepError("the matrix of a step has no Cholesky factor.");

    const Eigen::Index n_last = entries.size() - n_eliminated;
    Eigen::MatrixXd    of_factor =
      Eigen::MatrixXd(factor().block(n_eliminated, n_eliminated, n_last, n_last));
    of_last = of_factor * of_factor.transpose();
    values.resize(entries.size());
    find_groups();
  }


  template <int dim>
  void NodalFactor<dim>::find_groups()
  {
    const int *start = factor().outerIndexPtr(), *row = factor().innerIndexPtr();
    const auto continues = [&](const int column) { // the one before
      const int n = start[column + 1] - start[column];
      return start[column] - start[column - 1] == n + 1
             && std::equal(
               row + start[column], row + start[column + 1], row + start[column - 1] + 1);
    };
    groups = {0};
    for (int column = 1; column < n_eliminated; ++column)
      if (column - groups.back() == most_columns || !continues(column))
        groups.push_back(column);
    if (n_eliminated > 0)
      groups.push_back(n_eliminated);
  }


  template <int dim>
  template <int n_columns>
  void NodalFactor<dim>::eliminate(const int first)
  {
    const double *columns[n_columns]; // without the rows of the group
    double        known[n_columns];
    for (int j = 0; j < n_columns; ++j)
      {
        const double *column = factor().valuePtr() + factor().outerIndexPtr()[first + j];
        known[j]             = values[first + j] /= column[0];
        for (int i = j + 1; i < n_columns; ++i)
          values[first + i] -= column[i - j] * known[j];
        columns[j] = column + n_columns - j;
      }
    const int *rows = factor().innerIndexPtr() + factor().outerIndexPtr()[first] + n_columns;
    const int  n_rows =
      factor().outerIndexPtr()[first + 1] - factor().outerIndexPtr()[first] - n_columns;
    for (int p = 0; p < n_rows; ++p)
      {
        double sum = 0.;
        for (int j = 0; j < n_columns; ++j)
          sum += columns[j][p] * known[j];
        values[rows[p]] -= sum;
      }
  }


  template <int dim>
  template <int n_columns>
  void NodalFactor<dim>::substitute(const int first)
  {
    const int *rows = factor().innerIndexPtr() + factor().outerIndexPtr()[first] + n_columns;
    const int  n_rows =
      factor().outerIndexPtr()[first + 1] - factor().outerIndexPtr()[first] - n_columns;
    const double *columns[n_columns];
    double        sums[n_columns] = {};
    for (int j = 0; j < n_columns; ++j)
      columns[j] = factor().valuePtr() + factor().outerIndexPtr()[first + j] + n_columns - j;
    for (int p = 0; p < n_rows; ++p)
      {
        const double value = values[rows[p]];
        for (int j = 0; j < n_columns; ++j)
          sums[j] += columns[j][p] * value;
      }
    for (int j = n_columns; j-- > 0;)
      {
        const double *column = factor().valuePtr() + factor().outerIndexPtr()[first + j];
        for (int i = j + 1; i < n_columns; ++i)
          sums[j] += column[i - j] * values[first + i];
        values[first + j] = (values[first + j] - sums[j]) / column[0];
      }
  }


  template <int dim>
  Eigen::VectorXd NodalFactor<dim>::condense(const Vector &force)
  {
    for (std::size_t k = 0; k < entries.size(); ++k)
      values[k] = force.local_element(entries[k]);
    for (std::size_t g = 0; g + 1 < groups.size(); ++g)
      with_size(groups[g + 1] - groups[g],
                [&](const auto n_columns) { eliminate<n_columns>(groups[g]); });
    return values.tail(values.size() - n_eliminated);
  }


  template <int dim>
  void NodalFactor<dim>::expand(const Eigen::VectorXd &last, Vector &displacement)
  {
    AssertDimension(last.size(), values.size() - n_eliminated);
    values.tail(last.size()) = last;
    for (std::size_t g = groups.size() - 1; g-- > 0;)
      with_size(groups[g + 1] - groups[g],
                [&](const auto n_columns) { substitute<n_columns>(groups[g]); });
    displacement = 0.;
    for (std::size_t k = 0; k < entries.size(); ++k)
      displacement.local_element(entries[k]) = values[k];
  }


  template class NodalFactor<2>;
  template class NodalFactor<3>;
} // namespace signorini
