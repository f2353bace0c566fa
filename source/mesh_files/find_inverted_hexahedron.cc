// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_text.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <sstream>
#include <vector>

namespace signorini
{
  namespace
  {
    using dealii::Point;

    struct Hexahedron
    {
      std::string label;
      Point<3>    centre;
      /** Sum of the signed volumes spanned by the edges at the bottom vertices. */
      double orientation = 0.;
    };

    double
    signed_volume(const Point<3> &origin, const Point<3> &x, const Point<3> &y, const Point<3> &z)
    {
      return dealii::cross_product_3d(x - origin, y - origin) * (z - origin);
    }

    std::vector<Hexahedron> read_hexahedra(std::istream &in)
    {
      std::string  word;
      unsigned int n_vertices = 0, n_cells = 0;
      for (; in.peek() == '#';)
        std::getline(in, word);
      in >> n_vertices >> n_cells >> word >> word >> word;
      std::map<long, Point<3>> vertices;
      for (unsigned int v = 0; v < n_vertices; ++v)
        {
          long number = 0;
          in >> number;
          in >> vertices[number][0] >> vertices[number][1] >> vertices[number][2];
        }
      std::vector<Hexahedron> hexahedra;
      for (unsigned int c = 0; c < n_cells; ++c)
        {
          std::string label, type;
          in >> label >> word >> type;
          std::vector<Point<3>> corners(type == "hex" ? 8 : type == "quad" ? 4 : 2);
          Point<3>              centre;
          for (Point<3> &corner : corners)
            {
              long number = 0;
              in >> number;
              corner = vertices[number];
              centre += corner / static_cast<double>(corners.size());
            }
          // Around the bottom 0 1 2 3, and 4 5 6 7 above.
          double orientation = 0.;
          for (unsigned int v = 0; type == "hex" && v < 4; ++v)
            orientation +=
              signed_volume(corners[v], corners[(v + 1) % 4], corners[(v + 3) % 4], corners[v + 4]);
          if (type == "hex")
            hexahedra.push_back({label, centre, orientation});
        }
      return hexahedra;
    }
  } // namespace

  std::string find_inverted_hexahedron(const std::string &ucd)
  {
    std::istringstream            in(ucd);
    const std::vector<Hexahedron> hexahedra     = read_hexahedra(in);
    std::size_t                   n_left_handed = 0;
    for (const Hexahedron &hexahedron : hexahedra)
      n_left_handed += hexahedron.orientation < 0.;
    const bool most_are_left_handed = 2 * n_left_handed > hexahedra.size();
    for (const Hexahedron &hexahedron : hexahedra)
      if ((hexahedron.orientation < 0.) != most_are_left_handed)
        {
          std::ostringstream text;
          text << "cell " << hexahedron.label << " with the centre (" << hexahedron.centre << ')';
          return text.str();
        }
    return "";
  }
} // namespace signorini
