// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_time_scheme_h
#define signorini_time_time_scheme_h

#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

#include <memory>
#include <string>

namespace signorini
{
  /** What happened in a step: effort, and the exact work of each constraint by the energy identity of the scheme. */
  struct StepReport
  {
    SolveReport corrector;
    SolveReport predictor;
    double      work_contact   = 0.; ///< change of energy by contact forces
    double      work_predictor = 0.; ///< change of energy by the projection of the predictor
    double      work_friction  = 0.; ///< change of energy by friction
    double      work_support   = 0.; ///< work of the reactions at prescribed displacements
    double      work_scheme =
      0.; ///< change of energy by the rule of integration itself (numerical dissipation, <= 0 in the mean)
    unsigned int impulse_iterations = 0;     ///< laursen-love, per node: of the coupled equations
    bool         common_impulses    = false; ///< they had no solution; the common factor was taken instead
  };

  /**
   * A one-step method for M u'' + A u = f + r with unilateral contact.
   *
   * Contract of advance(): on entry the state is complete (momentum = M v, internal_force = A u) and admissible up to
   * tolerance; on exit it is the complete state one step later. Nothing but `state` is changed, and if an exception
   * leaves advance(), the state is as it was. The scheme keeps no memory between steps.
   */
  class TimeScheme
  {
  public:
    virtual ~TimeScheme() = default;

    virtual StepReport advance(DynamicalSystem &system, State &state, double step_size) = 0;
  };

  /** Parameters of single schemes. */
  struct SchemeParameters
  {
    double hht_alpha           = -0.1;  ///< hht-alpha: in [-1/3, 0]
    double spectral_radius     = 0.8;   ///< generalized-alpha, nonsmooth or not: of infinite frequencies, in [0, 1]
    double newmark_beta        = 0.5;   ///< khenous-laborde-renard: at least 1/4
    double newmark_gamma       = 0.5;   ///< khenous-laborde-renard: in [1/2, 2 beta]
    double reference_tolerance = 1e-8;  ///< reference: relative error per step of the integrator
    bool   impulses_per_node   = false; ///< laursen-love: each contact node gets back what it has lost
    bool   stop_sticking_nodes =
      true; ///< contact-stabilized, projected or not: sticking nodes have no tangential velocity
  };

  /** The scheme of a name in the scene: newmark, contact-implicit, ... */
  std::unique_ptr<TimeScheme> make_time_scheme(const std::string &name, const SchemeParameters &parameters = {});
} // namespace signorini

#endif
