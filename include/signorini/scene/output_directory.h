// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_output_directory_h
#define signorini_scene_output_directory_h

#include <string>

namespace signorini
{
  /**
   * Try to make the folder and to write a file in it; both are removed again. Call it on one
   * process only.
   * @throws UserError with the reason if results could not be written there.
   */
  void check_output_directory(const std::string &directory);
} // namespace signorini

#endif
