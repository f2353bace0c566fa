// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/mesh_files/facet_mesh.h>
#include <signorini/mesh_files/mesh_file.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** The faces of the cells at the boundary of a mesh. */
    template <int dim>
    FacetMesh<dim> boundary_of(const std::string &path)
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


    template <int dim>
    FacetMesh<dim> facets_of(const std::string &path, const std::string &extension)
    {
      if (extension == ".stl")
        {
          if constexpr (dim == 3)
            return facets_of_stl(read_mesh_content(path));
          throw MeshFileError("STL files are surfaces in space, and the scene has `Dimension = "
                              "2`. Give a line, as .obj or .vtk, or a mesh of quadrilaterals.");
        }
      if (extension == ".obj")
        return facets_of_obj<dim>(read_mesh_content(path));
      if (extension == ".vtk")
        if (auto result = facets_of_vtk<dim>(read_mesh_content(path)); !result.facets.empty())
          return result;
      return {};
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
        const std::string extension = extension_of(path);
        for (const char *known : {".stl", ".obj", ".vtk", ".msh", ".inp", ".ucd"})
          if (extension == known)
            {
              FacetMesh<dim> result = facets_of<dim>(path, extension);
              if (!result.facets.empty())
                return result;
              if (extension == ".stl" || extension == ".obj")
                throw MeshFileError(std::string("it has no ") + (dim == 2 ? "lines" : "facets")
                                    + ". " + MeshFileError::remedy);
              return boundary_of<dim>(path); // begins its messages with the path
            }
        throw MeshFileError(
          "the extension `" + extension
          + "` is not known. Valid: .stl (3d), .obj, .vtk (surfaces, in 2d lines), and .msh "
            "(Gmsh), .inp (Abaqus or UCD), .ucd (UCD), .vtk (VTK) of cells, whose boundary "
            "counts.");
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
