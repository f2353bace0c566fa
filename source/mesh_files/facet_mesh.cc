// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/mesh_files/facet_mesh.h>
#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_file.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    template <int dim>
    std::string name_of_facets()
    {
      return dim == 2 ? "lines" : "facets";
    }


    /** The faces of the cells at the boundary of a mesh. */
    template <int dim>
    FacetMesh<dim> boundary_of_cells(const std::string &path)
    {
      dealii::Triangulation<dim> cells;
      read_mesh_file(path, cells);
      FacetMesh<dim> result;
      result.vertices = cells.get_vertices();
      for (const auto &cell : cells.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              std::vector<long> around;
              for (const unsigned int v : {0, 1, 3, 2})
                if (v < face->n_vertices())
                  around.push_back(face->vertex_index(v));
              const dealii::Tensor<1, dim> along = face->vertex(1) - face->vertex(0);
              dealii::Tensor<1, dim>       normal;
              if constexpr (dim == 2)
                normal = dealii::cross_product_2d(along);
              else
                normal = dealii::cross_product_3d(along, face->vertex(2) - face->vertex(0));
              if (normal * (face->center() - cell->center()) < 0.)
                std::reverse(around.begin(), around.end());
              add_polygon(result, around);
            }
      return result;
    }


    /** A format of surfaces. */
    template <int dim>
    struct SurfaceFormat
    {
      const char *extension;
      const char *remark; ///< for messages
      FacetMesh<dim> (*read)(const std::string &path);
    };


    template <int dim>
    FacetMesh<dim> read_stl([[maybe_unused]] const std::string &path)
    {
      if constexpr (dim == 3)
        return facets_of_stl(read_mesh_content(path));
      throw MeshFileError("STL files are surfaces in space, and the scene has `Dimension = "
                          "2`. Give a line, as .obj or .vtk, or a mesh of cells.");
    }


    template <int dim, FacetMesh<dim> (*facets_of)(const std::string &)>
    FacetMesh<dim> read_text(const std::string &path)
    {
      return facets_of(read_mesh_lines(path));
    }


    template <int dim>
    constexpr SurfaceFormat<dim> surface_formats[] = {
      {".stl", "STL, 3d", read_stl<dim>},
      {".obj", "OBJ", read_text<dim, facets_of_obj<dim>>},
      {".vtk", "VTK", read_text<dim, facets_of_vtk<dim>>}};


    template <int dim>
    const SurfaceFormat<dim> *surface_format_of(const std::string &path)
    {
      const std::string        extension = extension_of(path);
      std::vector<std::string> names;
      for (const SurfaceFormat<dim> &format : surface_formats<dim>)
        {
          if (extension == format.extension)
            return &format;
          names.push_back(format.extension + std::string(" (") + format.remark + ")");
        }
      if (!is_mesh_extension(extension))
        throw MeshFileError("the extension `" + extension + "` is not known. Valid: " + join(names)
                            + " of " + name_of_facets<dim>() + ", and " + list_of_mesh_formats()
                            + " of cells, whose boundary counts.");
      return nullptr;
    }
  } // namespace


  template <int dim>
  dealii::Point<dim> point_of_file(const std::array<double, 3> &coordinates)
  {
    dealii::Point<dim> point;
    for (unsigned int c = 0; c < dim; ++c)
      point[c] = coordinates[c];
    if (dim == 2 && coordinates[2] != 0.)
      throw MeshFileError("it has points with z other than 0, and the scene has `Dimension = 2`. "
                          "Give a line in the plane z = 0, or change the dimension.");
    return point;
  }


  template <int dim>
  void add_polygon(FacetMesh<dim> &mesh, const std::vector<long> &vertices)
  {
    std::vector<unsigned int> known;
    for (const long v : vertices)
      {
        if (v < 0 || v >= static_cast<long>(mesh.vertices.size()))
          throw MeshFileError("the file is broken: a facet has the vertex " + std::to_string(v)
                              + " (counted from 0), which does not exist. "
                              + MeshFileError::remedy);
        known.push_back(v);
      }
    for (std::size_t k = 1; k + dim - 2 < known.size(); ++k)
      if constexpr (dim == 2)
        mesh.facets.push_back({{known[k - 1], known[k]}});
      else
        mesh.facets.push_back({{known[0], known[k], known[k + 1]}});
  }


  template <int dim>
  FacetMesh<dim> read_facet_mesh(const std::string &path)
  {
    try
      {
        FacetMesh<dim> result;
        if (const auto *format = surface_format_of<dim>(path); format != nullptr)
          result = format->read(path);
        if (!result.facets.empty())
          return result;
        if (!is_mesh_extension(extension_of(path)))
          throw MeshFileError("it has no " + name_of_facets<dim>() + ". " + MeshFileError::remedy);
        return boundary_of_cells<dim>(path); // begins its messages with the path
      }
    catch (const MeshFileError &error)
      {
        throw UserError(path + ": " + error.what());
      }
  }


#define INSTANTIATE(dim)                                                                           \
  template dealii::Point<dim> point_of_file<dim>(const std::array<double, 3> &);                   \
  template void               add_polygon(FacetMesh<dim> &, const std::vector<long> &);            \
  template FacetMesh<dim>     read_facet_mesh<dim>(const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
