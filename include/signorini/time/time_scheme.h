// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_time_scheme_h
#define signorini_time_time_scheme_h

#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * What happened in a step: effort, and the exact work of each constraint by the energy identity
   * of the scheme. Who chose the length of the step writes it in here.
   */
  struct StepReport
  {
    double      step_size = 0.;
    SolveReport corrector;
    SolveReport predictor;
    double      work_contact   = 0.; ///< change of energy by contact forces
    double      work_predictor = 0.; ///< change of energy by the projection of the predictor
    double      work_friction  = 0.; ///< change of energy by friction
    double      work_dirichlet = 0.; ///< work of the reactions at prescribed displacements
    double      work_obstacles = 0.; ///< work of moving obstacles
    double      work_damping   = 0.; ///< change of energy by viscous damping
    double      work_geometry  = 0.; ///< see MovingContact::geometry_work(); in no balance
    double work_scheme = 0.; ///< change of energy by the rule of integration: numerical dissipation
    double force_delay = 0.; ///< see SchemeInfo; as a time. Written by who leads the steps
    /**
     * Nodal forces of whatever prescribes displacements, on the bodies, in the sense in which the
     * scheme applies contact forces; see support_forces.h. Empty if nothing is prescribed.
     */
    Vector       support_force      = {};
    unsigned int impulse_iterations = 0; ///< laursen-love, per node: of the coupled equations
    bool common_impulses = false; ///< they had no solution; the common factor was taken instead
    /**
     * Attempts at this step that were thrown away: not solved, not accurate enough, or on a mesh
     * that was too coarse. Written by who leads the steps.
     */
    unsigned int rejected_steps = 0;

    /** Solves that a fallback had to finish or to replace. */
    unsigned int n_fallbacks() const
    {
      return corrector.n_fallbacks + predictor.n_fallbacks + (common_impulses ? 1 : 0);
    }
  };

  /** A step that a scheme has made: where it ended, and what happened. */
  struct TakenStep
  {
    State      state;
    StepReport report;
  };

  /** The balance of forces of a step, as error indicators see it. */
  enum class StepBalance
  {
    middle,   ///< mean displacement, the contact force of the step
    end,      ///< displacement and contact force of the end
    both_ends ///< mean displacement, mean of the contact forces at both ends
  };

  /** Which capabilities of a system a scheme cannot do without. */
  struct Needs
  {
    bool projections = false, impulses = false, massless_nodes = false, statics = false;
  };

  /**
   * A one-step method for @f$M \ddot u + A u = f + r@f$ with unilateral contact.
   *
   * Contract of make_step(): the state at the start is complete (momentum = @f$M v@f$,
   * internal_force = @f$A u@f$) and admissible up to tolerance, and the system offers what the
   * scheme needs; the state at the end is the complete one of a step later. A StepError leaves it
   * on all processes alike, and the next step may be a shorter one. The scheme keeps no memory
   * between steps, but may keep one between repetitions of a step. In a trial (is_trial()) no more
   * than the displacement at the end has to be that of the step.
   */
  class TimeScheme
  {
  public:
    virtual ~TimeScheme() = default;

    virtual TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) = 0;

    /** Make a step and go on from its end. If an exception leaves it, the state is as it was. */
    StepReport advance(DynamicalSystem &system, State &state, const double step_size)
    {
      TakenStep step = make_step(system, state, step_size);
      swap(state, step.state);
      return std::move(step.report);
    }

    /** What may be expected of the next step is as unknown as at the start of a run. */
    virtual void forget() {}

    virtual Needs needs() const { return {}; }
  };

  /** @throws UserError if the system does not offer what the scheme needs */
  void check_capabilities(const TimeScheme &scheme, DynamicalSystem &system);
} // namespace signorini

#endif
