// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_marking_h
#define signorini_adaptivity_marking_h

#include <signorini/adaptivity/indicator_distribution.h>
#include <signorini/model/adaptivity_parameters.h>

#include <memory>

namespace signorini
{
  /**
   * Bounds of squared indicators: cells above the first are to be refined, below the second they
   * may be coarsened.
   */
  struct MarkingThresholds
  {
    double refine, coarsen;
  };

  /**
   * The part of the threshold of refinement below which cells may be coarsened where the solution
   * is smooth: a cell that replaces its 2^dim children has about 4 * 2^dim times the square of one
   * of them (linear elements, error in the energy norm), and this is to stay below half of the
   * threshold. Behind a front the error is not smooth, and no such law holds.
   */
  template <int dim>
  constexpr double smooth_coarsen_ratio()
  {
    return 1. / (8. * (1 << dim));
  }

  /** Which cells should be refined or coarsened if there were no limits. */
  class Marking
  {
  public:
    virtual ~Marking() = default;

    virtual MarkingThresholds thresholds(const IndicatorDistribution &distribution) const = 0;

    /**
     * Whether indicators are parts of an estimate, so that a small part of it is not worth a
     * change.
     */
    virtual bool weighs_parts() const { return true; }
  };

  /** The marking that the scene asks for. */
  template <int dim>
  std::unique_ptr<Marking> make_marking(const AdaptivityParameters &parameters);
} // namespace signorini

#endif
