// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_supports_h
#define signorini_diagnostics_supports_h

#include <signorini/contact/contact_surface.h>

namespace signorini
{
  /**
   * What the parts of the boundaries whose displacement is prescribed do to the bodies. A component
   * of a node that two of them prescribe counts for the one that the scene names first.
   */
  template <int dim>
  class Supports
  {
  public:
    using Forces = std::vector<std::array<double, 3>>; ///< by condition

    /** All arguments must outlive the object. */
    Supports(const DirichletConditions<dim> &dirichlet, const ContactSurface<dim> &surface);

    /** Sums of nodal forces over the entries that each condition prescribes. Collective. */
    Forces sums(const Vector &nodal_forces) const;

    /**
     * What contact hands on to each condition: where an obstacle is oblique to prescribed
     * directions, these take a part of its force, which is no entry of the vector. Collective.
     */
    Forces handed_on(const Vector &contact_force) const;

  private:
    struct Entry
    {
      unsigned int index, condition, component;
    };

    const DirichletConditions<dim> &dirichlet;
    const ContactSurface<dim>      &surface;
    std::vector<Entry>              entries; ///< prescribed ones of vectors
    std::vector<Entry>              oblique; ///< their indices are those of contact nodes

    Forces over_all_processes(Forces &&forces) const;
  };
} // namespace signorini

#endif
