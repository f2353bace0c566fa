// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <vector>

namespace signorini
{
  namespace
  {
    struct VtkCell
    {
      std::vector<long> points;
      unsigned int      type = 0;
    };

    /** Skip words up to a keyword and a number of numbers behind it. @return the first number */
    std::size_t skip_to(std::istream &in, const std::string &keyword, const unsigned int n_numbers)
    {
      std::string word;
      while (in >> word && word != keyword)
        ;
      std::size_t first = 0, further = 0;
      in >> first;
      for (unsigned int i = 1; i < n_numbers; ++i)
        in >> further;
      return first;
    }

    std::vector<VtkCell> read_cells(const std::string &text)
    {
      std::istringstream   in(text);
      std::vector<VtkCell> cells(skip_to(in, "CELLS", 2));
      for (VtkCell &cell : cells)
        {
          std::size_t n_points = 0;
          in >> n_points;
          cell.points.resize(n_points);
          for (long &point : cell.points)
            in >> point;
        }
      skip_to(in, "CELL_TYPES", 1);
      for (VtkCell &cell : cells)
        in >> cell.type;
      return cells;
    }
  } // namespace


  std::string vtk_for_dealii(const std::string &text)
  {
    const std::size_t end_of_points = text.find("\nCELLS");
    if (end_of_points == std::string::npos) // no line of its own: deal.II says what is wrong
      return text;
    static const std::regex version("^# vtk DataFile Version [1-4]\\.[0-9]");
    const std::string       head =
      std::regex_replace(text.substr(0, end_of_points + 1), version, "# vtk DataFile Version 3.0");
    if (text.find("MaterialID") != std::string::npos
        || text.find("ManifoldID") != std::string::npos)
      return head + text.substr(end_of_points + 1);

    std::vector<VtkCell> cells = read_cells(text);
    std::stable_sort(cells.begin(), cells.end(), [](const VtkCell &a, const VtkCell &b) {
      return a.points.size() > b.points.size();
    });
    std::ostringstream list, types;
    std::size_t        n_numbers = 0;
    for (const VtkCell &cell : cells)
      {
        list << cell.points.size();
        for (const long point : cell.points)
          list << ' ' << point;
        list << '\n';
        types << cell.type << '\n';
        n_numbers += 1 + cell.points.size();
      }
    std::ostringstream result;
    result << head << "CELLS " << cells.size() << ' ' << n_numbers << '\n'
           << list.str() << "CELL_TYPES " << cells.size() << '\n'
           << types.str();
    return result.str();
  }
} // namespace signorini
