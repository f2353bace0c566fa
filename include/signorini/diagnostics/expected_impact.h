// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_expected_impact_h
#define signorini_diagnostics_expected_impact_h

#include <signorini/diagnostics/first_touch.h>

namespace signorini
{
  /** One side of an impact; of a rigid obstacle everything is infinite. */
  struct Collider
  {
    double mass       = 0.; ///< infinite for what is held or rigid
    double volume     = 0.;
    double modulus    = 0.; ///< E / (1 - nu^2), infinite for what is rigid
    double wave_speed = 0.; ///< of pressure waves
    double density    = 0.;
    double depth      = 0.; ///< along the normal of the touch
  };

  /** The first impact of a pair in round numbers, as long as no other force matters. */
  struct ExpectedImpact
  {
    double force    = 0.; ///< the largest
    double duration = 0.; ///< of contact
    double n_nodes  = 0.; ///< of the slave surface that bear the largest force
    double strain   = 0.; ///< the largest
  };

  /**
   * What is to be expected where two sides meet. Round bodies: Hertz, with K = 4/3 E* R^(1/2) in
   * 3d, flattening (5 m v^2 / (4 K))^(2/5), duration 2.943 flattening / v (Johnson, Contact
   * Mechanics 1985, section 11.4); in 2d a cylinder is flattened by F L/(pi E*) per unit of length,
   * L = 2 ln(2 d/a) - 1 with the half-width a of contact and the depth d of the body (Johnson
   * (5.57), (5.58)), so that F = v (pi E* m/(L - 1/2))^(1/2). Flat ones: the pressure Z v of a
   * plane wave, Z = rho c, until it has run through the shorter body (a much softer one) and back.
   * A body that is wider than the faces that touch gives way as much less: its mass per depth
   * counts.
   * @param touch of smooth surfaces that do meet @param other mass and modulus infinite if rigid
   */
  template <int dim>
  ExpectedImpact
  expected_impact(const FirstTouch &touch, const Collider &body, const Collider &other);
} // namespace signorini

#endif
