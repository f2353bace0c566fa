// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_vector_kernels_h
#define signorini_linear_algebra_vector_kernels_h

#include <signorini/base/types.h>

namespace signorini
{
  /** x' y over all processes. */
  double dot(const Vector &x, const Vector &y);

  /** x += factor p and r -= factor q, in one pass. */
  void advance(double factor, const Vector &p, Vector &x, const Vector &q, Vector &r);

  /** p = z + factor p. */
  void extend_direction(const Vector &z, double factor, Vector &p);
} // namespace signorini

#endif
