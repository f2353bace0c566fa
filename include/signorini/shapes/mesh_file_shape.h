// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_mesh_file_shape_h
#define signorini_shapes_mesh_file_shape_h

#include <signorini/mesh_files/mesh_file.h>
#include <signorini/model/body_shape.h>
#include <signorini/prm/section_reader.h>

#include <memory>

namespace signorini
{
  /** A mesh from a file. Boundary ids and names are those of the file. */
  template <int dim>
  struct MeshFileShape : public BodyShape<dim>
  {
    MeshFile<dim> mesh_file;

    explicit MeshFileShape(const MeshFile<dim> &mesh_file)
      : mesh_file(mesh_file)
    {
    }

    dealii::Point<dim>                      midpoint() const override { return mesh_file.centre; }
    std::vector<dealii::types::boundary_id> boundary_ids() const override;
    std::vector<dealii::Point<dim>> boundary_points(dealii::types::boundary_id id) const override;
    BoundaryNames                   boundary_names() const override { return mesh_file.boundaries; }

    void make_coarse_mesh(const Placement<dim>       &placement,
                          dealii::Triangulation<dim> &mesh) const override;

    std::string              too_many_cells() const override;
    std::string              file() const override { return mesh_file.path; }
    std::vector<std::string> notes() const override { return mesh_file.notes; }
  };

  // `Shape = file`: path, part, scale.
  void declare_mesh_file_shape(dealii::ParameterHandler &prm);
  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse_mesh_file_shape(const SectionReader &in);
} // namespace signorini

#endif
