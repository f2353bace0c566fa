// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_time_stepping_h
#define signorini_step_size_time_stepping_h

#include <signorini/base/archive.h>
#include <signorini/step_size/step_estimate.h>

#include <string>
#include <vector>

namespace signorini
{
  /** Leads a scheme through a run, from one accepted step to the next. */
  class TimeStepping
  {
  public:
    virtual ~TimeStepping() = default;

    /**
     * The state one accepted step later. If an exception leaves, the state is as it was.
     * Collective.
     */
    virtual StepReport advance(DynamicalSystem &system, State &state) = 0;

    /** The part of the run that is done: 1 at its end. */
    virtual double fraction_done(const State &state) const = 0;

    bool finished(const State &state) const { return fraction_done(state) >= 1.; }

    /**
     * The mesh has changed: keep no vectors, and nothing that depends on the size of cells. The
     * next step is the next one all the same.
     */
    virtual void forget() {}

    /** What a changed mesh does not make it forget. */
    virtual void archive(Archive & /*archive*/) {}

    /** The step that was handed out last does not count: it is repeated on another mesh. */
    virtual void take_back() {}

    /** What has become doubtful about the sizes since this was last asked, a sentence each. */
    virtual std::vector<std::string> news() { return {}; }

    /** How the sizes came out, in words; empty if there is nothing to say. */
    virtual std::string summary() const { return ""; }
  };
} // namespace signorini

#endif
