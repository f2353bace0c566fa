// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

#include <set>
#include <sstream>

namespace signorini
{
  namespace
  {
    struct VtkCellType
    {
      CellKind     kind;
      unsigned int n_points;
    };

    const std::map<unsigned int, VtkCellType> vtk_types = {{3, {CellKind::line, 2}},
                                                           {5, {CellKind::triangle, 3}},
                                                           {8, {CellKind::quadrilateral, 4}},
                                                           {9, {CellKind::quadrilateral, 4}},
                                                           {10, {CellKind::tetrahedron, 4}},
                                                           {11, {CellKind::hexahedron, 8}},
                                                           {12, {CellKind::hexahedron, 8}},
                                                           {13, {CellKind::wedge, 6}},
                                                           {14, {CellKind::pyramid, 5}},
                                                           {21, {CellKind::line, 3}},
                                                           {22, {CellKind::triangle, 6}},
                                                           {23, {CellKind::quadrilateral, 8}},
                                                           {24, {CellKind::tetrahedron, 10}},
                                                           {25, {CellKind::hexahedron, 20}},
                                                           {26, {CellKind::wedge, 15}},
                                                           {27, {CellKind::pyramid, 13}},
                                                           {28, {CellKind::quadrilateral, 9}},
                                                           {29, {CellKind::hexahedron, 27}},
                                                           {32, {CellKind::wedge, 18}}};

    /** Pixels and voxels count their points row by row. */
    bool counts_by_rows(const unsigned int type)
    {
      return type == 8 || type == 11;
    }


    VtkCellType
    vtk_type(const unsigned int number, const std::size_t cell, const std::size_t n_points)
    {
      const std::string name  = "cell " + std::to_string(cell) + " (counted from 0)";
      const auto        found = vtk_types.find(number);
      if (found == vtk_types.end())
        throw MeshFileError(
          name + " has the VTK type " + std::to_string(number)
          + ". Only triangles and quadrilaterals (2d), tetrahedra, wedges and hexahedra (3d) can "
            "be used. "
          + (number == 1 ? "Points are what Gmsh writes for a mesh without physical groups; save "
                           "it as .msh."
                         : MeshFileError::first_order));
      if (found->second.n_points != n_points)
        throw MeshFileError("the file is broken: " + name + " of VTK type " + std::to_string(number)
                            + " has " + std::to_string(n_points) + " vertices. "
                            + MeshFileError::remedy);
      return found->second;
    }


    class VtkCells
    {
    public:
      explicit VtkCells(const std::string &text)
        : in(text)
      {
        content.turns_cells = true;
      }
      MeshContent read();

    private:
      void read_points();
      void read_cells();
      void read_types();
      void read_materials();
      void add_elements();

      std::istringstream                     in;
      MeshContent                            content;
      std::vector<std::vector<unsigned int>> cells; ///< their points
      std::vector<unsigned int>              numbers_of_types;
      std::vector<long>                      materials; ///< empty, or one of each cell
    };


    MeshContent VtkCells::read()
    {
      std::set<std::string> sections;
      for (std::string word; in >> word;)
        {
          if ((word == "POINTS" || word == "CELLS" || word == "CELL_TYPES" || word == "MaterialID")
              && !sections.insert(word).second)
            throw MeshFileError("the file is broken: it has the section `" + word + "` twice. "
                                + MeshFileError::remedy);
          if (word == "POINTS")
            read_points();
          else if (word == "CELLS")
            read_cells();
          else if (word == "CELL_TYPES")
            read_types();
          else if (word == "MaterialID")
            read_materials();
        }
      if (sections.count("CELL_TYPES") == 0 || sections.count("POINTS") == 0)
        throw MeshFileError("it is not a VTK file (legacy format) with an unstructured grid: "
                            "`POINTS`, `CELLS` or `CELL_TYPES` is missing. "
                            + MeshFileError::remedy);
      add_elements();
      return content;
    }


    void VtkCells::read_points()
    {
      const std::string where    = "the list of points";
      const auto        n_points = next<unsigned int>(in, "`POINTS`");
      std::string       type;
      in >> type;
      for (unsigned int p = 0; p < n_points; ++p)
        {
          content.points.emplace_back();
          for (unsigned int c = 0; c < 3; ++c)
            content.points.back()[c] = next<double>(in, where);
        }
    }


    void VtkCells::read_cells()
    {
      const std::string where   = "the list of cells";
      const auto        n_cells = next<unsigned int>(in, "`CELLS`");
      next<unsigned int>(in, "`CELLS`");
      refuse_offsets(in);
      for (unsigned int c = 0; c < n_cells; ++c)
        {
          cells.emplace_back();
          for (auto n = next<unsigned int>(in, where); n > 0; --n)
            {
              const auto point = next<long>(in, where);
              if (point < 0 || point >= static_cast<long>(content.points.size()))
                throw MeshFileError("the file is broken: cell " + std::to_string(c)
                                    + " (counted from 0) has the point " + std::to_string(point)
                                    + ", which does not exist. " + MeshFileError::remedy);
              cells.back().push_back(point);
            }
        }
    }


    void VtkCells::read_types()
    {
      next<unsigned int>(in, "`CELL_TYPES`");
      for (unsigned int c = 0; c < cells.size(); ++c)
        numbers_of_types.push_back(next<unsigned int>(in, "the list of cell types"));
    }


    /** `SCALARS MaterialID int 1`, and the line `LOOKUP_TABLE default`. */
    void VtkCells::read_materials()
    {
      std::string word;
      while (in >> word && word != "default")
        ;
      for (unsigned int c = 0; c < cells.size(); ++c)
        materials.push_back(std::max(0L, next<long>(in, "`MaterialID`")));
    }


    void VtkCells::add_elements()
    {
      if (numbers_of_types.size() != cells.size())
        throw MeshFileError("the file is broken: it has " + std::to_string(cells.size())
                            + " cells and " + std::to_string(numbers_of_types.size()) + " types. "
                            + MeshFileError::remedy);
      for (std::size_t c = 0; c < cells.size(); ++c)
        {
          const VtkCellType type  = vtk_type(numbers_of_types[c], c, cells[c].size());
          const CellShape  &shape = shape_of(type.kind);
          if (counts_by_rows(numbers_of_types[c]))
            for (std::size_t v = 2; v < cells[c].size(); v += 4)
              std::swap(cells[c][v], cells[c][v + 1]);
          MeshElement element;
          element.kind  = type.kind;
          element.label = c;
          if (c < materials.size())
            element.groups = content.group_of(shape.dim, materials[c]);
          content.add(element, cells[c], shape.edges);
        }
    }
  } // namespace


  MeshContent content_of_vtk(const std::string &text)
  {
    return VtkCells(text).read();
  }
} // namespace signorini
