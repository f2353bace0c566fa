// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

#include <array>
#include <map>
#include <set>
#include <sstream>

namespace signorini
{
  namespace
  {
    /**
     * Section Entities of version 4: what the groups of nodes and elements belong to. deal.II
     * believes its counts, however large.
     */
    void check_gmsh_entities(std::istream &in, const double version, const std::string &where)
    {
      std::array<unsigned long, 4> n_of_dim = {};
      for (unsigned long &n : n_of_dim)
        n = next<unsigned long>(in, where);
      for (unsigned int dim = 0; dim < 4; ++dim)
        for (unsigned long entity = 0; entity < n_of_dim[dim]; ++entity)
          {
            skip_numbers(in, 1 + (dim == 0 && version > 4. ? 3 : 6), where); // number and place
            skip_numbers(in, next<unsigned long>(in, where), where);         // physical groups
            if (dim > 0)
              skip_numbers(in, next<unsigned long>(in, where), where); // its boundary
          }
    }
  } // namespace

  namespace
  {
    /** Section Nodes of version 1 to 4.1: as many as announced? deal.II relies on it. */
    void check_gmsh_nodes(std::istream &in, const double version, const std::string &where)
    {
      const auto n_blocks = (version < 4. ? 1u : next<unsigned int>(in, where));
      const auto n_nodes  = next<unsigned long>(in, where);
      if (version > 4.)
        skip_numbers(in, 2, where); // smallest and largest number of a node
      unsigned long n_found = 0;
      for (unsigned int block = 0; block < n_blocks; ++block)
        {
          if (version >= 4.)
            skip_numbers(in, 3, where);
          const auto n = (version < 4. ? n_nodes : next<unsigned long>(in, where));
          skip_numbers(in, n, where);     // numbers of nodes
          skip_numbers(in, 3 * n, where); // coordinates
          n_found += n;
        }
      if (n_found != n_nodes)
        throw MeshFileError("the file is broken: " + where + " announces " + std::to_string(n_nodes)
                            + " nodes and has " + std::to_string(n_found) + ". "
                            + MeshFileError::remedy);
    }
  } // namespace

  namespace
  {
    /**
     * What a block of elements of version 4 begins with: dimension and number of what it belongs
     * to, and the type. deal.II believes the dimension, which counts in a table.
     */
    unsigned int type_of_block(std::istream &in, const double version, const std::string &where)
    {
      const auto first = next<long>(in, where), second = next<long>(in, where);
      const long dim = version > 4. ? first : second;
      if (dim < 0 || dim > 3)
        throw MeshFileError("the file is broken: " + where + " has elements in "
                            + std::to_string(dim) + " dimensions. " + MeshFileError::remedy);
      return next<unsigned int>(in, where);
    }


    /** Section Elements of version 1 to 4.1: only points, lines, quadrilaterals and hexahedra? */
    void check_gmsh_elements(std::istream &in, const double version, const std::string &where)
    {
      // By type: the number of nodes. Others have triangles, or nodes in the middle of edges.
      const std::map<unsigned int, unsigned int> n_nodes_of = {{15, 1}, {1, 2}, {3, 4}, {5, 8}};
      const std::set<unsigned int>               with_triangles{2, 4, 6, 7};
      const auto                                 n_nodes = [&](const unsigned int type) {
        const auto  found = n_nodes_of.find(type);
        const auto &remedy =
          with_triangles.count(type) > 0 ? MeshFileError::subdivide : MeshFileError::first_order;
        if (found == n_nodes_of.end())
          throw MeshFileError(
            "it has elements of Gmsh's type " + std::to_string(type)
            + ". Only quadrilaterals with 4 nodes (2d, type 3) and hexahedra with "
                                              "8 (3d, type 5) can be used. "
            + remedy);
        return found->second;
      };
      const auto n_blocks = next<unsigned long>(in, where); // version 2: elements
      if (version >= 4.)
        skip_numbers(in, version > 4. ? 3 : 1, where);
      for (unsigned long block = 0; block < n_blocks; ++block)
        if (version < 4.)
          {
            next<unsigned long>(in, where);
            const auto type = next<unsigned int>(in, where);
            // Version 1 has two numbers of groups and the number of nodes.
            const auto n_tags = version < 2. ? 3 : next<unsigned int>(in, where);
            skip_numbers(in, n_tags, where);
            skip_numbers(in, n_nodes(type), where);
          }
        else
          {
            const auto type = type_of_block(in, version, where);
            skip_numbers(in, next<unsigned long>(in, where) * (1 + n_nodes(type)), where);
          }
    }
  } // namespace

  void check_gmsh(const std::string &text)
  {
    std::istringstream    in(text);
    std::string           line, open;
    std::set<std::string> sections;
    double                version = 1.;
    while (std::getline(in, line))
      {
        line = trim(line);
        if (line.empty() || line[0] != '$')
          continue;
        const bool ends = line.rfind("$End", 0) == 0 || line.rfind("$END", 0) == 0;
        if (ends ? line.substr(4) != open : !open.empty())
          throw MeshFileError("the file is broken: the section `$" + open + "` has no end before `"
                              + line + "`. " + MeshFileError::remedy);
        open = ends ? "" : line.substr(1);
        sections.insert(line.substr(1));
        const std::string where = "the section `" + line + "`";
        if (line == "$Entities")
          check_gmsh_entities(in, version, where);
        if (line == "$Nodes" || line == "$NOD")
          check_gmsh_nodes(in, version, where);
        if (line == "$Elements" || line == "$ELM")
          check_gmsh_elements(in, version, where);
        if (line == "$MeshFormat" && std::getline(in, line))
          {
            std::istringstream numbers(line);
            version = next<double>(numbers, "the section `$MeshFormat`");
            if (next<int>(numbers, "the section `$MeshFormat`") != 0 || version < 2.
                || version > 4.1)
              throw MeshFileError(
                "the version of the Gmsh file, `" + trim(line)
                + "`, is not known. Save it as text (ASCII) in version 2.2 or 4.1.");
          }
      }
    if (!open.empty())
      throw MeshFileError("the file is broken: it ends in the section `$" + open + "`. "
                          + MeshFileError::remedy);
    if (sections.count("Nodes") + sections.count("NOD") == 0
        || sections.count("Elements") + sections.count("ELM") == 0)
      throw MeshFileError(
        "it is not a Gmsh mesh: it has no section `$Nodes` or no section `$Elements`. "
        + MeshFileError::remedy);
  }
} // namespace signorini
