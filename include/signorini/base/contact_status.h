// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_contact_status_h
#define signorini_base_contact_status_h

#include <vector>

namespace signorini
{
  /** What a contact node does in a step. Without friction, closed nodes slip. */
  namespace contact_status
  {
    constexpr char open  = 0; ///< no force
    constexpr char slip  = 1; ///< held in the normal direction; friction, if any, is at its bound
    constexpr char stick = 2; ///< held in all directions relative to the other side
    /** Held in the tangential directions only: possible with Tresca's friction. */
    constexpr char hang = 3;

    inline bool is_closed(const char status)
    {
      return status == slip || status == stick;
    }

    inline bool sticks(const char status)
    {
      return status == stick || status == hang;
    }
  } // namespace contact_status

  /** The status of each contact node (bounded entry). */
  using ActiveSet = std::vector<char>;

  // What counts as contact where there is no status but only gaps and forces. Solvers leave exactly
  // no force at open nodes and put closed ones into their bounds, so that round-off decides only
  // where motions and forces were summed up or carried to another mesh.

  /** A gap up to this touches, and an overlap up to this is none. @param length size of the bodies
   */
  inline double touching_distance(const double length)
  {
    return 1e-10 * length;
  }

  /**
   * A gap whose size is below this is zero: the round-off of the geometry. @param length size of
   * the bodies
   */
  inline double gap_round_off(const double length)
  {
    return 1e-12 * length;
  }

  /**
   * Whether a node of a solved step is under pressure. @param normal_force along the normal out of
   * the body
   */
  inline bool is_pressed(const double normal_force)
  {
    return normal_force < 0.;
  }

  /**
   * Nodal forces and stresses below this part of the largest one are round-off, where they came
   * from another mesh.
   */
  constexpr double negligible_force = 1e-9;

  /**
   * Forces below this part of the largest one, or of the energy of the motion over the size of the
   * bodies, do not count as contact for the size of the steps and in the numbers of active nodes:
   * they would hardly be noticed, and differ between one process and two. A step may end at the
   * touch within round-off, a part of 1e-9 of the step or less. With that part of the force of an
   * impact it counts as open, and what follows is decided as without any force.
   */
  constexpr double unnoticed_force = 1e-7;
} // namespace signorini

#endif
