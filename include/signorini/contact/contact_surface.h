// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_contact_surface_h
#define signorini_contact_contact_surface_h

#include <signorini/contact/rigid_obstacle.h>
#include <signorini/discretization/discretization.h>
#include <signorini/discretization/supports.h>

namespace signorini
{
  /** A node of a slave surface that may touch an obstacle. */
  template <int dim>
  struct ContactNode
  {
    unsigned int                  node;     ///< owned node
    unsigned int                  pair;     ///< index into Scene::pairs
    dealii::Point<dim>            position; ///< in the reference configuration
    double                        gap;      ///< g: initial distance along the normal
    double                        weight;   ///< D: area (length in 2d) that belongs to the node
    std::array<double, dim * dim> frame;    ///< rows: normal nu, tangents

    dealii::Tensor<1, dim> normal() const
    {
      dealii::Tensor<1, dim> nu;
      for (unsigned int c = 0; c < dim; ++c)
        nu[c] = frame[c];
      return nu;
    }
  };

  /**
   * The possible contact boundary: unconstrained nodes of the slave surfaces with gap, weight and contact coordinates (normal
   * and tangents). The linearised condition of non-penetration is u.nu <= g at each (Krause and Walloth 2012, equation (3)).
   *
   * A node belongs to the closest obstacle among the pairs of its body, and only if its surface faces that obstacle. A
   * node whose normal displacement is prescribed by a support is left out.
   */
  template <int dim>
  class ContactSurface
  {
  public:
    ContactSurface(const Discretization<dim> &discretization, const Supports<dim> &supports);

    /** Nodes that this process owns. */
    const std::vector<ContactNode<dim>> &nodes() const { return contact_nodes; }

    /** Number of contact nodes on all processes. */
    unsigned int n_global_nodes() const { return n_global; }

    /** Number of nodes (all processes) where a support took the place of contact. */
    unsigned int n_supported() const { return n_left_to_supports; }

    /** Whether a face of an owned cell is part of the slave surface of any pair. */
    bool contains(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell, unsigned int face) const;

    /** gamma = g - u.nu. */
    std::vector<double> normal_gap(const Vector &displacement) const;

    /**
     * Largest depth of a displaced contact node in *any* obstacle of its body, by the true geometry, on all processes; 0 if there is none.
     * The condition of the steps is linearised about the reference configuration, with one obstacle per node; this is what it misses.
     */
    double geometric_penetration(const Vector &displacement) const;

    /**
     * Check that no slave surface penetrates its obstacle at the start.
     * @throws UserError naming pair, depth and place
     */
    void check_initial_gap(const Vector &initial_displacement) const;

  private:
    const Discretization<dim>                       &discretization;
    std::vector<ContactNode<dim>>                    contact_nodes;
    std::vector<std::unique_ptr<RigidObstacle<dim>>> obstacles;
    unsigned int                                     n_global = 0, n_left_to_supports = 0;

    /** Area and averaged outward normal (times area) per node for one pair; `normal` has dim, `area` one entry per node. */
    void integrate(const PairDescription &pair, Vector &area, Vector &normal) const;
    /** Whether a boundary face belongs to the slave surface of a pair. */
    bool on_surface(const PairDescription                                        &pair,
                    const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                    unsigned int                                                  face) const;
  };
} // namespace signorini

#endif
