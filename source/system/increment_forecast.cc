// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/increment_forecast.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** Of energies of increments that can tell about each other in double precision. */
    constexpr double largest_ratio = 1e12;


    /** Of the energy of all bodies, what a body that rests has by round-off. */
    constexpr double energy_at_rest = 1e-22;


    /**
     * The weights w that minimise 1/2 w'G w - p'w, G the Gram matrix of the increments. Increments
     * without energy have none. @param least energy that is more than round-off
     */
    Eigen::VectorXd closest_combination(const Eigen::MatrixXd &gram,
                                        const Eigen::VectorXd &projection,
                                        const double           least)
    {
      const Eigen::Index n = gram.rows();
      Eigen::VectorXd    scaling(n);
      for (Eigen::Index i = 0; i < n; ++i)
        scaling[i] = gram(i, i) > least ? 1. / std::sqrt(gram(i, i)) : 0.;
      // The increments are nearly parallel; directions that are lost in round-off are left out.
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaling.asDiagonal() * gram
                                                                 * scaling.asDiagonal());
      const double    smallest = 1e-13 * modes.eigenvalues()[n - 1];
      Eigen::VectorXd weights =
        modes.eigenvectors().transpose() * scaling.asDiagonal() * projection;
      for (Eigen::Index i = 0; i < n; ++i)
        weights[i] = modes.eigenvalues()[i] > smallest ? weights[i] / modes.eigenvalues()[i] : 0.;
      return scaling.asDiagonal() * modes.eigenvectors() * weights;
    }
  } // namespace


  bool IncrementForecast::guess(const Vector &right_hand_side, Vector &increment)
  {
    const unsigned int n = increments.size();
    if (n == 0)
      return false;
    AssertDimension(right_hand_side.size(), increments[0].size());
    AssertDimension(increment.size(), right_hand_side.size());

    // b - s with s from the last two steps
    Vector force = right_hand_side;
    if (residuals.size() == 2)
      force.add(-2., residuals[0], 1., residuals[1]);
    else
      force -= residuals[0];

    Eigen::MatrixXd projections(parts->n, n), weights(parts->n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto products = parts->products(increments[i], force);
        projections.col(i)  = Eigen::VectorXd::Map(products.data(), products.size());
      }
    double largest = 0.;
    for (const Eigen::MatrixXd &gram : grams)
      largest = std::max(largest, gram.diagonal().maxCoeff());
    for (unsigned int part = 0; part < parts->n; ++part)
      weights.row(part) = closest_combination(
        grams[part],
        projections.row(part),
        std::max(energy_at_rest * largest, grams[part].diagonal().maxCoeff() / largest_ratio));
    increment = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double *of_parts = weights.col(i).data();
        parts->add(increment, {of_parts, of_parts + parts->n}, increments[i]);
      }
    return true;
  }


  bool IncrementForecast::repeat(const Vector &right_hand_side, Vector &increment, Vector &residual)
  {
    repeats = !increments.empty();
    if (!repeats)
      return false;
    increment = increments[0];
    residual  = right_hand_side;
    residual -= product;
    return true;
  }


  void IncrementForecast::remember(const Vector &right_hand_side,
                                   const Vector &increment,
                                   const Vector &residual)
  {
    AssertDimension(increment.size(), right_hand_side.size());
    AssertDimension(residual.size(), right_hand_side.size());
    Assert(increments.empty() || increments[0].size() == increment.size(),
           dealii::ExcMessage("The mesh has changed: clear() what was remembered."));
    if (repeats)
      drop_latest();
    product = right_hand_side;
    product -= residual;
    if (increments.size() == n_kept) // reuse the memory of the oldest
      {
        increments.push_front(std::move(increments.back()));
        increments.pop_back();
        increments.front() = increment;
      }
    else
      increments.push_front(increment);
    if (residuals.size() == 2)
      residuals.pop_back();
    residuals.push_front(residual);

    const unsigned int           n = increments.size();
    std::vector<Eigen::MatrixXd> new_grams(parts->n, Eigen::MatrixXd(n, n));
    for (unsigned int i = 0; i < n; ++i)
      {
        const std::vector<double> with_latest = parts->products(increments[i], product);
        for (unsigned int part = 0; part < parts->n; ++part)
          new_grams[part](0, i) = new_grams[part](i, 0) = with_latest[part];
      }
    Eigen::ArrayXd energies = Eigen::ArrayXd::Zero(n);
    for (unsigned int part = 0; part < parts->n; ++part)
      {
        if (n > 1)
          new_grams[part].bottomRightCorner(n - 1, n - 1) = grams[part].topLeftCorner(n - 1, n - 1);
        energies += new_grams[part].diagonal().array();
      }
    grams    = new_grams;
    energies = energies.abs();

    // A solution for an iterate gone astray would leave its round-off in all that follow.
    if (!(energies.maxCoeff() <= largest_ratio * energies.minCoeff()))
      clear();
  }


  void IncrementForecast::drop_latest()
  {
    increments.pop_front();
    residuals.pop_front();
    const unsigned int n = increments.size();
    for (Eigen::MatrixXd &gram : grams)
      gram = Eigen::MatrixXd(gram.bottomRightCorner(n, n));
    repeats = false;
  }


  void IncrementForecast::clear()
  {
    repeats = false;
    increments.clear();
    residuals.clear();
    grams.clear();
  }
} // namespace signorini
