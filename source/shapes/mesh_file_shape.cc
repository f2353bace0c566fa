// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/mesh_file_shape.h>
#include <signorini/shapes/place.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  template <int dim>
  std::vector<dealii::types::boundary_id> MeshFileShape<dim>::boundary_ids() const
  {
    std::vector<dealii::types::boundary_id> ids;
    for (const auto &[id, vertices] : mesh_file.boundary_vertices)
      ids.push_back(id);
    return ids;
  }


  template <int dim>
  std::vector<dealii::Point<dim>>
  MeshFileShape<dim>::boundary_points(const dealii::types::boundary_id id) const
  {
    return mesh_file.boundary_vertices.at(id);
  }


  template <int dim>
  void MeshFileShape<dim>::make_coarse_mesh(const Placement<dim>       &placement,
                                            dealii::Triangulation<dim> &mesh) const
  {
    read_mesh_file(mesh_file.path, mesh, mesh_file.part, mesh_file.scale);
    place(placement, mesh);
  }


  template <int dim>
  std::string MeshFileShape<dim>::too_many_cells() const
  {
    return "File has more than 1000000 cells, which every process must keep. Make a coarser mesh "
           "and use Refinements.";
  }


  void declare_mesh_file_shape(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry(
      "File",
      "",
      Anything(),
      "File: a mesh, absolute or relative to the folder of the scene. Gmsh (.msh, version 2.2 or "
      "4.1; boundary ids: numbers of the physical groups), Abaqus (.inp; boundary ids: numbers in "
      "the names of the surfaces, such as SS3 or Surf-3, or else numbers that are free), UCD "
      "(.inp, "
      ".ucd), VTK (.vtk, legacy up to 4.2), and what meshio converts: VTU (.vtu), Exodus (.e, "
      ".exo), "
      "MED (.med), Nastran (.bdf), Medit (.mesh), XDMF. Faces in no group or surface have boundary "
      "id 0. Names of groups and surfaces can stand wherever boundary ids can. Each triangle is "
      "split into 3 quadrilaterals, each tetrahedron into 4 hexahedra. Second-order cells lose the "
      "nodes in the middle of edges, unless they are split; then these nodes are vertices. At most "
      "a million cells after that, which every process keeps.");
    prm.declare_entry(
      "Part",
      "",
      Anything(),
      "File: name or number of the cells that are this body, or several with commas between: "
      "physical groups of Gmsh, element sets of Abaqus. Empty: all cells of the file.");
    prm.declare_entry(
      "Scale",
      "1",
      Double(),
      "File: all coordinates of the file are multiplied by this number > 0, first of "
      "all: 0.001 for a mesh in millimetres and a scene in metres.");
  }


  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse_mesh_file_shape(const SectionReader &in)
  {
    if (in.text("File").empty())
      in.fail("File", "a body with `Shape = file` needs a mesh. Give the name of a mesh file.");
    const double scale = in.positive_number("Scale", "it changes the unit of length");
    try
      {
        return std::make_shared<MeshFileShape<dim>>(
          describe_mesh_file<dim>(in.path("File"), in.text("Part"), scale));
      }
    catch (const UnknownMeshPart &error)
      {
        in.fail("Part", error.what());
      }
    catch (const UserError &error)
      {
        in.fail("File", error.what());
      }
  }


#define INSTANTIATE(dim)                                                                           \
  template struct MeshFileShape<dim>;                                                              \
  template std::shared_ptr<const BodyShape<dim>> parse_mesh_file_shape<dim>(const SectionReader &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
