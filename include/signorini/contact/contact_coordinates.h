// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_contact_coordinates_h
#define signorini_contact_contact_coordinates_h

#include <signorini/contact/contact_surface.h>
#include <signorini/linear_algebra/masked_preconditioner.h>
#include <signorini/linear_algebra/node_masks.h>

namespace signorini
{
  /**
   * The transformation u = T w between Cartesian components u and contact coordinates w, in which the entries of a contact node
   * are its displacements along the normal and the tangents. T is orthogonal and touches contact nodes only; contact is a
   * bound on the single entry w_{p,nu}.
   */
  template <int dim>
  class ContactCoordinates
  {
  public:
    ContactCoordinates(const Discretization<dim> &discretization,
                       const ContactSurface<dim> &surface,
                       const Supports<dim>       &supports);

    /** w = T'u, in place. */
    void to_contact(Vector &vector) const;

    /** u = T w, in place. */
    void to_cartesian(Vector &vector) const;

    /** The normal entry of each contact node, in the order of the surface. */
    const std::vector<unsigned int> &normal_entries() const { return normals; }

    /** Entries (in contact coordinates) that supports prescribe. */
    const std::vector<unsigned int> &supported_entries() const { return supported; }

    /** The owned nodes of the contact surface. */
    const std::vector<ContactNode<dim>> &surface_nodes() const { return owned_contact_nodes; }

    /** Displacements prescribed at a time, in the order of supported_entries(). */
    std::vector<double> supported_values(double time) const;

    /** Local nodes, ghosts included, that may ever be held: contact nodes and supported ones. Ascending. */
    const std::vector<unsigned int> &special_nodes() const { return special; }

    /** Local nodes, ghosts included, that carry a contact frame. Ascending. */
    const std::vector<unsigned int> &contact_nodes() const { return contact; }

    /** The held directions of special nodes that a mask of owned entries describes. Collective: asks the owners of ghosts. */
    HeldNodes<dim> held_nodes(const Mask &mask) const;

  private:
    using Frame = std::array<double, dim * dim>;

    const Supports<dim>                 &supports;
    const std::vector<ContactNode<dim>> &owned_contact_nodes;
    std::vector<unsigned int>            normals, supported, special, contact;
    std::vector<std::tuple<unsigned int, dealii::Point<dim>, unsigned int>>
                       support_sources; ///< condition, point, component
    std::vector<Frame> special_frames;  ///< in the order of `special`
    mutable Vector     mask_values;
  };
} // namespace signorini

#endif
