// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_increment_forecast_h
#define signorini_system_increment_forecast_h

#include <signorini/linear_algebra/separate_parts.h>

#include <Eigen/Dense>

#include <deque>
#include <memory>

namespace signorini
{
  /**
   * First guess for the increment of the next step: among all combinations of the last increments
   * the one that is closest to the solution in the norm of K (Fischer, Comput. Methods Appl. Mech.
   * Engrg. 163 (1998) 193-204). Better than any polynomial through them, because the motion decides
   * on the weights, and that of each body on its own: bodies are parts of K that nothing couples,
   * so what is closest for each of them is closest for all. In undeformed flight it is exact.
   *
   * It costs a few scalar products and no product with K: K d = b - s is known from the solve, s
   * being the residual with the forces that hold constraints. The forces of the new step are
   * extrapolated. All vectors are Cartesian, whatever contact coordinates do meanwhile.
   */
  class IncrementForecast
  {
  public:
    /** @param parts of K that have their own weights */
    explicit IncrementForecast(
      std::shared_ptr<const SeparateParts> parts = std::make_shared<SeparateParts>())
      : parts(std::move(parts))
    {
    }

    /**
     * The guess for the right-hand side b. @return false if nothing is known; the increment is not
     * changed then
     */
    bool guess(const Vector &right_hand_side, Vector &increment);

    /**
     * The latest increment for the right-hand side b of the same step with other conditions of
     * contact; what is remembered next will take its place.
     * @param residual b - K increment, known without a product
     * @return false if nothing is known, or not any more
     */
    bool repeat(const Vector &right_hand_side, Vector &increment, Vector &residual);

    /**
     * Remember a solved step: K increment = right_hand_side - residual. One that is larger or
     * smaller by far than the last ones makes forget everything.
     */
    void remember(const Vector &right_hand_side, const Vector &increment, const Vector &residual);

    /** Forget everything: the next step has another size or another mesh. */
    void clear();

  private:
    static constexpr unsigned int n_kept = 6;

    std::shared_ptr<const SeparateParts> parts;
    std::deque<Vector>                   increments; ///< latest first
    std::deque<Vector>                   residuals;  ///< the two latest
    Vector                               product;    ///< K d of the latest
    std::vector<Eigen::MatrixXd>         grams;      ///< d_i'K d_j of each part
    bool                                 repeats = false;

    void drop_latest();
  };
} // namespace signorini

#endif
