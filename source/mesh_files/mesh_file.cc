// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/mesh_files/mesh_file.h>
#include <signorini/mesh_files/mesh_text.h>

#include <deal.II/base/bounding_box.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/reference_cell.h>

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

    /** Let deal.II read the text. @return why it could not; empty if it could. */
    template <int dim, int spacedim>
    std::string try_to_read(const MeshText &mesh_text, Triangulation<dim, spacedim> &mesh)
    {
      dealii::GridIn<dim, spacedim> reader;
      reader.attach_triangulation(mesh);
      std::istringstream in(mesh_text.text);
      try
        {
          reader.read(
            in, static_cast<typename dealii::GridIn<dim, spacedim>::Format>(mesh_text.format));
          return mesh.n_active_cells() > 0 ? "" : "it has no cells of this dimension";
        }
      catch (const dealii::ExceptionBase &exception)
        {
          mesh.clear();
          return reason(exception);
        }
      catch (const std::exception &exception)
        {
          mesh.clear();
          return exception.what();
        }
    }

    template <int dim>
    std::string cell_name()
    {
      return dim == 2 ? "quadrilaterals" : "hexahedra";
    }

    [[noreturn]] void refuse_dimension(const unsigned int dim)
    {
      throw MeshFileError("it is a mesh in " + std::to_string(5 - dim)
                          + "d, but the scene has `Dimension = " + std::to_string(dim)
                          + "`. Use a mesh of " + std::to_string(dim)
                          + "d cells, or change the dimension.");
    }

    template <int dim, int spacedim>
    [[noreturn]] void
    refuse_cell(const dealii::TriaIterator<dealii::CellAccessor<dim, spacedim>> &cell,
                const unsigned int                                               vertex)
    {
      std::ostringstream message;
      message << "cell " << cell->index() + 1 << " (counted from 1 among the " << cell_name<dim>()
              << ") is inverted or degenerate at its vertex (" << cell->vertex(vertex)
              << "). Correct the mesh there: no corner may be turned inside out or have no volume.";
      throw MeshFileError(message.str());
    }

    /**
     * Elasticity needs a mapping that is invertible at every vertex; otherwise there is no
     * stiffness matrix.
     */
    template <int dim>
    void check_jacobians(const Triangulation<dim> &mesh)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          {
            // The edges that meet in the vertex, as columns: derivatives of the mapping there.
            dealii::Tensor<2, dim> jacobian;
            double                 lengths = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const unsigned int bit  = 1u << d;
                const auto         edge = cell->vertex(v | bit) - cell->vertex(v & ~bit);
                lengths *= edge.norm();
                for (unsigned int c = 0; c < dim; ++c)
                  jacobian[c][d] = edge[c];
              }
            if (!(determinant(jacobian) > 1e-10 * lengths))
              refuse_cell<dim, dim>(cell, v);
          }
    }

    /**
     * deal.II's readers refuse plane meshes in which some cells run clockwise, without telling
     * which. Read as a surface in space, such a mesh is accepted. A cell of the minority is at
     * fault.
     */
    void refuse_inverted_quadrilateral(const MeshText &mesh_text)
    {
      Triangulation<2, 3> surface;
      if (!try_to_read(mesh_text, surface).empty() || !surface.all_reference_cells_are_hyper_cube())
        return;
      const auto is_clockwise = [](const auto &cell) {
        return cross_product_3d(cell->vertex(3) - cell->vertex(0),
                                cell->vertex(2) - cell->vertex(1))[2]
               < 0.;
      };
      unsigned int n_clockwise = 0;
      for (const auto &cell : surface.active_cell_iterators())
        n_clockwise += is_clockwise(cell);
      const bool most_are_clockwise = 2 * n_clockwise > surface.n_active_cells();
      for (const auto &cell : surface.active_cell_iterators())
        if (is_clockwise(cell) != most_are_clockwise)
          refuse_cell<2, 3>(cell, 0);
    }

    template <int dim>
    void refuse_inverted_cell(const MeshText &mesh_text)
    {
      if (dim == 2)
        refuse_inverted_quadrilateral(mesh_text);
      const std::string cell = dim == 3 && mesh_text.format == dealii::GridIn<3>::ucd
                                 ? find_inverted_hexahedron(mesh_text.text)
                                 : "";
      if (!cell.empty())
        throw MeshFileError(cell
                            + " is inverted: it lists its vertices in the other direction of "
                              "rotation than most cells. Correct the order of its vertices.");
    }

    template <int dim>
    void read(const std::string &path, Triangulation<dim> &mesh)
    {
      const MeshText    mesh_text = read_mesh_text(path);
      const std::string complaint = try_to_read(mesh_text, mesh);
      if (!complaint.empty())
        {
          Triangulation<5 - dim> other;
          if (try_to_read(mesh_text, other).empty())
            refuse_dimension(dim);
          refuse_inverted_cell<dim>(mesh_text);
          throw MeshFileError("the mesh cannot be read: " + complaint
                              + ". Write it again, as a mesh of " + cell_name<dim>()
                              + " with straight edges, with groups of faces on its boundary only.");
        }
      if (!mesh.all_reference_cells_are_hyper_cube())
        throw MeshFileError(std::string("it has ")
                            + (dim == 2 ? "triangles" : "tetrahedra or other cells with triangles")
                            + ". Only " + cell_name<dim>() + " can be used. "
                            + MeshFileError::subdivide);
      check_jacobians(mesh);
    }
  } // namespace

  template <int dim>
  void read_mesh_file(const std::string &path, Triangulation<dim> &mesh)
  {
    try
      {
        read(path, mesh);
      }
    catch (const MeshFileError &error)
      {
        throw UserError(path + ": " + error.what());
      }
  }

  template <int dim>
  MeshFile<dim> describe_mesh_file(const std::string &path)
  {
    Triangulation<dim> mesh;
    read_mesh_file(path, mesh);
    MeshFile<dim> result;
    result.path   = path;
    result.centre = dealii::BoundingBox<dim>(mesh.get_vertices()).center();
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
  }

#define INSTANTIATE(dim)                                                                           \
  template void          read_mesh_file(const std::string &, dealii::Triangulation<dim> &);        \
  template MeshFile<dim> describe_mesh_file(const std::string &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
