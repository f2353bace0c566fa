// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_body_force_h
#define signorini_finite_elements_body_force_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /** The force per mass that the scene prescribes, interpolated at the nodes of one mesh. Evaluated again only if it depends on time. */
  template <int dim>
  class BodyForce
  {
  public:
    explicit BodyForce(const Discretization<dim> &discretization);

    /** At a time. The two latest times are kept: the end of a step is the start of the next. */
    const Vector &at(double time);

  private:
    const Discretization<dim>                &discretization;
    std::vector<std::array<std::string, dim>> expressions; ///< by body
    bool                                      any = false, depends_on_time = false;
    std::array<std::pair<double, Vector>, 2>  kept;
    unsigned int                              latest = 0;
  };
} // namespace signorini

#endif
