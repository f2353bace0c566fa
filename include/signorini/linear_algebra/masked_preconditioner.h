// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_masked_preconditioner_h
#define signorini_linear_algebra_masked_preconditioner_h

#include <signorini/base/types.h>
#include <signorini/linear_algebra/slip_rows.h>

#include <vector>

namespace signorini
{
  class RoughSolver;

  /** For each locally owned entry whether it is held (1: fixed or in active contact) or free (0).
   */
  using Mask = std::vector<char>;

  /**
   * Approximates the inverse of K restricted to the free entries, symmetric positive definite
   * there.
   */
  class MaskedPreconditioner
  {
  public:
    virtual ~MaskedPreconditioner() = default;

    /** Which entries are held from now on. Cheap: no new factorisation. Collective. */
    virtual void set_mask(const Mask &mask) = 0;

    /**
     * destination = approximate inverse times source; zero in the held entries, whatever the
     * source has there.
     */
    virtual void vmult(Vector &destination, const Vector &source) const = 0;

    /** Where it can solve by itself, with the mask and the norm that it has here; else null. */
    virtual const RoughSolver *rough_solver() const { return nullptr; }

    /**
     * The same for K with further rows, until the next set_mask(). Null where it cannot, on all
     * processes. Collective.
     */
    virtual const RoughSolver *rough_solver_with(const std::vector<SlipRows> & /*rows*/)
    {
      return nullptr;
    }
  };
} // namespace signorini

#endif
