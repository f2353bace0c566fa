// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_pair_contact_h
#define signorini_diagnostics_pair_contact_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** The contact of one pair at one instant. Forces act on the slave, the master feels opposite
   * ones. */
  struct PairContact
  {
    std::array<double, 3> force{}; ///< resultant, with friction
    /**
     * About the origin, at the positions of the reference configuration; where contact follows the
     * motion, at those of now.
     */
    std::array<double, 3> moment{};
    double                normal_force    = 0.; ///< sum of |normal nodal forces|
    double                friction_force  = 0.; ///< sum of |tangential nodal forces|
    unsigned int          n_active        = 0;  ///< nodes that carry a force
    double                smallest_gap    = 0.; ///< least distance, negative where nodes penetrate
    double                max_penetration = 0.; ///< its negative part
    double                depth           = 0.; ///< see ContactSurface::depth()
  };

  /** Reads the contact of each pair from states on one mesh. */
  template <int dim>
  class PairReader
  {
  public:
    /** The arguments must outlive the reader. Collective. */
    PairReader(const Discretization<dim> &discretization, const ContactSurface<dim> &surface);

    /**
     * In the order of `Contact/Pairs`. The gap of a pair without contact nodes is 0. Collective.
     */
    std::vector<PairContact> read(const State &state) const;

  private:
    const Discretization<dim>          &discretization;
    const ContactSurface<dim>          &surface;
    std::vector<unsigned int>           bodies; ///< of the owned nodes
    std::vector<dealii::Tensor<1, dim>> levers; ///< in the reference configuration

    /**
     * Per contact node the position at which its force acts on the slave, times its transmission:
     * nodes without multiplier take their share of the force. Collective.
     * @param displacement null: none
     */
    std::vector<dealii::Tensor<1, dim>> levers_at(const Vector *displacement) const;
  };
} // namespace signorini

#endif
