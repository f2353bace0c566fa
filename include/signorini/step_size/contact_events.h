// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_contact_events_h
#define signorini_step_size_contact_events_h

#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * What the contact nodes of this process do in a state: open, or pressed; with friction slipping
   * or sticking.
   */
  ActiveSet contact_statuses(const DynamicalSystem &system, const State &state);

  /** Whether a contact node is pressed, on any process. @param like tells them. Collective. */
  bool any_contact(const ActiveSet &statuses, const Vector &like);

  /** Whether statuses differ, on any process. @param like tells the processes. Collective. */
  bool differ(const ActiveSet &a, const ActiveSet &b, const Vector &like);

  /**
   * The time until the first contact node touches if all keep their velocity, and obstacles that of
   * their mean over the horizon. Infinity if that is beyond the horizon, or if nodes are pressed
   * already: then there is no flight. Nodes that would enter by less than round-off within the
   * horizon do not count. Contact that follows the motion is that of such a step. Collective.
   */
  double time_to_touch(DynamicalSystem &system, const State &state, double horizon);
} // namespace signorini

#endif
