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
    /** The corner that follows the smallest one, around the face as the cell sees it. */
    unsigned int second_corner(const MeshPart &part, const FaceOfCell &face)
    {
      const MeshElement &cell   = part.cells[face.cell];
      const auto        &around = shape_of(cell.kind).faces[face.face];
      for (std::size_t v = 0; v < around.size(); ++v)
        if (cell.corners[around[v]] == face.key[0])
          return cell.corners[around[(v + 1) % around.size()]];
      return face.key[0];
    }


    /** Neighbours go around their face in opposite directions, as both have positive volumes. */
    bool are_on_one_side(const MeshPart &part, const FaceOfCell &first, const FaceOfCell &second)
    {
      const std::size_t n_corners = shape_of(part.cells[first.cell].kind).faces[first.face].size();
      if (n_corners > 2)
        return second_corner(part, first) == second_corner(part, second);
      const auto start = [&](const FaceOfCell &face) {
        const MeshElement &cell = part.cells[face.cell];
        return cell.corners[shape_of(cell.kind).faces[face.face][0]];
      };
      return start(first) == start(second);
    }


    [[noreturn]] void
    refuse_overlap(const MeshPart &part, const std::size_t first, const std::size_t second)
    {
      throw MeshFileError(part.name_of(first) + " and " + part.name_of(second)
                          + " overlap: they lie on the same side of a common face. Correct the "
                            "mesh there.");
    }


    /** A corner of a face, which tells where it is. */
    std::string place(const MeshContent &content, const FaceOfCell &face)
    {
      const dealii::Point<3> &point = content.points[face.key[0]];
      return "(" + dealii::Utilities::to_string(point[0]) + " "
             + dealii::Utilities::to_string(point[1]) + " " + dealii::Utilities::to_string(point[2])
             + ")";
    }


    using Key = std::array<unsigned int, 4>;

    /** The groups of faces that have one, by their corners. */
    std::map<Key, std::set<unsigned int>> groups_of_faces(const MeshContent &content,
                                                          const unsigned int dim)
    {
      std::map<Key, std::set<unsigned int>> result;
      for (const MeshElement &element : content.elements)
        if (const CellShape &shape = shape_of(element.kind);
            shape.dim == dim && !element.groups.empty())
          {
            std::vector<unsigned int> around;
            for (unsigned int v = 0; v < shape.n_corners; ++v)
              around.push_back(v);
            result[key_of_face(element.corners, around)].insert(element.groups.begin(),
                                                                element.groups.end());
          }
      return result;
    }


    /** The boundary id of each combination of groups, by their numbers. */
    class Combinations
    {
    public:
      explicit Combinations(const MeshContent &content)
        : content(content)
      {
        for (const MeshGroup &group : content.groups)
          next = std::max(next, group.number + 1);
      }

      dealii::types::boundary_id id_of(const std::set<unsigned int> &groups)
      {
        std::set<unsigned int> numbers;
        for (const unsigned int g : groups)
          numbers.insert(content.groups[g].number);
        if (numbers.size() == 1)
          return *numbers.begin();
        const auto [id, is_new] = ids.emplace(numbers, next);
        next += is_new;
        return id->second;
      }

    private:
      const MeshContent                             &content;
      std::map<std::set<unsigned int>, unsigned int> ids;
      unsigned int                                   next = 1;
    };


    void
    note_group(const MeshGroup &group, const dealii::types::boundary_id id, MeshBoundary &boundary)
    {
      for (const std::string &name : {group.name, std::to_string(group.number)})
        if (auto &ids = boundary.groups[name];
            !name.empty() && std::find(ids.begin(), ids.end(), id) == ids.end())
          ids.push_back(id);
    }
  } // namespace


  std::vector<FaceOfCell> faces_of(const MeshPart &part)
  {
    std::vector<FaceOfCell> faces;
    for (unsigned int c = 0; c < part.cells.size(); ++c)
      {
        const auto &all = shape_of(part.cells[c].kind).faces;
        for (unsigned int f = 0; f < all.size(); ++f)
          faces.push_back({key_of_face(part.cells[c].corners, all[f]), c, f});
      }
    std::sort(faces.begin(), faces.end());
    for (std::size_t k = 1; k < faces.size(); ++k)
      if (faces[k].key == faces[k - 1].key
          && ((k > 1 && faces[k].key == faces[k - 2].key)
              || are_on_one_side(part, faces[k - 1], faces[k])))
        refuse_overlap(part, faces[k - 1].cell, faces[k].cell);
    return faces;
  }


  MeshBoundary boundary_of(const MeshContent &content, const MeshPart &part)
  {
    const unsigned int            dim   = shape_of(part.cells[0].kind).dim;
    const std::vector<FaceOfCell> faces = faces_of(part);
    auto                          named = groups_of_faces(content, dim - 1);
    Combinations                  combinations(content);
    MeshBoundary                  result;
    for (std::size_t k = 0; k < faces.size(); ++k)
      {
        const auto group = named.find(faces[k].key);
        if (k + 1 < faces.size() && faces[k].key == faces[k + 1].key)
          {
            if (group != named.end())
              throw MeshFileError(
                "an internal face, with the vertex " + place(content, faces[k])
                + ", is in a group. Write the mesh again, with groups of faces on its boundary "
                  "only, or select the cells on one side (`Part`).");
            ++k;
            continue;
          }
        result.faces.push_back(faces[k]);
        result.ids.push_back(0);
        if (group == named.end())
          continue;
        result.ids.back() = combinations.id_of(group->second);
        for (const unsigned int g : group->second)
          note_group(content.groups[g], result.ids.back(), result);
        named.erase(group);
      }
    result.groups.erase("");
    result.n_left_out = named.size();
    return result;
  }
} // namespace signorini
