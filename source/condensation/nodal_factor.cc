// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/condensation/nodal_factor.h>

#include <Eigen/OrderingMethods>

#include <algorithm>

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
    std::vector<int>          node_starts = {0};
    const auto                add         = [&](const unsigned int node) {
      for (unsigned int entry = dim * node; entry < dim * (node + 1); ++entry)
        if (is_last[node] || !prescribed[entry])
          {
            position[entry] = entries.size();
            entries.push_back(entry);
          }
      if (entries.size() > static_cast<std::size_t>(node_starts.back()))
        node_starts.push_back(entries.size());
    };
    for (const unsigned int node : elimination_order(pattern, is_last))
      add(node);
    const int n_eliminated = node_starts.size() - 1;
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
    lower  = {};
    factor = MultifrontalFactor(matrix, node_starts, n_eliminated);
    values.resize(entries.size());
  }


  template <int dim>
  Eigen::VectorXd NodalFactor<dim>::condense(const Vector &force)
  {
    for (std::size_t k = 0; k < entries.size(); ++k)
      values[k] = force.local_element(entries[k]);
    factor.eliminate(values.data());
    return values.tail(schur_complement().rows());
  }


  template <int dim>
  void NodalFactor<dim>::expand(const Eigen::VectorXd &last, Vector &displacement)
  {
    AssertDimension(last.size(), schur_complement().rows());
    values.tail(last.size()) = last;
    factor.substitute(values.data());
    displacement = 0.;
    for (std::size_t k = 0; k < entries.size(); ++k)
      displacement.local_element(entries[k]) = values[k];
  }


  template class NodalFactor<2>;
  template class NodalFactor<3>;
} // namespace signorini
