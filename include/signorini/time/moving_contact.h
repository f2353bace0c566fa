// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_moving_contact_h
#define signorini_time_moving_contact_h

#include <signorini/base/step_normals.h>
#include <signorini/time/state.h>

#include <vector>

namespace signorini
{
  /**
   * Contact whose normals and gaps are those of the motion of each step. In a step they are fixed,
   * and a step that was made with those of another motion is made again.
   */
  class MovingContact
  {
  public:
    virtual ~MovingContact() = default;

    /** The bodies are here, and no step has begun: on a new mesh. */
    virtual void arrive(const Vector &displacement, double time) = 0;

    /** Look around at the start of a step; normals are those of the motion that is expected. */
    virtual void begin_step(const State &start, double step_size, StepNormals normals) = 0;

    /**
     * Return to the geometry of a step that was made before others, and that its forces belong to.
     */
    virtual void return_to(const State &start, const State &end) = 0;

    /**
     * The latest step does not count: return to the geometry of the one before it.
     * @param start of the latest step
     */
    virtual void take_back(const State &start) = 0;

    /** Take the normals of a motion of the same step, which will be made again with them. */
    virtual void follow(const Vector &increment) = 0;

    /** Whether the step that is made now is the latest one with other normals. */
    virtual bool repeats() const = 0;

    /**
     * Whether steps are trials from now on: they will be made again, so that nothing but their
     * motion is wanted, and that with a hundredth of the error of its first guess.
     */
    virtual void let_steps_be_trials(bool they_are) = 0;
    virtual bool steps_are_trials() const           = 0;

    /**
     * How far the true gaps at the end of the step just made are from what its normals say, where
     * that matters; in units of what can be tolerated. The same on all processes.
     */
    virtual double mismatch(const Vector &increment) = 0;

    /** Whether a motion passes through something, between a start and an end without contact. */
    virtual bool passes_through(const Vector &increment) const = 0;

    /**
     * By how much a motion that is tangential where the step begins is along the normals of the
     * step: per contact node, >= 0, and zero but where the node faces something curved that does
     * not turn. That is how a node slides into a hollow, and no approach.
     * @param free_increment relative to obstacles that move
     */
    virtual NormalGap tangential_approach(const Vector &free_increment) const = 0;

    /**
     * Normals become those of where a motion ends at the nodes that tangential_approach() is about,
     * until face_motion(). Both are collective.
     */
    virtual void face_end(const Vector &increment) = 0;
    virtual void face_motion()                     = 0;

    /** Entries (owned, local) of increments on which normals depend. */
    virtual const std::vector<unsigned int> &entries() const = 0;

    /**
     * The motion of what the contact nodes face, in the step: an increment for each contact node,
     * zero elsewhere. Null where nothing moves by itself.
     */
    virtual const Vector *obstacle_motion() const = 0;

    /**
     * What contact forces would do along what the conditions of the latest motion miss of its true
     * gaps: an energy, zero where the motion belongs to its own conditions. Collective.
     */
    virtual double geometry_work(const Vector &contact_force) const = 0;
  };
} // namespace signorini

#endif
