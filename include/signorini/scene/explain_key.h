// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_explain_key_h
#define signorini_scene_explain_key_h

#include <iosfwd>
#include <string>

namespace signorini
{
  /**
   * What a key means, its default and its values; of a section, all keys with their defaults.
   * @param path "Section/Key"; what a scene has a name of its own for (a body, an obstacle, a
   *             probe, a pair) may have any name
   * @throws UserError if there is no such key, with those that are
   */
  void explain_key(const std::string &path, std::ostream &out);
} // namespace signorini

#endif
