// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_linear_operator_h
#define signorini_linear_algebra_linear_operator_h

#include <signorini/base/types.h>

namespace signorini
{
  /** A symmetric positive definite matrix of which only products are needed. */
  class LinearOperator
  {
  public:
    virtual ~LinearOperator() = default;

    /** destination = K source, in all entries (no mask). */
    virtual void vmult(Vector &destination, const Vector &source) const = 0;

    /** The diagonal of K; entries of empty rows are 1. */
    virtual void diagonal(Vector &destination) const = 0;
  };
} // namespace signorini

#endif
