// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/algebraic_coarsening.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /** Couplings below this part of the geometric mean of the diagonal blocks are weak. */
    constexpr double strong = 0.08;
    /** A node follows at most so many others. */
    template <int dim>
    constexpr unsigned int most_parents = dim == 2 ? 6 : 10;
    /** Weights beyond this extrapolate; then only constants are exact. */
    constexpr double largest_weight = 1.5;
    /** Error of affine functions, in distances to the next kept node. */
    constexpr double far_from_affine = 0.1;

    using Neighbours = std::vector<std::vector<unsigned int>>;

    template <std::size_t size>
    double norm(const std::array<double, size> &block)
    {
      double square = 0.;
      for (const double entry : block)
        square += entry * entry;
      return std::sqrt(square);
    }


    template <int dim>
    Neighbours strong_couplings(const ElasticMatrices<dim> &matrices)
    {
      const NodePattern  &pattern = matrices.pattern;
      std::vector<double> diagonal(pattern.n_owned, 0.);
      for (unsigned int row = 0; row < pattern.n_owned; ++row)
        if (!pattern.is_empty(row))
          diagonal[row] = norm(matrices.stiffness[pattern.row_start[row]]);
      Neighbours result(pattern.n_owned);
      for (unsigned int row = 0; row < pattern.n_owned; ++row)
        for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
          {
            const unsigned int column = pattern.columns[k];
            if (column == row || column >= pattern.n_owned)
              continue;
            if (norm(matrices.stiffness[k]) > strong * std::sqrt(diagonal[row] * diagonal[column]))
              {
                result[row].push_back(column);
                result[column].push_back(row);
              }
          }
      return result;
    }


    /** One by one: a node stays unless it is strongly coupled with one that does. */
    std::vector<char> keep_independent(const Neighbours &neighbours)
    {
      enum : char
      {
        open,
        goes,
        stays
      };
      std::vector<char> result(neighbours.size(), open);
      for (unsigned int node = 0; node < neighbours.size(); ++node)
        if (result[node] == open)
          {
            result[node] = stays;
            for (const unsigned int neighbour : neighbours[node])
              if (result[neighbour] == open)
                result[neighbour] = goes;
          }
      for (char &status : result)
        status = status == stays;
      return result;
    }


    /** The nearest kept nodes among neighbours and their neighbours. */
    template <int dim>
    std::vector<unsigned int> parents_of(const unsigned int                     node,
                                         const Neighbours                      &neighbours,
                                         const std::vector<char>               &is_kept,
                                         const std::vector<dealii::Point<dim>> &positions)
    {
      std::vector<unsigned int> result;
      for (const unsigned int neighbour : neighbours[node])
        {
          if (is_kept[neighbour])
            result.push_back(neighbour);
          for (const unsigned int other : neighbours[neighbour])
            if (is_kept[other])
              result.push_back(other);
        }
      std::sort(result.begin(), result.end());
      result.erase(std::unique(result.begin(), result.end()), result.end());
      const auto distance = [&](const unsigned int other) {
        return positions[node].distance_square(positions[other]);
      };
      std::stable_sort(
        result.begin(), result.end(), [&](const unsigned int a, const unsigned int b) {
          return distance(a) < distance(b);
        });
      result.resize(std::min<std::size_t>(result.size(), most_parents<dim>));
      return result;
    }


    /**
     * Of all weights that give affine functions exactly the smallest, nearer nodes counting more;
     * where the nodes lie in a plane, as well as they can.
     */
    template <int dim>
    std::vector<double> affine_weights(const dealii::Point<dim>              &point,
                                       const std::vector<dealii::Point<dim>> &parents,
                                       bool                                  &is_affine)
    {
      const unsigned int n       = parents.size();
      const double       nearest = point.distance_square(parents.front());
      Eigen::MatrixXd    moments(dim + 1, n);
      Eigen::VectorXd    nearness(n);
      for (unsigned int j = 0; j < n; ++j)
        {
          moments(0, j) = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            moments(1 + d, j) = (parents[j][d] - point[d]) / std::sqrt(nearest);
          nearness[j] = std::pow(nearest / point.distance_square(parents[j]), 2);
        }
      const Eigen::MatrixXd weighted = moments * nearness.asDiagonal();
      Eigen::VectorXd       values   = Eigen::VectorXd::Zero(dim + 1);
      values[0]                      = 1.;
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> gram;
      gram.setThreshold(1e-6);
      gram.compute(weighted * moments.transpose());
      Eigen::VectorXd weights = weighted.transpose() * gram.solve(values);
      if (!(std::abs(weights.sum() - 1.) < 0.5) || weights.cwiseAbs().maxCoeff() > largest_weight)
        weights = nearness;
      weights /= weights.sum();
      is_affine = (moments * weights - values).norm() < far_from_affine;
      return std::vector<double>(weights.data(), weights.data() + n);
    }
  } // namespace


  template <int dim>
  Coarsening coarsen(const ElasticMatrices<dim>            &matrices,
                     const std::vector<dealii::Point<dim>> &positions)
  {
    const unsigned int        n          = matrices.pattern.n_owned;
    const Neighbours          neighbours = strong_couplings(matrices);
    const std::vector<char>   is_kept    = keep_independent(neighbours);
    Coarsening                result;
    std::vector<unsigned int> place(n);
    for (unsigned int node = 0; node < n; ++node)
      if (is_kept[node])
        {
          place[node] = result.kept.size();
          result.kept.push_back(node);
        }
    result.parents.resize(n);
    for (unsigned int node = 0; node < n; ++node)
      {
        if (is_kept[node])
          {
            result.parents[node] = {{place[node], 1.}};
            continue;
          }
        const auto parents = parents_of<dim>(node, neighbours, is_kept, positions);
        std::vector<dealii::Point<dim>> points;
        for (const unsigned int parent : parents)
          points.push_back(positions[parent]);
        bool                      is_affine;
        const std::vector<double> weights = affine_weights<dim>(positions[node], points, is_affine);
        result.n_not_affine += !is_affine;
        for (std::size_t j = 0; j < parents.size(); ++j)
          if (weights[j] != 0.)
            result.parents[node].emplace_back(place[parents[j]], weights[j]);
      }
    return result;
  }


  template Coarsening coarsen(const ElasticMatrices<2> &, const std::vector<dealii::Point<2>> &);
  template Coarsening coarsen(const ElasticMatrices<3> &, const std::vector<dealii::Point<3>> &);
} // namespace signorini
