// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_tresca_friction_h
#define signorini_variational_inequality_tresca_friction_h

#include <signorini/variational_inequality/constrained_problem.h>

namespace signorini
{
  /**
   * The term sum_k b_k |slip_k| of friction with given bounds, and what it does to each contact
   * node k at a point x with the residual b - K x. All of them must outlive the object, which sees
   * what becomes of x and the residual.
   */
  class TrescaFriction
  {
  public:
    /** Parts of a bound that are none. */
    static constexpr double round_off = 1e-13;

    TrescaFriction(const ConstrainedProblem  &problem,
                   const std::vector<double> &bounds,
                   const Vector              &point,
                   const Vector              &residual)
      : problem(problem)
      , bounds(bounds)
      , point(point)
      , residual(residual)
    {
    }

    bool acts(const std::size_t k) const
    {
      return bounds[k] > 0. && !problem.friction[k].entries.empty();
    }

    NodeForces forces(std::size_t k) const;

    /** Whether the node has no slip and its force is not beyond the bound. */
    bool rests(std::size_t k) const;

    /**
     * Force and stiffness of the term b |slip|; at a kink that the node wants to leave, the
     * direction is that of its force.
     */
    SlipCondition condition(std::size_t k) const;

    /** What friction bears: its bound along the slip; without slip what it has to. */
    TangentVector force(std::size_t k) const;

    /**
     * A part of the way along a direction: the force of friction times the direction, without what
     * it bears now.
     */
    double change(std::size_t k, const Vector &direction, double length) const;

    /** Give the node this slip at another point. */
    void set_slip(Vector &other, std::size_t k, const TangentVector &value) const;

  private:
    const ConstrainedProblem  &problem;
    const std::vector<double> &bounds;
    const Vector              &point, &residual;
  };
} // namespace signorini

#endif
