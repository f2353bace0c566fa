// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_following_contact_h
#define signorini_simulation_following_contact_h

#include <signorini/time/time_scheme.h>

#include <memory>

namespace signorini
{
  /**
   * A scheme whose contact follows the motion. A step of the scheme has linear conditions with
   * fixed normals, and all that is proved about it holds for any normals; those that belong to its
   * own motion are found by a fixed point: make the step, take the normals of its motion, make it
   * again. Where nothing turns, the first time is the last. MovingContact says what the normals
   * are.
   */
  class FollowingContact : public TimeScheme
  {
  public:
    explicit FollowingContact(std::unique_ptr<TimeScheme> scheme)
      : scheme(std::move(scheme))
    {
    }

    /** @throws StepError if no motion belongs to its own normals */
    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;

    Needs needs() const override { return scheme->needs(); }

  private:
    const std::unique_ptr<TimeScheme> scheme;
  };
} // namespace signorini

#endif
