// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_contact_status_h
#define signorini_base_contact_status_h

#include <vector>

namespace signorini
{
  /** What a contact node does in a step. Without friction, closed nodes slip. */
  namespace contact_status
  {
    constexpr char open  = 0; ///< no force
    constexpr char slip  = 1; ///< held in the normal direction; friction, if any, is at its bound
    constexpr char stick = 2; ///< held in all directions relative to the other side
    constexpr char hang  = 3; ///< held in the tangential directions only: possible with Tresca's friction

    inline bool is_closed(const char status)
    {
      return status == slip || status == stick;
    }

    inline bool sticks(const char status)
    {
      return status == stick || status == hang;
    }
  } // namespace contact_status

  /** The status of each contact node (bounded entry). */
  using ActiveSet = std::vector<char>;
} // namespace signorini

#endif
