// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <unordered_map>

// deal.II has a reader of its own. It believes what it reads: a count too large, or an element
// in four dimensions, end the program.

namespace signorini
{
  namespace
  {
    using Edges = std::vector<CellShape::Edge>;

    /** A type of elements of Gmsh. */
    struct GmshType
    {
      CellKind     kind;
      unsigned int n_nodes;
    };

    const std::map<unsigned int, GmshType> gmsh_types = {{15, {CellKind::point, 1}},
                                                         {1, {CellKind::line, 2}},
                                                         {2, {CellKind::triangle, 3}},
                                                         {3, {CellKind::quadrilateral, 4}},
                                                         {4, {CellKind::tetrahedron, 4}},
                                                         {5, {CellKind::hexahedron, 8}},
                                                         {6, {CellKind::wedge, 6}},
                                                         {7, {CellKind::pyramid, 5}},
                                                         {8, {CellKind::line, 3}},
                                                         {9, {CellKind::triangle, 6}},
                                                         {10, {CellKind::quadrilateral, 9}},
                                                         {11, {CellKind::tetrahedron, 10}},
                                                         {12, {CellKind::hexahedron, 27}},
                                                         {13, {CellKind::wedge, 18}},
                                                         {14, {CellKind::pyramid, 14}},
                                                         {16, {CellKind::quadrilateral, 8}},
                                                         {17, {CellKind::hexahedron, 20}},
                                                         {18, {CellKind::wedge, 15}},
                                                         {19, {CellKind::pyramid, 13}}};

    /** The edges in the order in which Gmsh lists the nodes in their middle. */
    const Edges &edges_in_order(const CellKind kind)
    {
      static const std::map<CellKind, Edges> own_order = {
        {CellKind::tetrahedron, {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}},
        {CellKind::pyramid, {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}},
        {CellKind::wedge, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}}},
        {CellKind::hexahedron,
         {{0, 1},
          {0, 3},
          {0, 4},
          {1, 2},
          {1, 5},
          {2, 3},
          {2, 6},
          {3, 7},
          {4, 5},
          {4, 7},
          {5, 6},
          {6, 7}}}};
      const auto found = own_order.find(kind);
      return found == own_order.end() ? shape_of(kind).edges : found->second;
    }


    const GmshType &gmsh_type(const unsigned int number)
    {
      const auto found = gmsh_types.find(number);
      if (found == gmsh_types.end())
        throw MeshFileError("it has elements of Gmsh's type " + std::to_string(number)
                            + ", which is not known. " + MeshFileError::first_order);
      return found->second;
    }


    class GmshReader
    {
    public:
      explicit GmshReader(const std::string &text)
        : in(text)
      {
        content.turns_cells = true;
      }
      MeshContent read();

    private:
      void read_section(const std::string &name);
      /** The number of a group; its sign only tells the direction of its elements. */
      long read_group();
      void read_format();
      void read_names();
      void read_entities();
      void read_nodes();
      void read_node(long tag, unsigned int n_parameters);
      void read_elements();
      void read_element_of_version_2();
      void read_block_of_elements();
      void read_corners(MeshElement element, const GmshType &type);

      std::istringstream                     in;
      double                                 version = 1.;
      std::string                            where; ///< the present section, in words
      MeshContent                            content;
      std::unordered_map<long, unsigned int> point_of_tag;
      /** By dimension and number of a part of the geometry. */
      std::map<std::pair<long, long>, std::vector<unsigned int>> groups_of_entity;
    };


    MeshContent GmshReader::read()
    {
      std::string           line, open;
      std::set<std::string> sections;
      while (std::getline(in, line))
        {
          line = trim(line);
          if (line.empty() || line[0] != '$')
            continue;
          const bool ends = line.rfind("$End", 0) == 0 || line.rfind("$END", 0) == 0;
          if (ends ? line.substr(4) != open : !open.empty())
            throw MeshFileError("the file is broken: the section `$" + open
                                + "` has no end before `" + line + "`. " + MeshFileError::remedy);
          open = ends ? "" : line.substr(1);
          if (!open.empty() && !sections.insert(open).second)
            throw MeshFileError("the file is broken: it has the section `" + line + "` twice. "
                                + MeshFileError::remedy);
          where = "the section `" + line + "`";
          read_section(open);
        }
      if (!open.empty())
        throw MeshFileError("the file is broken: it ends in the section `$" + open + "`. "
                            + MeshFileError::remedy);
      if (sections.count("Nodes") + sections.count("NOD") == 0
          || sections.count("Elements") + sections.count("ELM") == 0)
        throw MeshFileError(
          "it is not a Gmsh mesh: it has no section `$Nodes` or no section `$Elements`. "
          + MeshFileError::remedy);
      return content;
    }


    void GmshReader::read_section(const std::string &name)
    {
      if (name == "MeshFormat")
        read_format();
      else if (name == "PhysicalNames")
        read_names();
      else if (name == "Entities")
        read_entities();
      else if (name == "Nodes" || name == "NOD")
        read_nodes();
      else if (name == "Elements" || name == "ELM")
        read_elements();
    }


    long GmshReader::read_group()
    {
      const auto number = next<long>(in, where);
      return number < 0 && number > std::numeric_limits<int>::min() ? -number : number;
    }


    void GmshReader::read_format()
    {
      std::string line;
      std::getline(in, line);
      std::istringstream numbers(line);
      version = next<double>(numbers, where);
      if (next<int>(numbers, where) != 0 || version < 2. || version > 4.1)
        throw MeshFileError("the version of the Gmsh file, `" + trim(line)
                            + "`, is not known. Save it as text (ASCII) in version 2.2 or 4.1.");
    }


    void GmshReader::read_names()
    {
      const auto n_names = next<unsigned long>(in, where);
      for (unsigned long n = 0; n < n_names; ++n)
        {
          const auto  dim    = next<unsigned int>(in, where);
          const long  number = read_group();
          std::string name;
          std::getline(in, name);
          name = trim(name);
          if (dim > 3 || name.size() < 2 || name.front() != '"' || name.back() != '"')
            refuse_end(where);
          for (const unsigned int group : content.group_of(dim, number))
            content.groups[group].name = name.substr(1, name.size() - 2);
        }
    }


    /** Only in version 4: what the blocks of nodes and elements belong to. */
    void GmshReader::read_entities()
    {
      std::array<unsigned long, 4> n_of_dim = {};
      for (unsigned long &n : n_of_dim)
        n = next<unsigned long>(in, where);
      for (unsigned int dim = 0; dim < 4; ++dim)
        for (unsigned long entity = 0; entity < n_of_dim[dim]; ++entity)
          {
            auto &groups = groups_of_entity[{dim, next<long>(in, where)}];
            skip_numbers(in, (dim == 0 && version > 4. ? 3 : 6), where); // its place
            for (auto n = next<unsigned long>(in, where); n > 0; --n)
              for (const unsigned int group : content.group_of(dim, read_group()))
                groups.push_back(group);
            if (dim > 0)
              skip_numbers(in, next<unsigned long>(in, where), where); // its boundary
          }
    }


    void GmshReader::read_node(const long tag, const unsigned int n_parameters)
    {
      if (!point_of_tag.emplace(tag, static_cast<unsigned int>(content.points.size())).second)
        throw MeshFileError("the file is broken: node " + std::to_string(tag) + " is given twice. "
                            + MeshFileError::remedy);
      dealii::Point<3> point;
      for (unsigned int c = 0; c < 3; ++c)
        point[c] = next<double>(in, where);
      skip_numbers(in, n_parameters, where);
      content.points.push_back(point);
    }


    void GmshReader::read_nodes()
    {
      const auto n_blocks = (version < 4. ? 1u : next<unsigned int>(in, where));
      const auto n_nodes  = next<unsigned long>(in, where);
      if (version > 4.)
        skip_numbers(in, 2, where); // smallest and largest number of a node
      for (unsigned int block = 0; block < n_blocks; ++block)
        {
          unsigned int n_parameters = 0;
          if (version >= 4.)
            {
              const auto first = next<long>(in, where), second = next<long>(in, where);
              const long dim = version > 4. ? first : second;
              if (next<int>(in, where) != 0)
                n_parameters = static_cast<unsigned int>(std::min(3L, std::max(0L, dim)));
            }
          const auto        n = (version < 4. ? n_nodes : next<unsigned long>(in, where));
          std::vector<long> tags;
          for (unsigned long node = 0; version > 4. && node < n; ++node)
            tags.push_back(next<long>(in, where));
          for (unsigned long node = 0; node < n; ++node)
            read_node(version > 4. ? tags[node] : next<long>(in, where), n_parameters);
        }
      if (content.points.size() != n_nodes)
        throw MeshFileError("the file is broken: " + where + " announces " + std::to_string(n_nodes)
                            + " nodes and has " + std::to_string(content.points.size()) + ". "
                            + MeshFileError::remedy);
    }


    void GmshReader::read_elements()
    {
      const auto n_blocks = next<unsigned long>(in, where); // before version 4: elements
      if (version >= 4.)
        skip_numbers(in, version > 4. ? 3 : 1, where);
      for (unsigned long block = 0; block < n_blocks; ++block)
        if (version < 4.)
          read_element_of_version_2();
        else
          read_block_of_elements();
    }


    void GmshReader::read_element_of_version_2()
    {
      MeshElement element;
      element.label    = next<long>(in, where);
      const auto &type = gmsh_type(next<unsigned int>(in, where));
      element.kind     = type.kind;
      // Version 1 has two numbers of groups and the number of nodes.
      const auto n_tags = version < 2. ? 3 : next<unsigned int>(in, where);
      if (n_tags > 0)
        element.groups = content.group_of(shape_of(type.kind).dim, read_group());
      skip_numbers(in, std::max(1u, n_tags) - 1, where);
      read_corners(element, type);
    }


    void GmshReader::read_block_of_elements()
    {
      const auto first = next<long>(in, where), second = next<long>(in, where);
      const auto [dim, entity] = version > 4. ? std::pair(first, second) : std::pair(second, first);
      if (dim < 0 || dim > 3)
        throw MeshFileError("the file is broken: " + where + " has elements in "
                            + std::to_string(dim) + " dimensions. " + MeshFileError::remedy);
      MeshElement element;
      const auto &type = gmsh_type(next<unsigned int>(in, where));
      element.kind     = type.kind;
      if (dim == shape_of(type.kind).dim)
        element.groups = groups_of_entity[{dim, entity}];
      for (auto n = next<unsigned long>(in, where); n > 0; --n)
        {
          element.label = next<long>(in, where);
          read_corners(element, type);
        }
    }


    void GmshReader::read_corners(const MeshElement element, const GmshType &type)
    {
      std::vector<unsigned int> nodes;
      for (unsigned int v = 0; v < type.n_nodes; ++v)
        {
          const auto tag   = next<long>(in, where);
          const auto found = point_of_tag.find(tag);
          if (found == point_of_tag.end())
            throw MeshFileError("the file is broken: element " + std::to_string(element.label)
                                + " has a node of index " + std::to_string(tag)
                                + ", which does not exist. " + MeshFileError::remedy);
          nodes.push_back(found->second);
        }
      content.add(element, nodes, edges_in_order(type.kind));
    }
  } // namespace


  MeshContent content_of_gmsh(const std::string &text)
  {
    return GmshReader(text).read();
  }
} // namespace signorini
