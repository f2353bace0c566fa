// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_loads_h
#define signorini_discretization_loads_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /** Nodal forces f(t) of body forces and tractions. Loads that do not depend on time are assembled once. */
  template <int dim>
  class Loads
  {
  public:
    explicit Loads(const Discretization<dim> &discretization);

    /** False if no body has any load: then there is nothing to add and no energy of loads. */
    bool any() const { return has_loads; }

    /** f at a time. The two latest times are kept, so that consecutive steps evaluate each time once. */
    const Vector &at(double time);

  private:
    const Discretization<dim>               &discretization;
    bool                                     has_loads = false, depends_on_time = false;
    std::array<std::pair<double, Vector>, 2> kept;
    unsigned int                             latest = 0;

    Vector assemble(double time) const;
  };
} // namespace signorini

#endif
