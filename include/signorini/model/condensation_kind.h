// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_condensation_kind_h
#define signorini_model_condensation_kind_h

#include <signorini/base/enum_names.h>

namespace signorini
{
  /** Whether steps are solved for the contact nodes alone, with a direct factor of the rest. */
  enum class CondensationKind
  {
    automatic, ///< where that is faster
    never,
    always ///< on one process
  };

  template <>
  struct EnumNames<CondensationKind>
  {
    static constexpr EnumName<CondensationKind> table[] = {
      {CondensationKind::automatic, "automatic"},
      {CondensationKind::never, "never"},
      {CondensationKind::always, "always"}};
  };
} // namespace signorini

#endif
