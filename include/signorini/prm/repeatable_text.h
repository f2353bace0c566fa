// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_repeatable_text_h
#define signorini_prm_repeatable_text_h

#include <signorini/prm/scene_text.h>

namespace signorini
{
  /**
   * The text of a scene that can be run again from any folder: the file as it was read, with
   * absolute paths of included files, followed by what was said elsewhere.
   * @param later statements that come after the file, such as those of the command line
   */
  std::string repeatable_text(const SceneText &text, const std::vector<Statement> &later);
} // namespace signorini

#endif
