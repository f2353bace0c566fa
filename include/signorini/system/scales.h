// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_scales_h
#define signorini_system_scales_h

#include <signorini/linear_algebra/linear_operator.h>
#include <signorini/linear_algebra/masked_preconditioner.h>

#include <algorithm>

namespace signorini
{
  /**
   * About the norm of the solution of K x = b in the norm of K, with some entries prescribed: what
   * a system at rest is going to do, as a scale for accepted errors. Sets the mask of the
   * preconditioner. Collective.
   */
  double response_size(const LinearOperator            &matrix,
                       MaskedPreconditioner            &preconditioner,
                       const Vector                    &right_hand_side,
                       const std::vector<unsigned int> &prescribed_entries,
                       const std::vector<double>       &prescribed_values);

  /**
   * The same with the diagonal of K for K, never more than a few times as much: enough to tell rest
   * from motion, and next to free. Collective.
   */
  double rough_response_size(const LinearOperator            &matrix,
                             const Vector                    &right_hand_side,
                             const std::vector<unsigned int> &prescribed_entries,
                             const std::vector<double>       &prescribed_values);

  /**
   * What a bound of an increment may be exceeded by: nothing that matters, neither to the size of
   * the bodies nor to the motion of the step, which may be very slow; but more than the round-off
   * of the gap.
   */
  inline double bound_tolerance(const Vector &increment, const double body_size)
  {
    return body_size * std::clamp(1e-6 * increment.linfty_norm() / body_size, 1e-16, 1e-12);
  }
} // namespace signorini

#endif
