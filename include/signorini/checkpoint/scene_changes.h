// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_checkpoint_scene_changes_h
#define signorini_checkpoint_scene_changes_h

#include <string>
#include <vector>

namespace signorini
{
  /**
   * What differs between two scenes that a run cannot go on over, each as `key: value, was value`.
   * End time, output intervals, tolerances, and when to write checkpoints may differ.
   * @param before, now all keys with their values, as a .prm
   */
  std::vector<std::string> forbidden_changes(const std::string &before, const std::string &now);

  /** The keys that may change, in words. */
  std::string keys_that_may_change();
} // namespace signorini

#endif
