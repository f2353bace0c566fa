// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_friction_friction_law_h
#define signorini_friction_friction_law_h

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  /**
   * How much tangential force a contact node bears under a normal force n > 0 (compression),
   *
   *   bound(n) = min(constant + coefficient n, cap):
   *
   * Coulomb (coefficient alone), Coulomb with cap, Tresca (constant alone; it asks for no normal
   * force at all). Below the bound the node sticks; at the bound it slips, and the force is
   * opposite to the slip. All are forces of a node, not stresses.
   */
  struct FrictionLaw
  {
    double coefficient = 0.; ///< mu, no unit
    double constant    = 0.;
    double cap         = std::numeric_limits<double>::infinity();

    /** False if the node never bears a tangential force. */
    bool any() const { return coefficient > 0. || constant > 0.; }

    double bound(const double normal_force) const
    {
      return std::min(constant + coefficient * std::max(normal_force, 0.), cap);
    }

    /** A generalised derivative of the bound. */
    double slope(const double normal_force) const
    {
      return normal_force > 0. && constant + coefficient * normal_force < cap ? coefficient : 0.;
    }

    /** The law of forces that are multiplied by a factor. */
    FrictionLaw scaled(const double factor) const
    {
      Assert(factor > 0., dealii::ExcMessage("Forces are scaled by a positive factor."));
      return {coefficient, factor * constant, factor * cap};
    }

    /** The law of a node with another area: what is given as a stress changes with it. */
    FrictionLaw with_area(const double ratio) const
    {
      return {coefficient, ratio * constant, ratio * cap};
    }
  };
} // namespace signorini

#endif
