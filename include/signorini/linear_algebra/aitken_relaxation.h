// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_aitken_relaxation_h
#define signorini_linear_algebra_aitken_relaxation_h

#include <Eigen/Core>

#include <algorithm>

namespace signorini
{
  /**
   * How far to go on in the direction of a fixed point's step, x += factor (g(x) - x), so that slow
   * linear convergence becomes fast: Aitken's extrapolation for vectors (Irons and Tuck, Int. J.
   * Numer. Methods Eng. 1 (1969) 275-277). For iterations that converge from one side, so that no
   * factor is below 1.
   */
  class AitkenRelaxation
  {
  public:
    /** Of the next step, the first time 1. @param step g(x) - x */
    double factor(const Eigen::VectorXd &step)
    {
      if (last.size() == step.size())
        {
          const Eigen::VectorXd change = step - last;
          const double          square = change.squaredNorm();
          if (square > 0.)
            latest = std::clamp(-latest * last.dot(change) / square, 1., most);
        }
      last = step;
      return latest;
    }

    void forget()
    {
      last.resize(0);
      latest = 1.;
    }

  private:
    static constexpr double most = 100.;

    Eigen::VectorXd last;
    double          latest = 1.;
  };
} // namespace signorini

#endif
