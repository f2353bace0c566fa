// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/field_series.h>
#include <signorini/output/obstacle_surfaces.h>
#include <signorini/output/whole_file.h>
#include <signorini/setup/setup_face.h>
#include <signorini/setup/setup_output.h>
#include <signorini/setup/setup_picture.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    enum SetupValue : unsigned int
    {
      body_index,
      boundary_number,
      contact_side,
      is_supported,
      is_loaded,
      n_setup_values
    };
  } // namespace


  template <int dim>
  SetupPatches<dim>::SetupPatches(const Discretization<dim>          &discretization,
                                  const std::vector<PairDescription> &pairs)
  {
    for (const auto &cell : discretization.cells())
      for (const auto &face : cell->face_iterators())
        if (cell->is_locally_owned() && face->at_boundary())
          {
            const SetupFace shown = setup_face(
              discretization.mesh().bodies(), pairs, cell->material_id(), face->boundary_id());
            Patch patch;
            patch.n_subdivisions = 1;
            patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
            patch.patch_index    = patches.size();
            patch.data.reinit(n_setup_values, face->n_vertices());
            for (const unsigned int v : face->vertex_indices())
              {
                patch.vertices[v]              = face->vertex(v);
                patch.data(body_index, v)      = shown.body;
                patch.data(boundary_number, v) = shown.boundary_id;
                patch.data(contact_side, v)    = shown.contact_side;
                patch.data(is_supported, v)    = shown.is_supported;
                patch.data(is_loaded, v)       = shown.is_loaded;
              }
            patches.push_back(patch);
          }
  }


  template <int dim>
  std::vector<std::string> SetupPatches<dim>::get_dataset_names() const
  {
    return {"body", "boundary_id", "contact", "support", "traction"};
  }


  template <int dim>
  bool write_setup(const std::string                     &directory,
                   const Discretization<dim>             &discretization,
                   const std::vector<PairDescription>    &pairs,
                   const std::vector<NamedObstacle<dim>> &obstacles)
  {
    const MPI_Comm    communicator = discretization.communicator();
    SetupPatches<dim> bodies(discretization, pairs);
    FieldSeries       series(directory, "setup", communicator);
    succeed_together(communicator, [&] { series.write_piece(bodies, 0, 0.); });
    series.name_moment(bodies, 0, 0.);

    const SetupPicture<dim> picture(discretization, pairs);
    const auto              boxes = discretization.mesh().bounding_boxes();
    succeed_together(communicator, [&] {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      auto       all    = shown_obstacles(obstacles, false);
      const auto moving = shown_obstacles(obstacles, true);
      all.insert(all.end(), moving.begin(), moving.end());
      const BoundingBox<dim>      view = surroundings(boxes, all);
      const ObstacleSurfaces<dim> surfaces(all, view);
      if (!obstacles.empty())
        write_whole_file(directory + "/setup_obstacles.vtu",
                         [&](std::ostream &out) { surfaces.write_vtu(out); });
      std::vector<std::string> names;
      for (const auto &obstacle : obstacles)
        names.push_back(obstacle.name);
      if (picture.exists())
        write_whole_file(directory + "/setup.svg", [&](std::ostream &out) {
          out << picture.draw(view, obstacles.empty() ? nullptr : &surfaces, names);
        });
    });
    return picture.exists();
  }


#define INSTANTIATE(dim)                                                                           \
  template class SetupPatches<dim>;                                                                \
  template bool write_setup(const std::string &,                                                   \
                            const Discretization<dim> &,                                           \
                            const std::vector<PairDescription> &,                                  \
                            const std::vector<NamedObstacle<dim>> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
