// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_new_scene_h
#define signorini_prm_new_scene_h

#include <string>
#include <vector>

namespace signorini
{
  /** The scenes that write_new_scene() knows; the first one is the one to begin with. */
  std::vector<std::string> names_of_new_scenes();

  /**
   * Write a scene with comments to start from into `<name>.prm` in the current folder.
   * @param name if empty, nothing is written
   * @return what to do with it, in words, or the names that there are
   * @throws UserError if there is no scene of this name, or a file already, or no room
   */
  std::string write_new_scene(const std::string &name);
} // namespace signorini

#endif
