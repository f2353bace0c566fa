// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_inequality_method_h
#define signorini_base_inequality_method_h

#include <signorini/base/enum_names.h>

namespace signorini
{
  /** Methods for the inequality of a step without friction. */
  enum class InequalityMethod
  {
    active_set,
    truncated_newton_multigrid
  };

  template <>
  struct EnumNames<InequalityMethod>
  {
    static constexpr EnumName<InequalityMethod> table[] = {
      {InequalityMethod::active_set, "active-set"},
      {InequalityMethod::truncated_newton_multigrid, "truncated-newton-multigrid"}};
  };
} // namespace signorini

#endif
