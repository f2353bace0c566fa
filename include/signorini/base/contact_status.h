// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_contact_status_h
#define signorini_base_contact_status_h

#include <vector>

namespace signorini
{
  /** What a contact node does in a step: anything but open (zero) is held at its bound. Without friction, closed nodes slip. */
  namespace contact_status
  {
    constexpr char open  = 0; ///< no force
    constexpr char slip  = 1; ///< held in the normal direction; friction, if any, is at its bound
    constexpr char stick = 2; ///< held in all directions relative to the other side
  } // namespace contact_status

  /** The status of each contact node (bounded entry). */
  using ActiveSet = std::vector<char>;
} // namespace signorini

#endif
