// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/cell_shape.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  namespace
  {
    const CellShape shapes[] = {
      {"point", "points", 0, 1, {}, {}, {}},
      {"line", "lines", 1, 2, {{0, 1}}, {}, {}},
      {"triangle",
       "triangles",
       2,
       3,
       {{0, 1}, {1, 2}, {2, 0}},
       {{0, 1}, {1, 2}, {2, 0}},
       {{1, 2, 0}, {2, 0, 0}, {0, 1, 0}}},
      {"quadrilateral",
       "quadrilaterals",
       2,
       4,
       {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
       {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
       {{1, 3, 0}, {2, 0, 0}, {3, 1, 0}, {0, 2, 0}}},
      {"tetrahedron",
       "tetrahedra",
       3,
       4,
       {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}},
       {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}},
       {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}},
      {"pyramid",
       "pyramids",
       3,
       5,
       {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}},
       {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}},
       {}},
      {"wedge",
       "wedges",
       3,
       6,
       {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}},
       {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}},
       {{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}}},
      {"hexahedron",
       "hexahedra",
       3,
       8,
       {{0, 1},
        {1, 2},
        {2, 3},
        {3, 0},
        {4, 5},
        {5, 6},
        {6, 7},
        {7, 4},
        {0, 4},
        {1, 5},
        {2, 6},
        {3, 7}},
       {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}},
       {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}}};
  } // namespace


  const CellShape &shape_of(const CellKind kind)
  {
    return shapes[static_cast<unsigned int>(kind)];
  }


  std::array<unsigned int, 4> key_of_face(const std::array<unsigned int, 8> &corners,
                                          const std::vector<unsigned int>   &face)
  {
    std::array<unsigned int, 4> key;
    key.fill(std::numeric_limits<unsigned int>::max());
    for (std::size_t v = 0; v < face.size(); ++v)
      key[v] = corners[face[v]];
    std::sort(key.begin(), key.end());
    return key;
  }
} // namespace signorini
