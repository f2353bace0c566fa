// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_apply_statements_h
#define signorini_prm_apply_statements_h

#include <signorini/prm/scene_text.h>

namespace dealii
{
  class ParameterHandler;
}

namespace signorini
{
  /**
   * Enter all statements into a handler in which every section and key of the scene is declared.
   * @throws UserError for an unknown section or key and for a value that does not match its
   * pattern.
   */
  void apply_statements(const SceneText &text, dealii::ParameterHandler &prm);
} // namespace signorini

#endif
