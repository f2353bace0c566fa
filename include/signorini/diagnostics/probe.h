// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_probe_h
#define signorini_diagnostics_probe_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** What a probe sees of the relative motion; the normal points out of the slave body. */
  struct ProbeReading
  {
    double gap                 = 0.;
    double normal_displacement = 0.;
    double normal_velocity     = 0.;
    double pressure            = 0.; ///< positive in compression
    double normal_force        = 0.; ///< nodal force, positive in compression

    std::array<double, 3> tangential_force{}; ///< nodal force on the slave
    std::array<double, 3> slip{};             ///< since the start, relative to the other side
    double                slip_path = 0.;     ///< length of the way since the start
    double                status    = 0.; ///< of the node, see contact_status; 0 without friction
  };

  /**
   * The contact node that is closest to a point of the reference configuration, on whichever
   * process it lives.
   */
  template <int dim>
  class Probe
  {
  public:
    Probe(const ProbeDescription<dim> &description,
          const ContactSurface<dim>   &surface,
          MPI_Comm                     communicator);

    const std::string        &name() const { return probe_name; }
    const dealii::Point<dim> &position() const { return node_position; }
    /** Index of the pair that its node belongs to. */
    unsigned int pair() const { return node_pair; }

    /** The reading, on all processes. */
    ProbeReading read(const State &state) const;

  private:
    std::string                probe_name;
    MPI_Comm                   communicator;
    const ContactSurface<dim> *surface;
    unsigned int               node = 0; ///< index into the nodes of the surface, on the owner
    dealii::Point<dim>         node_position;
    unsigned int               node_pair = 0;
    unsigned int               owner     = 0;

    /** Along the normal of the node, on its owner: the mean of the last step. */
    double normal_velocity_of_obstacle(const State &state) const;
  };
} // namespace signorini

#endif
