// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/field_series.h>
#include <signorini/output/obstacle_surfaces.h>
#include <signorini/output/setup_output.h>
#include <signorini/output/whole_file.h>

#include <algorithm>

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


    bool is_among(const std::vector<types::boundary_id> &ids, const types::boundary_id id)
    {
      return ids.empty() || std::find(ids.begin(), ids.end(), id) != ids.end();
    }


    /** 1 for a slave, 2 for a master, 0 for none of both; a slave comes first. */
    unsigned int side_in_pairs(const std::vector<PairDescription> &pairs,
                               const unsigned int                  body,
                               const types::boundary_id            id)
    {
      unsigned int side = 0;
      for (const PairDescription &pair : pairs)
        if (pair.slave == body && is_among(pair.slave_boundary_ids, id))
          return 1;
        else if (pair.master == body && is_among(pair.master_boundary_ids, id))
          side = 2;
      return side;
    }


    template <int dim>
    bool has_condition(const std::vector<BoundaryCondition<dim>> &conditions,
                       const types::boundary_id                   id)
    {
      return std::any_of(conditions.begin(), conditions.end(), [id](const auto &condition) {
        return condition.boundary_id == id;
      });
    }
  } // namespace


  template <int dim>
  SetupPatches<dim>::SetupPatches(const Discretization<dim>          &discretization,
                                  const std::vector<PairDescription> &pairs)
  {
    for (const auto &cell : discretization.cells())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const unsigned int          index = cell->material_id();
            const BodyDescription<dim> &body  = discretization.mesh().bodies()[index];
            const types::boundary_id    id    = face->boundary_id();
            Patch                       patch;
            patch.n_subdivisions = 1;
            patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
            patch.patch_index    = patches.size();
            patch.data.reinit(n_setup_values, face->n_vertices());
            for (const unsigned int v : face->vertex_indices())
              {
                patch.vertices[v]              = face->vertex(v);
                patch.data(body_index, v)      = index;
                patch.data(boundary_number, v) = id;
                patch.data(contact_side, v)    = side_in_pairs(pairs, index, id);
                patch.data(is_supported, v)    = has_condition(body.dirichlet, id);
                patch.data(is_loaded, v)       = has_condition(body.traction, id);
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
  void write_setup(const std::string                     &directory,
                   const Discretization<dim>             &discretization,
                   const std::vector<PairDescription>    &pairs,
                   const std::vector<NamedObstacle<dim>> &obstacles)
  {
    const MPI_Comm    communicator = discretization.communicator();
    SetupPatches<dim> bodies(discretization, pairs);
    FieldSeries       series(directory, "setup", communicator);
    succeed_together(communicator, [&] { series.write_piece(bodies, 0, 0.); });
    series.name_moment(bodies, 0, 0.);
    const auto boxes = discretization.mesh().bounding_boxes();
    succeed_together(communicator, [&] {
      if (obstacles.empty() || Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      auto       all    = shown_obstacles(obstacles, false);
      const auto moving = shown_obstacles(obstacles, true);
      all.insert(all.end(), moving.begin(), moving.end());
      const ObstacleSurfaces<dim> surfaces(all, surroundings(boxes, all));
      write_whole_file(directory + "/setup_obstacles.vtu",
                       [&](std::ostream &out) { surfaces.write_vtu(out); });
    });
  }


#define INSTANTIATE(dim)                                                                           \
  template class SetupPatches<dim>;                                                                \
  template void write_setup(const std::string &,                                                   \
                            const Discretization<dim> &,                                           \
                            const std::vector<PairDescription> &,                                  \
                            const std::vector<NamedObstacle<dim>> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
