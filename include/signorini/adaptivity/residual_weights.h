// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_residual_weights_h
#define signorini_adaptivity_residual_weights_h

#include <signorini/model/body_description.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  /**
   * Weights of the squared residuals, so that their sum is a squared error in the energy norm. At
   * rest the length l that turns a residual into an error is the size h of a cell or face, in the
   * problem of a step
   *
   *   l = min(h, tau/2 c_s),   c_s = sqrt(mu/rho),
   *
   * because mass dominates what is larger than the way of a shear wave. The balance of a step is
   * that of the mean displacement, the error that of the new one: twice as much. Its norm is that
   * of velocity and displacement together, rho |e_v|^2 + a(e_u, e_u) with e_v = 2/tau e_u: twice
   * the energy.
   */
  struct ResidualWeights
  {
    double step_size = 0.; ///< tau; 0: at rest
    /** The energy of pressure times gap counts so often: goals rely on it more. */
    double of_gap = 1.;

    /** Of |div sigma + rho q|^2, with the size h of the cell. */
    double cell(const Material &material, const double h) const
    {
      return square_of_factor() * std::pow(length(material, h), 2) / material.mu();
    }

    /** Of squared stress vectors, with the size h of the face. */
    double face(const Material &material, const double h) const
    {
      return square_of_factor() * length(material, h) / material.mu();
    }

    /** Of the energy of pressure times gap. */
    double complementarity() const { return of_gap * (step_size > 0. ? 2. : 1.); }

  private:
    double length(const Material &material, const double h) const
    {
      return step_size > 0.
               ? std::min(h, 0.5 * step_size * std::sqrt(material.mu() / material.density))
               : h;
    }

    double square_of_factor() const { return step_size > 0. ? 4. : 1.; }
  };
} // namespace signorini

#endif
