// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_read_scene_h
#define signorini_scene_read_scene_h

#include <signorini/prm/scene_text.h>
#include <signorini/scene/scene.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /**
   * The value of `Dimension`, 2 or 3. @throws UserError for anything else, also when the file
   * cannot be read.
   */
  unsigned int read_dimension(const std::string &file_name, const std::vector<Override> &overrides);

  /**
   * Read a scene, apply the overrides, and check all that can be checked without a mesh: spelling
   * of keys and values, physical ranges, names, expressions (they must parse and evaluate),
   * combinations.
   * @throws UserError naming file, key, value and remedy.
   */
  template <int dim>
  Scene<dim> read_scene(const std::string &file_name, const std::vector<Override> &overrides);

  /**
   * All keys with defaults and descriptions, as an annotated .prm (one body, one obstacle, one
   * pair, one probe).
   */
  void print_parameters(std::ostream &out);
} // namespace signorini

#endif
