// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_scene_names_h
#define signorini_scene_scene_names_h

#include <signorini/prm/scene_text.h>
#include <signorini/scene/pair_name.h>

#include <string>
#include <vector>

namespace signorini
{
  /** The names under which the scene has subsections of its own. */
  struct SceneNames
  {
    std::vector<std::string> bodies, obstacles, probes;
    std::vector<PairName>    pairs;
  };

  /**
   * First pass over a scene: only the lists `Names` and `Pairs`, which decide which subsections
   * exist. Brings the names of the subsections of `Contact` into the normal form.
   * @throws UserError for empty, double, strange and unknown names.
   */
  SceneNames read_scene_names(SceneText &text);
} // namespace signorini

#endif
