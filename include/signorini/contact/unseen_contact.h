// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_unseen_contact_h
#define signorini_contact_unseen_contact_h

#include <signorini/contact/contact_surface.h>
#include <signorini/contact/fine_face.h>

namespace signorini
{
  /**
   * Contact that the mesh does not see. Conditions of contact are those of nodes; what is inside of
   * the other side between them goes in freely, until a node comes there, too: the pole of a ball
   * between two nodes, or a small obstacle under the middle of a face. Looked for where no node
   * around bears anything, on the surfaces that finer meshes would have (FineFace): obstacles as
   * they are, the other body as a finer mesh would have it. Bodies that are inside each other with
   * their nodes, and bear nothing there, are found, too.
   */
  template <int dim>
  class UnseenContact
  {
  public:
    /** Of a mesh. Both must outlive the object. Not collective. */
    UnseenContact(const Discretization<dim> &discretization, const ContactSurface<dim> &surface);

    /** What there is of it. */
    struct Finding
    {
      std::vector<bool>   cells;           ///< of this process, by active_cell_index
      std::vector<double> depths;          ///< of each pair, on all processes; length
      std::vector<double> relative_depths; ///< the same over the diameters of the faces
      /** Of pairs of bodies, by which faces are inside with all of their nodes, likewise. */
      std::vector<double> relative_depths_of_nodes;
    };

    /** Collective. @param time where obstacles are */
    Finding find(const Vector &displacement, const Vector &contact_force, double time);

  private:
    /** One side of a pair. */
    struct Side
    {
      unsigned int               pair;
      std::vector<FineFace<dim>> faces; ///< of this process
    };

    /** What a side may touch. */
    struct Opposite
    {
      /** Distance of a point, negative inside; nothing: far away, or not known there. */
      std::function<std::optional<double>(const dealii::Point<dim> &)> gap;
      /** Whether a part of a box may be inside. */
      std::function<bool(const dealii::BoundingBox<dim> &)> may_be_in;
    };

    const Discretization<dim> &discretization;
    const ContactSurface<dim> &surface;
    std::vector<Side>          sides;

    void add_side(unsigned int                                   pair,
                  unsigned int                                   body,
                  const std::vector<dealii::types::boundary_id> &boundary_ids);

    Opposite obstacle(unsigned int pair, double time) const;
    /** The facets of a side that may be near another one. Collective. */
    Opposite other_body(Side &other, const Side &own, const Vector &displacement) const;

    /** The least and the largest gap of the vertices of a face; what sees nothing is far away. */
    static std::pair<double, double> range_of_gaps(const std::vector<dealii::Point<dim>> &vertices,
                                                   const Opposite                        &opposite);

    /** Whether faces of a side reach into what is opposite, where no node bears. Collective. */
    void judge(Side           &side,
               const Opposite &opposite,
               const Vector   &displacement,
               const Vector   &contact_force,
               Finding        &finding) const;

    /** Those of this process that bear what is opposite. */
    std::vector<dealii::Point<dim>> bearing_vertices(const Side     &side,
                                                     const Opposite &opposite,
                                                     const Vector   &displacement,
                                                     const Vector   &contact_force) const;
  };
} // namespace signorini

#endif
