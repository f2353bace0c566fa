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
     * negative weights). The distance to the other side is gap distance_per_gap().
     */
    double transmission = 1.;
    /**
     * At an obstacle the unit normal may be oblique to prescribed directions. The node meets the
     * obstacle in the free ones only: `normal()` is the direction of that part of the unit normal,
     * and this is its length. Positive; 1 unless conditions hold a part of the normal.
     */
    double free_part = 1.;
    /** The other part of the unit normal: these forces pass on to what holds the node. */
    dealii::Tensor<1, dim> prescribed_part = {};
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

    /** The unit normal of the surface, out of the body. */
    dealii::Tensor<1, dim> surface_normal() const { return free_part * normal() + prescribed_part; }

    /** Distance to the other side, along the unit normal, per length of the gap. */
    double distance_per_gap() const { return free_part / transmission; }

    /** The nodal force along the unit normal that these forces are the free part of. */
    double normal_force(const Vector &nodal_forces) const
    {
      double free_force = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        free_force += frame[c] * nodal_forces.local_element(dim * node + c);
      return free_force / free_part;
    }

    /**
     * The force of the other side on the node with what it hands on to prescribed directions, in
     * units of these forces: times `transmission` that on the body.
     */
    dealii::Tensor<1, dim> force(const Vector &nodal_forces) const
    {
      dealii::Tensor<1, dim> result = normal_force(nodal_forces) * prescribed_part;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] += nodal_forces.local_element(dim * node + c);
      return result;
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
