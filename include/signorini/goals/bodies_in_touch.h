// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_bodies_in_touch_h
#define signorini_goals_bodies_in_touch_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * For each body, whether what happens in it now can be felt by a contact force: it touches
   * something, or will do so before a pressure wave has run through it and back, at the present
   * velocity. Collective; the same on all processes. @param soon a time that is also looked ahead
   */
  template <int dim>
  std::vector<bool> bodies_in_touch(const Discretization<dim> &discretization,
                                    const ContactSurface<dim> &surface,
                                    const State               &state,
                                    double                     soon = 0.);
} // namespace signorini

#endif
