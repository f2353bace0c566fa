// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_mesh_numbers_h
#define signorini_mesh_files_mesh_numbers_h

#include <istream>
#include <string>

namespace signorini
{
  /** @throws MeshFileError about a file that ends, or has no number, in the part that is named */
  [[noreturn]] void refuse_end(const std::string &where);

  /** The next number of a mesh file. @throws MeshFileError naming @p where if there is none */
  template <typename Number>
  Number next(std::istream &in, const std::string &where)
  {
    Number number;
    if (!(in >> number))
      refuse_end(where);
    return number;
  }

  /** Pass over n numbers. @throws MeshFileError like next() */
  void skip_numbers(std::istream &in, unsigned long n, const std::string &where);

  /**
   * To be called where the cells of a legacy VTK file begin, after their two counts.
   * @throws MeshFileError if they are listed as VTK 5 does
   */
  void refuse_offsets(std::istream &in);
} // namespace signorini

#endif
