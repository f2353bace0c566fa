// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_step_matrices_h
#define signorini_system_step_matrices_h

#include <signorini/base/inequality_method.h>
#include <signorini/condensation/condensation_choice.h>
#include <signorini/condensation/condensed_contact.h>
#include <signorini/multigrid/level_hierarchy.h>
#include <signorini/preconditioners/preconditioners.h>
#include <signorini/system/increment_forecast.h>

#include <deal.II/base/timer.h>

#include <list>

namespace signorini
{
  /**
   * What belongs to one M + s A + c C: the product, its preconditioner, and the increments that
   * were its solutions.
   */
  template <int dim>
  struct StepMatrix
  {
    MatrixSum                             sum; ///< 1, s and c
    std::unique_ptr<StepOperator<dim>>    product;
    std::unique_ptr<MaskedPreconditioner> preconditioner;
    /** Solves for contact nodes alone, if that is faster. */
    std::unique_ptr<CondensedContact<dim>> condensed;
    IncrementForecast                      forecast;
    /** Of the preconditioner; automatic: there is none yet. */
    PreconditionerKind kind     = PreconditionerKind::automatic;
    unsigned int       last_use = 0; ///< counted in solutions
    unsigned int       n_uses   = 0;
    SolveReport        effort; ///< so far, with this preconditioner
  };

  /** What decides about the preconditioners of all steps. */
  struct PreconditionerChoice
  {
    PreconditionerKind kind = PreconditionerKind::automatic;
    /** Steps that will probably be made on the mesh: what it pays to build. */
    unsigned int mesh_life_time = 1;
    /** See StepCost. */
    bool solves_roughly = false;
    bool with_friction  = false;

    CondensationKind condensation = CondensationKind::automatic;
    /** Of condensed problems. */
    InequalityMethod inequality = InequalityMethod::active_set;
    ActiveSetLimits  limits     = {};
  };

  /**
   * The matrices of the step sizes that are in use: the latest few. Steps that are doubled come
   * with two sizes in turn, and sizes that are halved and doubled come back; only a new one costs a
   * preconditioner.
   */
  template <int dim>
  class StepMatrices
  {
  public:
    StepMatrices(const Discretization<dim>     &discretization,
                 const ContactCoordinates<dim> &coordinates,
                 const PreconditionerChoice    &preconditioner,
                 dealii::TimerOutput           &timer);

    /**
     * The matrix of the factors s and c; valid until the next call. @param step_size decides about
     * the preconditioner
     */
    StepMatrix<dim> &get(double stiffness_factor, double damping_factor, double step_size);

    /** Of the last matrix; empty if there was none. */
    std::string preconditioner_name() const
    {
      return recent.empty() ? "" : name_of(recent.front().kind);
    }

    /** Number of preconditioners built so far. */
    unsigned int n_built() const { return built; }

    /** Number of direct factors that the matrices in use were condensed with. */
    unsigned int n_factors() const;

  private:
    const Discretization<dim>                 &discretization;
    const ContactCoordinates<dim>             &coordinates;
    const PreconditionerChoice                 preconditioner;
    dealii::TimerOutput                       &timer;
    std::list<StepMatrix<dim>>                 recent; ///< latest first
    unsigned int                               uses = 0, built = 0;
    std::shared_ptr<const LevelHierarchy<dim>> hierarchy; ///< once it is needed
    std::shared_ptr<const SeparateParts>       parts;     ///< with guesses of their own; likewise

    /** Give the matrix the preconditioner that pays, unless it has it. */
    void choose(StepMatrix<dim> &matrix, double step_size);
    /** Condense it from now on if that pays. */
    void condense(StepMatrix<dim> &matrix, double step_size);
  };
} // namespace signorini

#endif
