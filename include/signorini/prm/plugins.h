// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_plugins_h
#define signorini_prm_plugins_h

#include <signorini/prm/scene_text.h>

#include <string>
#include <vector>

namespace signorini
{
  /** The key, at the top of a scene, that names shared libraries. */
  constexpr const char *key_of_plugins = "Additional shared libraries";

  /** What a scene names there, as paths from the root of the file system. */
  std::vector<std::string> plugins_of(const SceneText &text);

  /** What the command line says of them, for programs that print what there is. */
  SceneText plugins_without_a_scene(const std::vector<Override> &overrides);

  /**
   * Load them. To be called before keys are declared, which plug-ins add to.
   * @throws UserError that names the key
   */
  void load_plugins(const SceneText &text);
} // namespace signorini

#endif
