// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_mark_cells_h
#define signorini_adaptivity_mark_cells_h

#include <signorini/contact/contact_surface.h>
#include <signorini/model/adaptivity_parameters.h>

namespace signorini
{
  /** What marking has decided, the same on all processes. */
  struct MeshChange
  {
    double       estimate     = 0.;    ///< root of the sum of squared indicators
    unsigned int n_to_refine  = 0;     ///< cells with a refine flag, on all processes
    unsigned int n_to_coarsen = 0;     ///< cells with a coarsen flag, on all processes
    double       error_part   = 0.;    ///< of the squared estimate, in cells that it wants refined
    double       spared_part  = 0.;    ///< of the cells, by coarsening
    bool         is_urgent    = false; ///< refinement, as contact is about to meet coarse cells

    bool refines() const { return n_to_refine > 0; }
    bool coarsens() const { return n_to_coarsen > 0; }
    bool any() const { return refines() || coarsens(); }
  };

  /**
   * Set refine and coarsen flags of the cells of this process, ready for Mesh::carry_out_flags(),
   * as the section `Adaptivity` of the scene says; earlier flags are cleared. Without flags the
   * mesh is good enough and should be kept. Collective.
   *
   * Kept as they are: cells at the limits of levels, and protected cells are not coarsened. A
   * family is coarsened only if the cell that replaces it would, by the order of the method, be
   * well below the threshold of refinement. Refinement that concerns less than the part
   * `Hysteresis` of the squared estimate is left out, and so is coarsening of less than this part
   * of the cells, alone or for the goal `contact force`.
   *
   * @param indicator       eta_T by active_cell_index
   * @param not_to_coarsen  protected cells by active_cell_index; empty: none
   * @param to_refine       cells that are refined whatever their indicator is, within the limits;
   *                        empty: none
   */
  template <int dim>
  MeshChange mark_cells(Mesh<dim>                    &mesh,
                        const AdaptivityParameters   &parameters,
                        const dealii::Vector<double> &indicator,
                        const std::vector<bool>      &not_to_coarsen = {},
                        const std::vector<bool>      &to_refine      = {});

  /** How many cells may be refined before `Maximum cells` are reached, on all processes. */
  template <int dim>
  double room_to_refine(const Mesh<dim> &mesh, const AdaptivityParameters &parameters);

  /** No cell of this process is to be changed. */
  template <int dim>
  void clear_flags(Mesh<dim> &mesh);

  /**
   * The cells of this process with a closed contact node, or with a node that one presses on.
   * Collective.
   */
  template <int dim>
  std::vector<bool> cells_in_contact(const Discretization<dim> &discretization,
                                     const ContactSurface<dim> &surface,
                                     const Vector              &contact_force);
} // namespace signorini

#endif
