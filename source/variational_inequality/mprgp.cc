// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>
#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/variational_inequality/held_values.h>
#include <signorini/variational_inequality/mprgp.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /**
     * The problem in the variables y_i = x_i / s_i, s_i = K_ii^(-1/2), whose matrix has a unit
     * diagonal. Entry by entry: what it is (free, fixed), its bound, and the parts of the gradient
     * of Dostal's method.
     */
    class ScaledProblem
    {
    public:
      explicit ScaledProblem(const ConstrainedProblem &problem)
        : problem(problem)
        , bounds(problem.right_hand_side.locally_owned_size(),
                 std::numeric_limits<double>::infinity())
        , is_fixed(bounds.size(), 0)
      {
        scaling.reinit(problem.right_hand_side, true);
        problem.matrix.diagonal(scaling);
        for (unsigned int i = 0; i < bounds.size(); ++i)
          scaling.local_element(i) = 1. / std::sqrt(scaling.local_element(i));
        for (std::size_t k = 0; k < problem.bounded_entries.size(); ++k)
          bounds[problem.bounded_entries[k]] =
            problem.upper_bounds[k] / scaling.local_element(problem.bounded_entries[k]);
        for (const unsigned int j : problem.fixed_entries)
          is_fixed[j] = 1;
        scratch.reinit(scaling, true);
      }

      unsigned int size() const { return bounds.size(); }

      /** destination = S K S source. */
      void vmult(Vector &destination, const Vector &source) const
      {
        scratch = source;
        scratch.scale(scaling);
        problem.matrix.vmult(destination, scratch);
        destination.scale(scaling);
      }

      /** gradient = S K S y - S b. */
      void compute_gradient(Vector &gradient, const Vector &y) const
      {
        vmult(gradient, y);
        scratch = problem.right_hand_side;
        scratch.scale(scaling);
        gradient -= scratch;
      }

      bool at_bound(const unsigned int i, const Vector &y) const
      {
        return y.local_element(i) >= bounds[i];
      }

      /**
       * Free and chopped gradient: what can be gained with, and by leaving, the present active
       * set.
       */
      void split(const Vector &gradient, const Vector &y, Vector &free, Vector &chopped) const
      {
        for (unsigned int i = 0; i < size(); ++i)
          {
            const double g           = is_fixed[i] ? 0. : gradient.local_element(i);
            const bool   held        = at_bound(i, y);
            free.local_element(i)    = held ? 0. : g;
            chopped.local_element(i) = held ? std::max(g, 0.) : 0.;
          }
      }

      /** free' (free gradient reduced to what a projected step of this length would use). */
      double reduced_product(const Vector &free, const Vector &y, const double step_length) const
      {
        double sum = 0.;
        for (unsigned int i = 0; i < size(); ++i)
          {
            const double phi = free.local_element(i);
            sum +=
              phi
              * (phi < 0. ? std::max(phi, (y.local_element(i) - bounds[i]) / step_length) : phi);
          }
        return dealii::Utilities::MPI::sum(sum, y.get_mpi_communicator());
      }

      /** Largest feasible step along -direction. */
      double feasible_step(const Vector &direction, const Vector &y) const
      {
        double step = std::numeric_limits<double>::max();
        for (unsigned int i = 0; i < size(); ++i)
          if (direction.local_element(i) < 0.)
            step = std::min(step, (y.local_element(i) - bounds[i]) / direction.local_element(i));
        return dealii::Utilities::MPI::min(step, y.get_mpi_communicator());
      }

      void project(Vector &y) const
      {
        for (unsigned int i = 0; i < size(); ++i)
          y.local_element(i) = std::min(y.local_element(i), bounds[i]);
      }

      /** Upper estimate of the largest eigenvalue of S K S by the power method. */
      double largest_eigenvalue() const
      {
        Vector x(scaling), y(scaling);
        for (unsigned int i = 0; i < size(); ++i)
          x.local_element(i) = std::sin(1. + 7. * i);
        double eigenvalue = 1.;
        for (unsigned int k = 0; k < 30; ++k)
          {
            vmult(y, x);
            eigenvalue = y.l2_norm() / x.l2_norm();
            x.equ(1. / y.l2_norm(), y);
          }
        return 1.2 * eigenvalue;
      }

      Vector scaling;

    private:
      const ConstrainedProblem &problem;
      std::vector<double>       bounds;
      std::vector<char>         is_fixed;
      mutable Vector            scratch;
    };


    /** The method at a feasible point y. */
    class Iteration
    {
    public:
      Iteration(const ScaledProblem &scaled, const Vector &solution)
        : scaled(scaled)
        , step_length(1.9 / scaled.largest_eigenvalue())
        , y(solution)
        , gradient(solution)
        , free(solution)
        , chopped(solution)
        , direction(solution)
        , product(solution)
      {
        for (unsigned int i = 0; i < scaled.size(); ++i)
          y.local_element(i) /= scaled.scaling.local_element(i);
        scaled.project(y);
        scaled.compute_gradient(gradient, y);
        restart();
      }

      const Vector &point() const { return y; }

      /** Of the projected gradient, which vanishes at the solution only. */
      double gradient_norm() const { return std::sqrt(dot(free, free) + dot(chopped, chopped)); }

      /** Go on. @return whether the active set may have changed */
      bool advance()
      {
        if (dot(chopped, chopped) > scaled.reduced_product(free, y, step_length))
          {
            proportion();
            return true;
          }
        scaled.vmult(product, direction);
        const double length   = dot(gradient, direction) / dot(direction, product);
        const double feasible = scaled.feasible_step(direction, y);
        if (length > feasible)
          {
            expand(feasible);
            return true;
          }
        // conjugate gradients within the face
        y.add(-length, direction);
        gradient.add(-length, product);
        scaled.split(gradient, y, free, chopped);
        const double conjugation = dot(free, product) / dot(direction, product);
        direction.sadd(-conjugation, 1., free);
        return false;
      }

    private:
      const ScaledProblem &scaled;
      const double         step_length; ///< of projected gradient steps
      Vector               y, gradient, free, chopped, direction, product;

      /** Conjugate gradients start anew from the present point. */
      void restart()
      {
        scaled.split(gradient, y, free, chopped);
        direction = free;
      }

      /** Expand the active set: to the boundary of the face, then a projected gradient step. */
      void expand(const double feasible)
      {
        y.add(-feasible, direction);
        gradient.add(-feasible, product);
        scaled.split(gradient, y, free, chopped);
        y.add(-step_length, free);
        scaled.project(y);
        scaled.compute_gradient(gradient, y);
        restart();
      }

      /** Release entries by a step along the chopped gradient, which points inwards. */
      void proportion()
      {
        scaled.vmult(product, chopped);
        const double length = dot(gradient, chopped) / dot(chopped, product);
        y.add(-length, chopped);
        gradient.add(-length, product);
        restart();
      }
    };


    /** Back to x, with the entries at their bounds there exactly, and to its residual. */
    void return_solution(const ConstrainedProblem &problem,
                         const ScaledProblem      &scaled,
                         const Vector             &y,
                         ActiveSet                &active,
                         Vector                   &solution,
                         Vector                   &residual)
    {
      for (unsigned int i = 0; i < scaled.size(); ++i)
        solution.local_element(i) = y.local_element(i) * scaled.scaling.local_element(i);
      for (std::size_t k = 0; k < active.size(); ++k)
        {
          const unsigned int i = problem.bounded_entries[k];
          active[k]            = scaled.at_bound(i, y);
          if (active[k])
            solution.local_element(i) = problem.upper_bounds[k];
        }
      for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
        solution.local_element(problem.fixed_entries[j]) = problem.fixed_values[j];
      compute_residual(problem, solution, residual);
    }
  } // namespace


  SolveReport Mprgp::solve(const ConstrainedProblem &problem,
                           ActiveSet                &active,
                           Vector                   &solution,
                           Vector                   &residual)
  {
    check_sizes(problem, active, solution, residual);
    for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
      solution.local_element(problem.fixed_entries[j]) = problem.fixed_values[j];
    const ScaledProblem scaled(problem);
    Iteration           iteration(scaled, solution);

    // The norm here is the diagonal one; the smallest eigenvalue of S K S for Q1 is above 0.01 for
    // mass-dominated matrices.
    const double goal = 0.1 * problem.tolerance;
    SolveReport  report;
    report.active_set_iterations = 1;
    double norm                  = iteration.gradient_norm();
    for (; norm > goal && report.linear_iterations < maximum_iterations; ++report.linear_iterations)
      {
        heed_interruption(solution.get_mpi_communicator());
        report.active_set_iterations += iteration.advance();
        norm = iteration.gradient_norm();
      }
    if (!(norm <= goal))
      throw StepError(
        "The inequality of this step was not solved to its tolerance: neither the active set "
        "method nor truncated Newton multigrid nor MPRGP converged. Choose a larger "
        "Solver/Tolerance or a smaller Time/Step "
        "size.");

    return_solution(problem, scaled, iteration.point(), active, solution, residual);
    report.n_active = dealii::Utilities::MPI::sum(
      static_cast<unsigned int>(std::count(active.begin(), active.end(), 1)),
      solution.get_mpi_communicator());
    return report;
  }
} // namespace signorini
