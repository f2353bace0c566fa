// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_mesh_file_h
#define signorini_mesh_files_mesh_file_h

#include <signorini/model/body_description.h>

#include <deal.II/grid/tria.h>

#include <string>

namespace signorini
{
  /**
   * Read a mesh of quadrilaterals (2d) or hexahedra (3d) with its boundary ids: Gmsh (.msh), Abaqus
   * (.inp), UCD (.inp, .ucd) or VTK (.vtk). Vertices that no cell uses are left out.
   * @throws UserError that begins with the path, if there is no mesh in the file on which
   * elasticity can be computed.
   */
  template <int dim>
  void read_mesh_file(const std::string &path, dealii::Triangulation<dim> &mesh);

  /**
   * What the description of a body keeps of the mesh in a file. @throws UserError like
   * read_mesh_file().
   */
  template <int dim>
  MeshFile<dim> describe_mesh_file(const std::string &path);
} // namespace signorini

#endif
