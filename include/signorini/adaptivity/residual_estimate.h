// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_residual_estimate_h
#define signorini_adaptivity_residual_estimate_h

#include <signorini/adaptivity/residual_parts.h>

namespace signorini
{
  /**
   * Squared residual estimate per active cell (Krause, Veeser and Walloth, Numer. Math. 130, 2015),
   * cell by cell and face by face instead of node by node, which is the same up to constants of the
   * shape of cells:
   *
   * - interior: w_T |div sigma + rho q|^2,
   * - between cells: w_F |[sigma n]|^2, half of it for each cell,
   * - where no contact is possible: w_F |sigma n - traction|^2 without prescribed components,
   * - at slave surfaces: w_F (|sigma_t - t_t|^2 + sigma_nu^2) + s gap, sigma_nu^2 but for the parts
   *   of full-contact nodes,
   * - at master surfaces: w_F |sigma n - t|^2.
   *
   * A full-contact node is closed with all its neighbours on the slave surface, and there is no
   * tension around it. t are nodal contact forces divided by the areas of their nodes, t_t those of
   * friction, s the pressure at nodes; s gap is zero but where a face has closed and open nodes.
   * Terms that measure by how much a node violates the law of friction are left out: the solver
   * satisfies it at each node.
   *
   * What belongs to the mesh is collected by the constructor; every evaluation computes the stress
   * at each point once.
   */
  template <int dim>
  class ResidualEstimate
  {
  public:
    /** Of the present mesh; the arguments must outlive it. Collective. */
    ResidualEstimate(const Discretization<dim>      &discretization,
                     const ContactSurface<dim>      &surface,
                     const DirichletConditions<dim> &dirichlet);

    /** Collective; hanging nodes of the vectors need not be set. */
    dealii::Vector<double> squares(const ForceBalance    &balance,
                                   const ResidualWeights &weights) const;

  private:
    const ContactSurface<dim>      &surface;
    const DirichletConditions<dim> &dirichlet;
    const CellNeighbors<dim>        mesh;
    const SurfaceRoles<dim>         roles;
  };
} // namespace signorini

#endif
