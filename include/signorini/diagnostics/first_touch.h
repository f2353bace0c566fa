// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_first_touch_h
#define signorini_diagnostics_first_touch_h

#include <signorini/contact/contact_surface.h>

#include <array>
#include <limits>

namespace signorini
{
  /** How the surfaces of a pair are going to meet if nothing changes their velocities until then.
   */
  struct FirstTouch
  {
    double time  = std::numeric_limits<double>::infinity(); ///< from now; infinite: not at all
    double speed = 0.;                                      ///< of approach
    std::array<double, 3> normal{};                         ///< of the first node, out of its body
    /**
     * 1/R of the paraboloid that the distance around the place is; zero for flat faces, which meet
     * with an area. Nothing is known about edges and corners, which are neither.
     */
    double       curvature    = 0.;
    bool         is_smooth    = false; ///< a paraboloid or flat
    double       node_spacing = 0.;    ///< mean distance of nodes at that place
    unsigned int n_at_once    = 0;     ///< nodes that meet together with the first one
    double       area         = 0.;    ///< of these nodes
    /** The first node in the reference configuration, and its way along the normal. */
    std::array<double, 3> position{};
    double                distance = 0.;
  };

  /**
   * Where each pair is going to touch first, from the distances and velocities of its nodes.
   * Collective. @return in the order of pairs
   */
  template <int dim>
  std::vector<FirstTouch> first_touches(const ContactSurface<dim> &surface,
                                        const Vector              &displacement,
                                        const Vector              &velocity,
                                        MPI_Comm                   communicator);
} // namespace signorini

#endif
