// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_contact_node_h
#define signorini_contact_contact_node_h

#include <signorini/friction/friction_law.h>
#include <signorini/surfaces/surface_face.h>

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
    /**
     * The row of the frame that is the normal of this contact, and the entry of the node that it
     * bounds. Beyond 0 where a node may meet several obstacles at once, one contact node for each.
     */
    unsigned int row = 0;
    /**
     * How many obstacles bound the node now. The normals of several ones are the first rows of its
     * frame, which is oblique then, and forces have the components that its dual frame tells. The
     * other rows are tangents, without a bound.
     */
    unsigned int                 n_bounds = 1;
    std::array<double, dim *dim> dual     = {}; ///< the inverse transposed, of an oblique frame

    unsigned int entry() const { return dim * node + row; }
    bool         is_bounded() const { return row < n_bounds; }
    bool         is_shared() const { return n_bounds > 1; }

    dealii::Tensor<1, dim> normal() const { return direction(row); }

    /** Rows by which forces have components: those of the frame where it is orthonormal. */
    const std::array<double, dim * dim> &dual_frame() const { return is_shared() ? dual : frame; }

    /** The unit normal of the surface, out of the body. */
    dealii::Tensor<1, dim> surface_normal() const { return free_part * normal() + prescribed_part; }

    /** Distance to the other side, along the unit normal, per length of the gap. */
    double distance_per_gap() const { return free_part / transmission; }

    /** The nodal force along the unit normal that these forces are the free part of. */
    double normal_force(const Vector &nodal_forces) const
    {
      return is_bounded() ? component(row, nodal_forces) / free_part : 0.;
    }

    /**
     * The force of the other side on the node with what it hands on to prescribed directions, in
     * units of these forces: times `transmission` that on the body.
     */
    dealii::Tensor<1, dim> force(const Vector &nodal_forces) const
    {
      if (row > 0)
        return normal_force(nodal_forces) * normal();
      dealii::Tensor<1, dim> result = normal_force(nodal_forces) * prescribed_part;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] += nodal_forces.local_element(dim * node + c);
      for (unsigned int other = 1; other < n_bounds; ++other)
        result -= component(other, nodal_forces) * direction(other);
      return result;
    }

    /** Of a force, along a row of the frame. */
    double component(const unsigned int of_row, const Vector &nodal_forces) const
    {
      double result = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        result += dual_frame()[dim * of_row + c] * nodal_forces.local_element(dim * node + c);
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
