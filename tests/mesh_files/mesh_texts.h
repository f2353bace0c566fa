// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_mesh_files_mesh_texts_h
#define signorini_tests_mesh_files_mesh_texts_h

#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace signorini::tests
{
  using Rows = std::vector<std::vector<int>>;

  /** A number of a group of faces or cells, its name, and its elements; vertices from 0. */
  struct GroupText
  {
    int         number;
    std::string name;
    Rows        elements;
  };

  /** A mesh of simplices, to be written in any format. */
  struct MeshTexts
  {
    std::vector<std::vector<double>> points;
    GroupText                        cells;
    std::vector<GroupText>           faces;

    std::string gmsh_2() const;
    std::string gmsh_4() const;
    std::string abaqus() const;
    std::string ucd() const;
    std::string vtk() const;

  private:
    unsigned int n_elements() const;
    /** Cells, and then the groups of faces. */
    std::vector<GroupText> all() const;
  };

  /** The unit cube as six tetrahedra, with the groups 1 (below) and 2 (above). */
  inline MeshTexts cube_of_tetrahedra()
  {
    MeshTexts mesh;
    for (const double z : {0., 1.})
      for (const double y : {0., 1.})
        for (const double x : {0., 1.})
          mesh.points.push_back({x, y, z});
    mesh.cells = {
      9,
      "block",
      {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
    mesh.faces = {{1, "below", {{0, 3, 1}, {0, 2, 3}}}, {2, "above", {{4, 5, 7}, {4, 7, 6}}}};
    return mesh;
  }


  /** The unit square as two triangles, with the groups 1 (below) and 2 (above). */
  inline MeshTexts square_of_triangles()
  {
    return {{{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {0., 1., 0.}},
            {9, "block", {{0, 1, 2}, {0, 2, 3}}},
            {{1, "below", {{0, 1}}}, {2, "above", {{2, 3}}}}};
  }


  /** The numbers with a separator between; vertices count from @p first. */
  template <typename Number>
  std::string row(const std::vector<Number> &numbers, const std::string &separator, const int first)
  {
    std::ostringstream out;
    out.precision(17);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      out << (k == 0 ? "" : separator) << numbers[k] + first;
    return out.str();
  }


  inline std::vector<GroupText> MeshTexts::all() const
  {
    std::vector<GroupText> groups = {cells};
    groups.insert(groups.end(), faces.begin(), faces.end());
    return groups;
  }


  inline unsigned int MeshTexts::n_elements() const
  {
    unsigned int n = 0;
    for (const GroupText &group : all())
      n += group.elements.size();
    return n;
  }


  /** Dimension and Gmsh's type of a line, triangle or tetrahedron by its corners. */
  inline int dimension_of(const GroupText &group)
  {
    return group.elements[0].size() - 1;
  }
  inline int gmsh_type_of(const GroupText &group)
  {
    return dimension_of(group) == 3 ? 4 : dimension_of(group);
  }


  inline std::string names_of_gmsh(const std::vector<GroupText> &groups)
  {
    std::ostringstream out;
    out << "$PhysicalNames\n" << groups.size() << '\n';
    for (const GroupText &group : groups)
      out << dimension_of(group) << ' ' << group.number << " \"" << group.name << "\"\n";
    out << "$EndPhysicalNames\n";
    return out.str();
  }


  inline std::string MeshTexts::gmsh_2() const
  {
    std::ostringstream out;
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
        << names_of_gmsh(all()) << "$Nodes\n"
        << points.size() << '\n';
    for (std::size_t p = 0; p < points.size(); ++p)
      out << p + 1 << ' ' << row(points[p], " ", 0) << '\n';
    out << "$EndNodes\n$Elements\n" << n_elements() << '\n';
    int label = 0;
    for (const GroupText &group : all())
      for (const auto &element : group.elements)
        out << ++label << ' ' << gmsh_type_of(group) << " 2 " << group.number << " 1 "
            << row(element, " ", 1) << '\n';
    out << "$EndElements\n";
    return out.str();
  }


  inline std::string MeshTexts::gmsh_4() const
  {
    std::ostringstream out;
    const int          dim = dimension_of(cells);
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
        << names_of_gmsh(all()) << "$Entities\n"
        << (dim == 3 ? "0 0 2 1\n" : "0 2 1 0\n");
    for (std::size_t f = 0; f < faces.size(); ++f)
      out << f + 1 << " 0 0 0 1 1 1 1 " << faces[f].number << " 0\n";
    out << "1 0 0 0 1 1 1 1 " << cells.number << " 0\n$EndEntities\n$Nodes\n1 " << points.size()
        << " 1 " << points.size() << '\n'
        << dim << " 1 0 " << points.size() << '\n';
    for (std::size_t p = 0; p < points.size(); ++p)
      out << p + 1 << '\n';
    for (const auto &point : points)
      out << row(point, " ", 0) << '\n';
    out << "$EndNodes\n$Elements\n"
        << 1 + faces.size() << ' ' << n_elements() << " 1 " << n_elements() << '\n';
    int label = 0, entity = 0;
    for (const GroupText &group : all())
      {
        out << dimension_of(group) << ' ' << (entity == 0 ? 1 : entity) << ' '
            << gmsh_type_of(group) << ' ' << group.elements.size() << '\n';
        for (const auto &element : group.elements)
          out << ++label << ' ' << row(element, " ", 1) << '\n';
        ++entity;
      }
    out << "$EndElements\n";
    return out.str();
  }


  /** Faces are elements in sets with the names of the groups. */
  inline std::string MeshTexts::abaqus() const
  {
    std::ostringstream out;
    out << "*NODE\n";
    for (std::size_t p = 0; p < points.size(); ++p)
      out << p + 1 << ", " << row(points[p], ", ", 0) << '\n';
    const char *const types[] = {"", "T2D2", "CPS3", "C3D4"};
    int               label   = 0;
    for (const GroupText &group : all())
      {
        out << "*ELEMENT, TYPE=" << types[dimension_of(group)] << ", ELSET=" << group.name << '\n';
        for (const auto &element : group.elements)
          out << ++label << ", " << row(element, ", ", 1) << '\n';
      }
    return out.str();
  }


  inline std::string MeshTexts::ucd() const
  {
    std::ostringstream out;
    out << points.size() << ' ' << n_elements() << " 0 0 0\n";
    for (std::size_t p = 0; p < points.size(); ++p)
      out << p + 1 << ' ' << row(points[p], " ", 0) << '\n';
    const char *const types[] = {"", " line ", " tri ", " tet "};
    int               label   = 0;
    for (const GroupText &group : all())
      for (const auto &element : group.elements)
        out << ++label << ' ' << group.number << types[dimension_of(group)] << row(element, " ", 1)
            << '\n';
    return out.str();
  }


  /** With the numbers of groups as deal.II writes them. */
  inline std::string MeshTexts::vtk() const
  {
    std::ostringstream out, types, materials;
    out << "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS "
        << points.size() << " double\n";
    for (const auto &point : points)
      out << row(point, " ", 0) << '\n';
    std::ostringstream list;
    unsigned int       n_numbers  = 0;
    const int          vtk_type[] = {1, 3, 5, 10};
    for (const GroupText &group : all())
      for (const auto &element : group.elements)
        {
          list << element.size() << ' ' << row(element, " ", 0) << '\n';
          types << vtk_type[dimension_of(group)] << '\n';
          materials << group.number << '\n';
          n_numbers += 1 + element.size();
        }
    out << "CELLS " << n_elements() << ' ' << n_numbers << '\n'
        << list.str() << "CELL_TYPES " << n_elements() << '\n'
        << types.str() << "CELL_DATA " << n_elements()
        << "\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n"
        << materials.str();
    return out.str();
  }
} // namespace signorini::tests

#endif
