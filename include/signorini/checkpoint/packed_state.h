// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_checkpoint_packed_state_h
#define signorini_checkpoint_packed_state_h

#include <signorini/base/archive.h>
#include <signorini/contact/contact_surface.h>
#include <signorini/time/dynamical_system.h>

namespace signorini
{
  /**
   * What of a state cannot be computed from the rest of it: 16 bytes per degree of freedom, 24 with
   * an acceleration, 8 more where the control of steps remembers the last one. Forces and friction
   * are at contact nodes only.
   */
  struct PackedState
  {
    State numbers; ///< step and time, and the size of the last step, if it is remembered
    bool  has_acceleration = false;
    std::vector<Vector> everywhere; ///< u, v, and perhaps a and the change of v
    /** r, gaps with what was admitted, and with friction its force, slip, path and status. */
    std::vector<Vector> at_contact;

    template <int dim>
    PackedState(const State &state, const ContactSurface<dim> &surface);

    /** To be read. */
    PackedState() = default;

    /**
     * The state with all products, and the system where it belongs to. Vectors are those of the
     * system, which may be another one on the same mesh. Collective.
     */
    template <int dim>
    State unpack(ContactSurface<dim> &surface, DynamicalSystem &system) const;

    /** All but what is everywhere. Collective, and on the first process in full. */
    void archive(Archive &archive, const Vector &like);
  };
} // namespace signorini

#endif
