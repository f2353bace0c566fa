// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_run_parameters_h
#define signorini_model_run_parameters_h

#include <signorini/base/inequality_method.h>
#include <signorini/base/solve_report.h>
#include <signorini/model/condensation_kind.h>

namespace signorini
{
  /** Preconditioners of the conjugate gradients. */
  enum class PreconditionerKind
  {
    automatic, ///< chosen from the Courant number
    jacobi,
    symmetric_gauss_seidel,
    incomplete_cholesky,
    ml,       ///< algebraic multigrid
    multigrid ///< geometric, on the levels of the mesh
  };

  template <>
  struct EnumNames<PreconditionerKind>
  {
    static constexpr EnumName<PreconditionerKind> table[] = {
      {PreconditionerKind::automatic, "automatic"},
      {PreconditionerKind::jacobi, "jacobi"},
      {PreconditionerKind::symmetric_gauss_seidel, "symmetric-gauss-seidel"},
      {PreconditionerKind::incomplete_cholesky, "incomplete-cholesky"},
      {PreconditionerKind::ml, "ml"},
      {PreconditionerKind::multigrid, "multigrid"}};
  };

  /** Section `Solver`: the inequality of a step and the linear systems in it. */
  struct SolverParameters
  {
    InequalityMethod   inequality     = InequalityMethod::active_set;
    PreconditionerKind preconditioner = PreconditionerKind::automatic;
    CondensationKind   condensation   = CondensationKind::automatic;
    /**
     * Solutions are accepted when their error in the energy norm of the velocity is below
     * `tolerance` times the root of the largest energy of the run so far; the energy ledger then
     * closes to this accuracy. Less where bodies hardly deform, see MotionEnergies.
     */
    double          tolerance = 2e-11;
    ActiveSetLimits limits    = {};
  };

  /** Section `Checkpoint`. */
  struct CheckpointParameters
  {
    unsigned int every_steps   = 0;  ///< 0: not by steps
    double       every_minutes = 0.; ///< of wall time; 0: not by time

    bool any() const { return every_steps > 0 || every_minutes > 0.; }
  };

  /** What a run does when a step breaks a law that its scheme proves. */
  enum class GuardAction
  {
    stop,
    warn
  };

  template <>
  struct EnumNames<GuardAction>
  {
    static constexpr EnumName<GuardAction> table[] = {{GuardAction::stop, "stop"},
                                                      {GuardAction::warn, "warn"}};
  };

  /** Section `Output`. */
  struct OutputParameters
  {
    /** Write fields every so many steps; 0: see `vtu_states`. */
    unsigned int vtu_every     = 0;
    unsigned int vtu_states    = 20; ///< number of states, evenly in time, besides the initial one
    bool         vtu           = true;
    bool         obstacles     = true; ///< with VTU: their surfaces, once
    unsigned int history_every = 1;
    unsigned int fclib_every   = 0;    ///< problems of steps as files of FCLIB; 0: none
    bool         supports      = true; ///< table of the forces of supports, if there are any
    bool         pairs         = true; ///< table of the contact of each pair, if there are any
    bool         bodies        = true; ///< table of energies and momenta of each body
    GuardAction  guard         = GuardAction::stop;
    bool         forces        = true; ///< table of contact forces by three routes, with pairs
  };
} // namespace signorini

#endif
