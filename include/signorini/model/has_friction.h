// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_has_friction_h
#define signorini_model_has_friction_h

#include <signorini/model/contact_description.h>

#include <algorithm>

namespace signorini
{
  /** Whether contact nodes of any pair may bear tangential forces. */
  inline bool has_friction(const std::vector<PairDescription> &pairs)
  {
    return std::any_of(
      pairs.begin(), pairs.end(), [](const PairDescription &pair) { return pair.friction.any; });
  }
} // namespace signorini

#endif
