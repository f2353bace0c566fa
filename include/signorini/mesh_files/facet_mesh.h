// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_facet_mesh_h
#define signorini_mesh_files_facet_mesh_h

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace signorini
{
  /** A surface of triangles (2d: a line of segments), as a file has it. */
  template <int dim>
  struct FacetMesh
  {
    /** Vertices of a facet, seen from outside counterclockwise; in 2d the inside is to the left. */
    using Facet = std::array<unsigned int, dim>;

    std::vector<dealii::Point<dim>> vertices;
    std::vector<Facet>              facets;
  };

  /**
   * Read a surface: STL (3d, text or binary), OBJ, VTK (legacy, text) of triangles and polygons
   * (2d: of lines), or the boundary of a mesh that read_mesh_file() reads. Polygons are cut into
   * triangles from their first vertex. Vertices may be repeated.
   * @throws UserError that begins with the path, if there is no surface in the file
   */
  template <int dim>
  FacetMesh<dim> read_facet_mesh(const std::string &path);

  /** The content of an STL file. @throws MeshFileError */
  FacetMesh<3> facets_of_stl(const std::string &content);

  /** The faces (2d: lines) of an OBJ file. @throws MeshFileError */
  template <int dim>
  FacetMesh<dim> facets_of_obj(const std::string &text);

  /**
   * The triangles, quadrilaterals and polygons (2d: lines) of a legacy VTK file; no facets if there
   * are none. @throws MeshFileError for a broken file
   */
  template <int dim>
  FacetMesh<dim> facets_of_vtk(const std::string &text);

  /**
   * Add a polygon as triangles (2d: a line as segments).
   * @throws MeshFileError if a vertex does not exist
   */
  template <int dim>
  void add_polygon(FacetMesh<dim> &mesh, const std::vector<long> &vertices);

  /** A point of a file, which always has three coordinates. @throws MeshFileError out of the plane
   */
  template <int dim>
  dealii::Point<dim> point_of_file(const std::array<double, 3> &coordinates);
} // namespace signorini

#endif
