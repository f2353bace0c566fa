// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_mesh_text_h
#define signorini_mesh_files_mesh_text_h

#include <deal.II/grid/grid_in.h>

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

    /** What helps against triangles and tetrahedra. */
    static inline const std::string subdivide =
      "Mesh the body with these; in Gmsh `Mesh.SubdivisionAlgorithm = 1` makes quadrilaterals of "
      "triangles, and `= 2` hexahedra of tetrahedra.";

    /** What helps against nodes in the middle of edges. */
    static inline const std::string first_order =
      "Write the mesh with straight edges; in Gmsh: `Mesh.ElementOrder = 1`.";
  };

  /** The end of the name of a file, with its dot, in small letters. */
  std::string extension_of(const std::string &path);

  /** All bytes of a file. @throws MeshFileError if it cannot be read or has none */
  std::string read_mesh_content(const std::string &path);

  /** The same of a file of text, with lines as on this system. @throws MeshFileError for others */
  std::string read_mesh_lines(const std::string &path);

  /** The content of a mesh file in a form that deal.II reads. */
  struct MeshText
  {
    dealii::GridIn<3>::Format format; ///< msh, ucd or vtk
    std::string               text;
  };

  /**
   * Read a file, tell its format by its extension and content, and check what deal.II's readers
   * take for granted: the file ends where it should, and what it refers to exists. @throws
   * MeshFileError
   */
  MeshText read_mesh_text(const std::string &path);

  /**
   * The mesh of an Abaqus input file in UCD format. A face of the surface (`*SURFACE`, of elements
   * or element sets) whose name contains the digits of a number gets this number as boundary id,
   * all others 0. @throws MeshFileError
   */
  std::string abaqus_to_ucd(const std::string &text);

  /**
   * Refuse a text in UCD format with missing lines, or with cells and faces of vertices that do
   * not exist.
   */
  void check_ucd(const std::string &text);
  /**
   * Number and place, in words, of a hexahedron that lists its vertices in the other direction of
   * rotation than most in a text in UCD format; empty if there is none. deal.II refuses such meshes
   * without telling which cell it is.
   */
  std::string find_inverted_hexahedron(const std::string &ucd);
  /** The same as check_ucd() for a legacy VTK file. */
  void check_vtk(const std::string &text);
  /**
   * A legacy VTK file that check_vtk() has found in order, as deal.II wants it: version 3.0, cells
   * before their faces, and no data but deal.II's own.
   */
  std::string vtk_for_dealii(const std::string &text);
  /** Refuse a Gmsh file that is not ASCII, or that has sections without end. */
  void check_gmsh(const std::string &text);
} // namespace signorini

#endif
