// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/cube_mesh.h>

#include <algorithm>
#include <set>

namespace signorini
{
  namespace
  {
    void check_dimension(const MeshContent &content, const unsigned int dim)
    {
      unsigned int dim_of_file = 0;
      for (const MeshElement &element : content.elements)
        dim_of_file = std::max(dim_of_file, shape_of(element.kind).dim);
      if (dim_of_file < 2)
        throw MeshFileError("it does not contain any cells: there are no quadrilaterals and no "
                            "hexahedra, and nothing that can be split into them. "
                            + MeshFileError::remedy);
      if (dim_of_file != dim)
        throw MeshFileError("it is a mesh in " + std::to_string(dim_of_file)
                            + "d, but the scene has `Dimension = " + std::to_string(dim)
                            + "`. Use a mesh of " + std::to_string(dim)
                            + "d cells, or change the dimension.");
    }


    [[noreturn]] void
    refuse_part(const MeshContent &content, const unsigned int dim, const std::string &word)
    {
      std::vector<std::string> names;
      for (const MeshGroup &group : content.groups)
        if (group.dim == dim)
          names.push_back(group.name.empty() ? std::to_string(group.number) : group.name);
      throw MeshPartError("there is no group of cells `" + word + "` in the mesh. "
                          + (names.empty()
                               ? "It has none: remove this key, or make physical groups "
                                 "(Gmsh) or element sets (Abaqus)."
                               : suggestion(word, names)));
    }


    /** The groups with one of these names or numbers. */
    std::set<unsigned int>
    groups_named(const MeshContent &content, const unsigned int dim, const std::string &part)
    {
      std::set<unsigned int> result;
      for (const std::string &word : split(part, ','))
        {
          const std::size_t before = result.size();
          // As it is written, or else without a difference between small and capital letters.
          for (const bool exactly : {true, false})
            for (unsigned int g = 0; g < content.groups.size(); ++g)
              if (const MeshGroup &group = content.groups[g];
                  group.dim == dim && (exactly || result.size() == before)
                  && (exactly ? group.name == word || std::to_string(group.number) == word
                              : same_letters(group.name, word)))
                result.insert(g);
          if (result.size() == before)
            refuse_part(content, dim, word);
        }
      return result;
    }


    bool has_common(const std::vector<unsigned int> &groups, const std::set<unsigned int> &wanted)
    {
      return std::any_of(
        groups.begin(), groups.end(), [&](const unsigned int g) { return wanted.count(g) > 0; });
    }


    /** Make one of cells with the same corners. */
    void merge_repeated_cells(MeshPart &part)
    {
      std::vector<std::pair<std::array<unsigned int, 8>, std::size_t>> sorted;
      for (std::size_t c = 0; c < part.cells.size(); ++c)
        {
          sorted.emplace_back(part.cells[c].corners, c);
          const auto begin = sorted.back().first.begin();
          std::sort(begin, begin + shape_of(part.cells[c].kind).n_corners);
        }
      std::sort(sorted.begin(), sorted.end());
      std::vector<bool> is_repeated(part.cells.size(), false);
      for (std::size_t k = 1; k < sorted.size(); ++k)
        {
          const MeshElement &first  = part.cells[sorted[k - 1].second],
                            &second = part.cells[sorted[k].second];
          if (sorted[k].first != sorted[k - 1].first || first.kind != second.kind)
            continue;
          if (first.groups == second.groups)
            throw MeshFileError(part.name_of(sorted[k - 1].second) + " and "
                                + part.name_of(sorted[k].second)
                                + " are the same cell twice. Remove one of them.");
          is_repeated[sorted[k].second] = true;
        }
      std::vector<MeshElement> kept;
      for (std::size_t c = 0; c < part.cells.size(); ++c)
        if (!is_repeated[c])
          kept.push_back(part.cells[c]);
      part.cells = std::move(kept);
    }
  } // namespace


  std::string MeshPart::name_of(const std::size_t cell) const
  {
    const CellShape &shape = shape_of(cells[cell].kind);
    return all_are_cubes ? "cell " + std::to_string(cell + 1) + " (counted from 1 among the "
                             + shape.plural + ")"
                         : "cell " + std::to_string(cells[cell].label) + " (a " + shape.name + ")";
  }


  MeshPart select_part(const MeshContent &content, const unsigned int dim, const std::string &part)
  {
    check_dimension(content, dim);
    const std::set<unsigned int> wanted =
      part.empty() ? std::set<unsigned int>() : groups_named(content, dim, part);
    MeshPart result;
    for (const MeshElement &element : content.elements)
      {
        if (shape_of(element.kind).dim != dim)
          continue;
        if (!part.empty() && !has_common(element.groups, wanted))
          continue;
        if (element.kind == CellKind::pyramid)
          throw MeshFileError(
            "cell " + std::to_string(element.label)
            + " is a pyramid, which cannot be split into hexahedra. Mesh the body "
              "with tetrahedra, or with hexahedra alone.");
        result.all_are_cubes =
          result.all_are_cubes
          && (element.kind == CellKind::quadrilateral || element.kind == CellKind::hexahedron);
        result.cells.push_back(element);
      }
    if (result.cells.empty())
      throw MeshPartError("the group `" + part + "` has no cells. " + MeshFileError::remedy);
    merge_repeated_cells(result);
    return result;
  }
} // namespace signorini
