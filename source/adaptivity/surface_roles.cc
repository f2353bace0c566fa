// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/surface_roles.h>
#include <signorini/surfaces/surface_face.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::map<types::boundary_id, SurfaceCondition<dim>>
    conditions_of(const Mesh<dim> &mesh, const BodyDescription<dim> &body)
    {
      std::map<types::boundary_id, SurfaceCondition<dim>> result;
      for (const auto &dirichlet : body.dirichlet)
        for (unsigned int c = 0; c < dim; ++c)
          if (!dirichlet.expressions[c].empty() && dirichlet.expressions[c] != "-")
            result[dirichlet.boundary_id].held[c] = true;
      for (const auto &traction : body.traction)
        result[traction.boundary_id].traction = &mesh.function(traction.expressions);
      return result;
    }

    /** Whether a face of an owned cell is part of the master surface of any pair. */
    template <int dim>
    bool is_master_face(const std::vector<PairDescription>                   &pairs,
                        const typename DoFHandler<dim>::active_cell_iterator &cell,
                        const unsigned int                                    face)
    {
      return std::any_of(pairs.begin(), pairs.end(), [&](const PairDescription &pair) {
        return pair.of_two_bodies()
               && is_surface_face<dim>(cell, face, pair.master, pair.master_boundary_ids);
      });
    }
  } // namespace


  template <int dim>
  SurfaceRoles<dim>::SurfaceRoles(const CellNeighbors<dim>  &mesh,
                                  const ContactSurface<dim> &surface)
  {
    for (const auto &body : mesh.discretization.mesh().bodies())
      conditions.push_back(conditions_of(mesh.discretization.mesh(), body));
    for (const OuterFace<dim> &outer : mesh.outer_faces)
      {
        const LocalCell<dim> &local   = mesh.cells[outer.cell];
        const auto           &of_body = conditions[local.body];
        const auto            found   = of_body.find(local.cell->face(outer.face)->boundary_id());
        roles.push_back({surface.contains(local.cell, outer.face),
                         is_master_face<dim>(surface.pairs(), local.cell, outer.face),
                         found == of_body.end() ? nullptr : &found->second});
      }
  }


  template class SurfaceRoles<2>;
  template class SurfaceRoles<3>;
} // namespace signorini
