// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_mesh_file_h
#define signorini_mesh_files_mesh_file_h

#include <signorini/base/user_error.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <vector>

namespace signorini
{
  /** About the part of a mesh file that was asked for. */
  class UnknownMeshPart : public UserError
  {
  public:
    using UserError::UserError;
  };

  /**
   * What a scene needs to know of a mesh from a file: where it comes from, and the vertices on
   * each of its boundaries, as they stand in the file, times the scale.
   */
  template <int dim>
  struct MeshFile
  {
    std::string        path;       ///< absolute, or relative to the current folder
    std::string        part;       ///< names or numbers of groups of cells; empty: all cells
    double             scale = 1.; ///< of all coordinates
    dealii::Point<dim> centre;     ///< of the smallest box that holds all vertices
    std::map<dealii::types::boundary_id, std::vector<dealii::Point<dim>>> boundary_vertices;
    /** Boundary ids of the groups of faces, by their names and numbers. */
    std::map<std::string, std::vector<dealii::types::boundary_id>> boundaries;
    std::vector<std::string>                                       notes; ///< clauses
  };

  /**
   * Read a mesh of quadrilaterals (2d) or hexahedra (3d) with its boundary ids: Gmsh (.msh), Abaqus
   * (.inp), UCD (.inp, .ucd), VTK (.vtk), or what meshio reads. Meshes with other cells are split:
   * a triangle into 3 quadrilaterals, a tetrahedron into 4 hexahedra. Vertices that no cell uses
   * are left out.
   * @param part names or numbers of groups of cells, separated by commas; empty: all cells
   * @param scale multiplies all coordinates
   * @throws UserError that begins with the path, if there is no mesh in the file on which
   * elasticity can be computed; UnknownMeshPart.
   */
  template <int dim>
  void read_mesh_file(const std::string          &path,
                      dealii::Triangulation<dim> &mesh,
                      const std::string          &part  = "",
                      double                      scale = 1.);

  /**
   * What the shape of a body keeps of the mesh in a file. @throws UserError like
   * read_mesh_file(), and if cells overlap.
   */
  template <int dim>
  MeshFile<dim>
  describe_mesh_file(const std::string &path, const std::string &part = "", double scale = 1.);
} // namespace signorini

#endif
