// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/abaqus_type.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace signorini
{
  namespace
  {
    const std::map<std::string, AbaqusType> solids = {{"4", {CellKind::tetrahedron, 4}},
                                                      {"5", {CellKind::pyramid, 5}},
                                                      {"6", {CellKind::wedge, 6}},
                                                      {"8", {CellKind::hexahedron, 8}},
                                                      {"10", {CellKind::tetrahedron, 10}},
                                                      {"15", {CellKind::wedge, 15}},
                                                      {"20", {CellKind::hexahedron, 20}},
                                                      {"27", {CellKind::hexahedron, 27}}};
    const std::map<std::string, AbaqusType> plates = {{"3", {CellKind::triangle, 3}},
                                                      {"4", {CellKind::quadrilateral, 4}},
                                                      {"6", {CellKind::triangle, 6}},
                                                      {"65", {CellKind::triangle, 6}},
                                                      {"8", {CellKind::quadrilateral, 8}},
                                                      {"9", {CellKind::quadrilateral, 9}}};
    const std::map<std::string, AbaqusType> bars   = {{"2", {CellKind::line, 2}},
                                                      {"3", {CellKind::line, 3}}};

    /** Beginnings of names, and what the number behind them says. */
    const std::map<std::string, const std::map<std::string, AbaqusType> *> families = {
      {"C3D", &solids},
      {"CPS", &plates},
      {"CPE", &plates},
      {"CAX", &plates},
      {"S", &plates},
      {"STRI", &plates},
      {"M3D", &plates},
      {"R3D", &plates},
      {"SFM3D", &plates},
      {"T2D", &bars},
      {"T3D", &bars}};
  } // namespace


  AbaqusType abaqus_type(const std::string &name)
  {
    constexpr std::size_t longest = 80; // labels of Abaqus are not longer
    for (const auto &[family, types] : families)
      if (name.size() <= longest && name.rfind(family, 0) == 0)
        {
          const auto begin = name.begin() + family.size();
          const auto end   = std::find_if_not(
            begin, name.end(), [](const unsigned char c) { return std::isdigit(c); });
          const auto found = types->find(std::string(begin, end));
          if (found != types->end() && std::all_of(end, name.end(), [](const unsigned char c) {
                return std::isalnum(c);
              }))
            return found->second;
        }
    throw MeshFileError("it has elements of type `" + name
                        + "`. Only triangles and quadrilaterals (2d, such as CPE3 and CPS4) and "
                          "tetrahedra, wedges and hexahedra (3d, C3D4, C3D6 and C3D8) can be used, "
                          "also with nodes in the middle of edges. Mesh the body with these.");
  }


  AbaqusKeyword parse_abaqus_keyword(const std::string &line)
  {
    AbaqusKeyword keyword;
    for (const std::string &word : split(line, ','))
      if (keyword.name.empty())
        keyword.name = word;
      else
        keyword.values[trim(word.substr(0, word.find('=')))] =
          word.find('=') == std::string::npos ? "" : trim(word.substr(word.find('=') + 1));
    return keyword;
  }


  unsigned int number_in_abaqus_name(const std::string &name)
  {
    std::string digits;
    std::copy_if(name.begin(), name.end(), std::back_inserter(digits), [](const unsigned char c) {
      return std::isdigit(c);
    });
    if (digits.size() > 9)
      throw MeshFileError("the number in the name of the surface `" + name
                          + "` is too large for a boundary id. " + MeshFileError::remedy);
    return digits.empty() ? 0 : std::stoul(digits);
  }
} // namespace signorini
