// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/cube_mesh.h>
#include <signorini/mesh_files/mesh_file.h>

#include <deal.II/base/bounding_box.h>

#include <deal.II/grid/grid_tools.h>

#include <set>
#include <sstream>

namespace signorini
{
  namespace
  {
    using dealii::Triangulation;

    /** The first sentence of what a deal.II exception says. */
    std::string reason(const dealii::ExceptionBase &exception)
    {
      std::ostringstream info;
      exception.print_info(info);
      std::string text = trim(info.str());
      text             = text.substr(0, text.find(". "));
      while (!text.empty() && text.back() == '.')
        text.pop_back();
      return text;
    }


    /** All that a file says of a body. */
    template <int dim>
    struct BodyMesh
    {
      MeshContent   content;
      MeshPart      part;
      MeshBoundary  boundary;
      CubeMesh<dim> cubes;
      double        quality = 1.; ///< see smallest_jacobian()
    };


    template <int dim>
    BodyMesh<dim>
    read_body_mesh(const std::string &path, const std::string &part, const double scale)
    {
      BodyMesh<dim> body;
      body.content = read_mesh_content_of(path);
      body.part    = select_part(body.content, dim, part);
      for (auto &point : body.content.points)
        point *= scale;
      orient_cells(body.content.points, body.content.turns_cells, body.part);
      body.boundary = boundary_of(body.content, body.part);
      body.cubes    = body.part.all_are_cubes
                        ? cubes_of<dim>(body.content, body.part, body.boundary)
                        : split_into_cubes<dim>(body.content, body.part, body.boundary);
      body.quality  = smallest_jacobian(body.cubes, body.part);
      return body;
    }


    template <int dim>
    void make_triangulation(CubeMesh<dim> cubes, Triangulation<dim> &mesh)
    {
      try
        {
          dealii::GridTools::consistently_order_cells(cubes.cells);
          mesh.create_triangulation(cubes.points, cubes.cells, cubes.faces);
        }
      catch (const dealii::ExceptionBase &exception)
        {
          mesh.clear();
          throw MeshFileError("no mesh can be made of it: " + reason(exception) + ". "
                              + MeshFileError::remedy);
        }
    }


    /** `12 tetrahedra and 3 wedges`. */
    std::string cells_in_words(const MeshPart &part)
    {
      std::map<CellKind, std::size_t> counts;
      for (const MeshElement &cell : part.cells)
        ++counts[cell.kind];
      std::vector<std::string> words;
      for (const auto &[kind, n] : counts)
        words.push_back(std::to_string(n) + " "
                        + (n == 1 ? shape_of(kind).name : shape_of(kind).plural));
      return join(words, " and ");
    }


    /** What was made of the file, in clauses. */
    template <int dim>
    std::vector<std::string> notes_about(const BodyMesh<dim> &body, const bool is_whole)
    {
      std::vector<std::string> notes;
      const bool               has_curves = !body.content.middles.empty();
      if (!body.part.all_are_cubes)
        {
          std::ostringstream note;
          note.precision(3);
          note << cells_in_words(body.part) << (body.part.cells.size() == 1 ? " is" : " are")
               << " split into " << body.cubes.cells.size()
               << (dim == 2 ? " quadrilaterals" : " hexahedra")
               << "; the smallest scaled Jacobian is " << body.quality << " (of a cube: 1). "
               << (has_curves
                     ? "The nodes in the middle of edges keep curved surfaces, with facets "
                       "that"
                     : "The surface keeps the facets of the file, which")
               << " `Refinements` do not round";
          notes.push_back(note.str());
        }
      else if (has_curves)
        notes.push_back("cells of second order are reduced to their corners; edges are straight");
      if (is_whole && body.boundary.n_left_out > 0)
        notes.push_back(std::to_string(body.boundary.n_left_out)
                        + " faces of groups in the file belong to no cell, and are left out");
      return notes;
    }


    template <typename Action>
    auto naming_path(const std::string &path, const Action &action)
    {
      try
        {
          return action();
        }
      catch (const MeshPartError &error)
        {
          throw UnknownMeshPart(path + ": " + error.what());
        }
      catch (const MeshFileError &error)
        {
          throw UserError(path + ": " + error.what());
        }
    }
  } // namespace


  template <int dim>
  void read_mesh_file(const std::string  &path,
                      Triangulation<dim> &mesh,
                      const std::string  &part,
                      const double        scale)
  {
    naming_path(path,
                [&] { make_triangulation(read_body_mesh<dim>(path, part, scale).cubes, mesh); });
  }


  template <int dim>
  MeshFile<dim>
  describe_mesh_file(const std::string &path, const std::string &part, const double scale)
  {
    return naming_path(path, [&] {
      BodyMesh<dim> body = read_body_mesh<dim>(path, part, scale);
      check_that_cells_are_apart(body.content.points, body.part);
      Triangulation<dim> mesh;
      make_triangulation(body.cubes, mesh);
      MeshFile<dim> result;
      result.path       = path;
      result.part       = part;
      result.scale      = scale;
      result.boundaries = body.boundary.groups;
      result.notes      = notes_about(body, part.empty());
      result.centre     = dealii::BoundingBox<dim>(mesh.get_vertices()).center();
      std::map<dealii::types::boundary_id, std::set<unsigned int>> vertices;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            for (const unsigned int v : face->vertex_indices())
              vertices[face->boundary_id()].insert(face->vertex_index(v));
      for (const auto &[id, indices] : vertices)
        for (const unsigned int index : indices)
          result.boundary_vertices[id].push_back(mesh.get_vertices()[index]);
      return result;
    });
  }


#define INSTANTIATE(dim)                                                                           \
  template void read_mesh_file(                                                                    \
    const std::string &, dealii::Triangulation<dim> &, const std::string &, double);               \
  template MeshFile<dim> describe_mesh_file(const std::string &, const std::string &, double)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
