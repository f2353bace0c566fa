// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_mesh_text_h
#define signorini_mesh_files_mesh_text_h

#include <stdexcept>
#include <string>

namespace signorini
{
  /** Why a file is not a mesh, without its name. */
  class MeshFileError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;

    /** What helps against a broken file. */
    static inline const std::string remedy = "Write the mesh again.";

    /** What helps against edges with more than one node in their middle. */
    static inline const std::string first_order =
      "Write the mesh with straight edges; in Gmsh: `Mesh.ElementOrder = 1`.";
  };

  /** The end of the name of a file, with its dot, in small letters. */
  std::string extension_of(const std::string &path);

  /** All bytes of a file. @throws MeshFileError if it cannot be read or has none */
  std::string read_mesh_content(const std::string &path);

  /** The same of a file of text, with lines as on this system. @throws MeshFileError for others */
  std::string read_mesh_lines(const std::string &path);

  /**
   * The mesh of a file that meshio reads, as text of Gmsh's version 2.2. The first process of
   * MPI_COMM_WORLD asks Python; all processes have to call this together. @throws MeshFileError if
   * Python or meshio is missing, or cannot read the file
   */
  std::string converted_to_gmsh(const std::string &path);
} // namespace signorini

#endif
