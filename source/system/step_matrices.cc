// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/geometric_multigrid.h>
#include <signorini/preconditioners/preconditioner_choice.h>
#include <signorini/system/step_matrices.h>
#include <signorini/variational_inequality/make_solver.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** Matrices: sizes of steps and half steps, and their neighbours. */
    constexpr unsigned int n_kept = 4;
    /** In solutions: older increments belong to another phase of the motion. */
    constexpr unsigned int forget_age = 4;
  } // namespace


  template <int dim>
  StepMatrices<dim>::StepMatrices(const Discretization<dim>     &discretization,
                                  const ContactCoordinates<dim> &coordinates,
                                  const PreconditionerChoice    &preconditioner,
                                  dealii::TimerOutput           &timer)
    : discretization(discretization)
    , coordinates(coordinates)
    , preconditioner(preconditioner)
    , timer(timer)
  {
  }


  template <int dim>
  StepMatrix<dim> &StepMatrices<dim>::get(const double stiffness_factor,
                                          const double damping_factor,
                                          const double step_size)
  {
    Assert(stiffness_factor >= 0., dealii::ExcMessage("M + s A is definite with s >= 0."));
    Assert(step_size > 0., dealii::ExcMessage("A step goes forward in time."));
    ++uses;
    const auto known =
      std::find_if(recent.begin(), recent.end(), [&](const StepMatrix<dim> &matrix) {
        return matrix.sum.stiffness == stiffness_factor && matrix.sum.damping == damping_factor;
      });
    // Bodies that meet share their guesses, or their momentum would be wrong by two errors.
    if (!parts)
      parts = std::make_shared<const SeparateParts>(
        coordinates.coupling().any() ? SeparateParts()
                                     : SeparateParts::of<dim>(discretization.matrices().pattern));
    if (known != recent.end())
      recent.splice(recent.begin(), recent, known);
    else
      {
        if (recent.size() == n_kept)
          recent.pop_back();
        const MatrixSum sum{1., stiffness_factor, damping_factor};
        recent.push_front(
          {sum,
           std::make_unique<StepOperator<dim>>(discretization.matrices(), coordinates, sum),
           nullptr,
           nullptr,
           IncrementForecast(parts),
           PreconditionerKind::automatic,
           uses,
           0,
           {}});
      }
    StepMatrix<dim> &matrix = recent.front();
    if (uses - matrix.last_use > forget_age)
      matrix.forecast.clear();
    matrix.last_use = uses;
    // Only for the first use, and when their number has doubled.
    if ((matrix.n_uses & (matrix.n_uses - 1)) == 0)
      {
        condense(matrix, step_size);
        choose(matrix, step_size);
      }
    ++matrix.n_uses;
    return matrix;
  }


  template <int dim>
  void StepMatrices<dim>::condense(StepMatrix<dim> &matrix, const double step_size)
  {
    // Steps that find events and halves of steps pass sizes that do not come back.
    constexpr unsigned int uses_of_passing_sizes = 3;
    if (matrix.condensed || (recent.size() > 1 && matrix.n_uses < uses_of_passing_sizes))
      return;
    const StepsOfMatrix use{step_size,
                            std::max(preconditioner.mesh_life_time, 2 * matrix.n_uses),
                            preconditioner.with_friction};
    if (condenses(
          preconditioner.condensation, preconditioner.kind, discretization, coordinates, use))
      matrix.condensed = std::make_unique<CondensedContact<dim>>(
        discretization.matrices(),
        coordinates,
        matrix.sum,
        make_solver(
          preconditioner.with_friction, preconditioner.inequality, preconditioner.limits));
  }


  template <int dim>
  unsigned int StepMatrices<dim>::n_factors() const
  {
    unsigned int n = 0;
    for (const StepMatrix<dim> &matrix : recent)
      n += matrix.condensed ? matrix.condensed->n_factors() : 0;
    return n;
  }


  template <int dim>
  void StepMatrices<dim>::choose(StepMatrix<dim> &matrix, const double step_size)
  {
    PreconditionerKind kind = preconditioner.kind;
    if (kind == PreconditionerKind::automatic && matrix.condensed) // it measures forces only
      kind = matrix.preconditioner ? matrix.kind : PreconditionerKind::jacobi;
    if (kind == PreconditionerKind::automatic)
      {
        if (matrix.kind == PreconditionerKind::multigrid
            || (preconditioner.solves_roughly
                && matrix.kind == PreconditionerKind::incomplete_cholesky))
          return; // what it was taken for does not go away
        StepCost cost = cost_of_step(discretization, step_size);
        // Nobody knows how long a mesh will last; one that has outlived what was expected may do so
        // again.
        cost.matrix_life_time = std::max(preconditioner.mesh_life_time, 2 * matrix.n_uses);
        cost.solves_roughly   = preconditioner.solves_roughly;
        cost.with_friction    = preconditioner.with_friction;
        if (matrix.effort.active_set_iterations > 0)
          cost.iterations = static_cast<double>(matrix.effort.linear_iterations)
                            / matrix.effort.active_set_iterations;
        kind = choose_preconditioner(cost);
      }
    if (kind == matrix.kind)
      return;
    dealii::TimerOutput::Scope scope(timer, "step: preconditioner set-up");
    if (kind == PreconditionerKind::multigrid)
      {
        if (!hierarchy)
          hierarchy = std::make_shared<const LevelHierarchy<dim>>(discretization,
                                                                  coordinates.clamped_nodes());
        matrix.preconditioner = make_geometric_multigrid(
          hierarchy, coordinates, matrix.sum, needs_double_precision(discretization, step_size));
      }
    else
      matrix.preconditioner =
        make_preconditioner(kind, discretization.matrices(), coordinates, matrix.sum);
    matrix.kind   = kind;
    matrix.effort = SolveReport();
    ++built;
  }


  template class StepMatrices<2>;
  template class StepMatrices<3>;
} // namespace signorini
