// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_contact_node_h
#define signorini_contact_contact_node_h

#include <signorini/contact/surface_face.h>
#include <signorini/friction/friction_law.h>

namespace signorini
{
  /** A node of a slave surface that may touch an obstacle or another body. */
  template <int dim>
  struct ContactNode
  {
    unsigned int       node;     ///< owned node
    unsigned int       pair;     ///< index of the pair
    dealii::Point<dim> position; ///< in the reference configuration
    double gap; ///< g: bound on the normal entry of the relative displacement, see `transmission`
    double weight;                       ///< D: area (length in 2d) that belongs to the node
    std::array<double, dim * dim> frame; ///< rows: normal nu out of the body, tangents
    /**
     * The row of P: what moves the opposite side. Weights add up to one; empty at a rigid
     * obstacle.
     */
    NodeWeights partners;
    /**
     * Force on the slave body per nodal force, and relative normal entry per shift of the body: 1,
     * and more where nodes without multiplier take their share (they are among the partners with
     * negative weights). The distance to the other side is gap / transmission.
     */
    double transmission = 1.;
    /** Law of friction in nodal forces; without any() the node slides freely. */
    FrictionLaw friction = {};
    /**
     * Which directions of the frame are measured relative to the other side: the normal if there
     * are partners, and with friction the tangents, too, except prescribed ones.
     */
    std::array<bool, dim> relative{};
    /**
     * Smallest distance to the other side anywhere around the node, negative where the surfaces
     * overlap.
     */
    double clearance = 0.;

    dealii::Tensor<1, dim> normal() const { return direction(0); }

    /** The part of a nodal force along the normal, negative in compression. */
    double normal_part(const Vector &nodal_forces) const
    {
      double part = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        part += frame[c] * nodal_forces.local_element(dim * node + c);
      return part;
    }

    /** A row of the frame. */
    dealii::Tensor<1, dim> direction(const unsigned int row) const
    {
      dealii::Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = frame[dim * row + c];
      return result;
    }
  };
} // namespace signorini

#endif
