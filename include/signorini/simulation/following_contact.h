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
   *
   * As in inexact Newton methods, a step that will be made again is solved roughly (Dembo,
   * Eisenstat, Steihaug, SIAM J. Numer. Anal. 19 (1982) 400-408): it is a trial. The last one is
   * solved to the full accuracy. What is expected of a step is what the latest one took; that
   * decides about effort only.
   */
  class FollowingContact : public TimeScheme
  {
  public:
    explicit FollowingContact(std::unique_ptr<TimeScheme> scheme)
      : scheme(std::move(scheme))
    {
    }

    /** @throws StepError if no motion belongs to its own normals */
    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

    void forget() override
    {
      expects_repetitions = false;
      contraction         = usual_contraction;
    }

    Needs needs() const override { return scheme->needs(); }

  private:
    const std::unique_ptr<TimeScheme> scheme;
    static constexpr double           usual_contraction = 0.05;
    bool   expects_repetitions = false;             ///< the latest step had to be made again
    double contraction         = usual_contraction; ///< of the mismatch, by the latest repetition
  };
} // namespace signorini

#endif
