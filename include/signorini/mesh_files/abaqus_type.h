// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_abaqus_type_h
#define signorini_mesh_files_abaqus_type_h

#include <signorini/mesh_files/cell_shape.h>

#include <map>
#include <string>

namespace signorini
{
  /** What `TYPE=C3D10` says. */
  struct AbaqusType
  {
    CellKind     kind    = CellKind::hexahedron;
    unsigned int n_nodes = 8;
  };

  /** The type of an element by its name in capital letters. @throws MeshFileError if not known */
  AbaqusType abaqus_type(const std::string &name);

  /** `*SURFACE, NAME=SS1`: the keyword, and values by their names (empty for names without). */
  struct AbaqusKeyword
  {
    std::string                        name;
    std::map<std::string, std::string> values;

    bool        has(const std::string &key) const { return values.count(key) > 0; }
    std::string value(const std::string &key) const { return has(key) ? values.at(key) : ""; }
  };

  AbaqusKeyword parse_abaqus_keyword(const std::string &line);

  /**
   * The digits of a name as a number: 3 for SS3 and SURF-3, 0 without digits. @throws MeshFileError
   * for more than nine digits
   */
  unsigned int number_in_abaqus_name(const std::string &name);
} // namespace signorini

#endif
