// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_surface_roles_h
#define signorini_adaptivity_surface_roles_h

#include <signorini/contact/contact_surface.h>
#include <signorini/finite_elements/cell_neighbors.h>

#include <deal.II/base/function_parser.h>

namespace signorini
{
  /** What the scene says about a part of the boundary of a body. */
  template <int dim>
  struct SurfaceCondition
  {
    std::array<bool, dim>        held{};
    dealii::FunctionParser<dim> *traction = nullptr; ///< null for none
  };

  template <int dim>
  struct SurfaceRole
  {
    bool                         is_slave, is_master;
    const SurfaceCondition<dim> *condition; ///< null for none
  };

  /** The role of each outer face: contact, Dirichlet conditions, loads. */
  template <int dim>
  class SurfaceRoles
  {
  public:
    SurfaceRoles(const CellNeighbors<dim> &mesh, const ContactSurface<dim> &surface);

    const SurfaceRole<dim> &operator[](const std::size_t outer_face) const
    {
      return roles[outer_face];
    }

  private:
    std::vector<std::map<dealii::types::boundary_id, SurfaceCondition<dim>>>
                                  conditions; ///< by body
    std::vector<SurfaceRole<dim>> roles;
  };
} // namespace signorini

#endif
