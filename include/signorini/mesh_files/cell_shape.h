// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_cell_shape_h
#define signorini_mesh_files_cell_shape_h

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /** What the elements of a mesh file can be. */
  enum class CellKind
  {
    point,
    line,
    triangle,
    quadrilateral,
    tetrahedron,
    pyramid,
    wedge,
    hexahedron
  };

  /**
   * How the corners of a cell lie to each other. They are numbered as in Gmsh, VTK, UCD and Abaqus,
   * which agree: around the bottom, then around the top.
   */
  struct CellShape
  {
    using Edge = std::pair<unsigned int, unsigned int>;

    std::string  name, plural;
    unsigned int dim, n_corners;
    /** In the order in which Abaqus and VTK list the nodes in the middle of edges. */
    std::vector<Edge> edges;
    /** Corners around a face (2d: the ends of an edge), in the order of Abaqus. */
    std::vector<std::vector<unsigned int>> faces;
    /**
     * The corners at the other ends of the edges of each corner, right-handed if the volume of the
     * cell is positive; in 2d the last one has no meaning. Empty if a corner has four edges.
     */
    std::vector<std::vector<unsigned int>> neighbours;
  };

  const CellShape &shape_of(CellKind kind);

  /** Of the corners of a cell, in ascending order: the same for a face of two neighbours. */
  std::array<unsigned int, 4> key_of_face(const std::array<unsigned int, 8> &corners,
                                          const std::vector<unsigned int>   &face);
} // namespace signorini

#endif
