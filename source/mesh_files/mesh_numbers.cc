// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

namespace signorini
{
  void refuse_end(const std::string &where)
  {
    throw MeshFileError("the file is broken: it ends, or has something else than a number, in "
                        + where + ". " + MeshFileError::remedy);
  }


  void skip_numbers(std::istream &in, const unsigned long n, const std::string &where)
  {
    for (unsigned long i = 0; i < n; ++i)
      next<double>(in, where);
  }


  void refuse_offsets(std::istream &in)
  {
    if ((in >> std::ws).peek() == 'O')
      throw MeshFileError(
        "the cells are listed as `OFFSETS` and `CONNECTIVITY`, as VTK 5 does. Save it as a legacy "
        "file of version 4.2 (ParaView: `File Version`; meshio: format `vtk42`).");
  }
} // namespace signorini
