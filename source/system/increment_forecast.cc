// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/increment_forecast.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** Of energies of increments that can tell about each other in double precision. */
    constexpr double largest_ratio = 1e12;
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

    Eigen::VectorXd projection(n), scaling(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        projection[i] = dot(increments[i], force);
        scaling[i]    = gram(i, i) > 0. ? 1. / std::sqrt(gram(i, i)) : 0.;
      }
    // The increments are nearly parallel; directions that are lost in round-off are left out.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaling.asDiagonal() * gram
                                                               * scaling.asDiagonal());
    const double    smallest = 1e-13 * modes.eigenvalues()[n - 1];
    Eigen::VectorXd weights  = modes.eigenvectors().transpose() * scaling.asDiagonal() * projection;
    for (unsigned int i = 0; i < n; ++i)
      weights[i] = modes.eigenvalues()[i] > smallest ? weights[i] / modes.eigenvalues()[i] : 0.;
    weights   = scaling.asDiagonal() * modes.eigenvectors() * weights;
    increment = 0.;
    for (unsigned int i = 0; i < n; ++i)
      increment.add(weights[i], increments[i]);
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

    const unsigned int n = increments.size();
    Eigen::MatrixXd    new_gram(n, n);
    new_gram.bottomRightCorner(n - 1, n - 1) = gram.topLeftCorner(n - 1, n - 1);
    for (unsigned int i = 0; i < n; ++i)
      new_gram(0, i) = new_gram(i, 0) = dot(increments[i], product);
    gram = new_gram;

    // A solution for an iterate gone astray would leave its round-off in all that follow.
    const Eigen::ArrayXd energies = gram.diagonal().array().abs();
    if (!(energies.maxCoeff() <= largest_ratio * energies.minCoeff()))
      clear();
  }


  void IncrementForecast::drop_latest()
  {
    increments.pop_front();
    residuals.pop_front();
    gram    = Eigen::MatrixXd(gram.bottomRightCorner(increments.size(), increments.size()));
    repeats = false;
  }


  void IncrementForecast::clear()
  {
    repeats = false;
    increments.clear();
    residuals.clear();
    gram.resize(0, 0);
  }
} // namespace signorini
