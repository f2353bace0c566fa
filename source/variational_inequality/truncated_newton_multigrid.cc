// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/improved_guess.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/variational_inequality/attainable_norm.h>
#include <signorini/variational_inequality/truncated_newton_multigrid.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** A feasible point x with its residual b - K x, and the steps of the method from there. */
    class FeasiblePoint
    {
    public:
      FeasiblePoint(const ConstrainedProblem &problem, Vector &solution, Vector &residual)
        : problem(problem)
        , x(solution)
        , r(residual)
        , diagonal(solution)
        , direction(solution)
        , correction(solution)
        , product(solution)
      {
        for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
          x.local_element(problem.fixed_entries[j]) = problem.fixed_values[j];
        for_each_bound([&](const unsigned int i, const double bound) {
          x.local_element(i) = std::min(x.local_element(i), bound);
        });
        problem.matrix.vmult(r, x);
        r.sadd(-1., 1., problem.right_hand_side);
        problem.matrix.diagonal(diagonal);
        truncate();
      }

      /** Norm of the residual in entries that are not truncated, in that of the preconditioner. */
      double norm() const { return std::sqrt(std::max(0., square)); }

      /** Whether entries are truncated that were not in the last linear step, or the reverse. */
      bool set_has_changed() const { return has_changed; }

      /** Along the scaled gradient, and onto the bounds. */
      void nonlinear_step()
      {
        for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
          direction.local_element(i) = r.local_element(i) / diagonal.local_element(i);
        for (const unsigned int j : problem.fixed_entries)
          direction.local_element(j) = 0.;
        project_direction();
        advance_along_direction();
        truncate();
      }

      /**
       * A linear multigrid step on what is not truncated. @param conjugate to the last one, which
       * must have been one of these, with the same truncation. @return whether no bound was in its
       * way
       */
      bool linear_step(const bool conjugate)
      {
        direction.sadd(conjugate ? square / last_square : 0., 1., correction);
        last_square       = square;
        const bool is_cut = project_direction();
        const bool is_free =
          advance_along_direction() && !is_cut; // the length of the step was free, too
        truncate();
        return is_free;
      }

      void finish(ActiveSet &active, SolveReport &report) const
      {
        report.n_active = 0;
        for (std::size_t k = 0; k < active.size(); ++k)
          report.n_active += active[k] = mask[problem.bounded_entries[k]];
        report.n_active = dealii::Utilities::MPI::sum(report.n_active, x.get_mpi_communicator());
      }

    private:
      const ConstrainedProblem &problem;
      Vector                   &x, &r;
      Vector                    diagonal, direction, correction, product;
      Mask                      mask;
      double                    square = 0., last_square = 0.;
      bool                      has_changed = true;

      template <typename Action>
      void for_each_bound(const Action &action)
      {
        for (std::size_t k = 0; k < problem.bounded_entries.size(); ++k)
          action(problem.bounded_entries[k], problem.upper_bounds[k]);
      }

      /** Hold what is pressed against its bound, and see what a linear step would do. */
      void truncate()
      {
        Mask pressed(x.locally_owned_size(), 0);
        for (const unsigned int j : problem.fixed_entries)
          pressed[j] = 1;
        for_each_bound([&](const unsigned int i, const double bound) {
          pressed[i] = x.local_element(i) >= bound && r.local_element(i) > 0.;
        });
        // The preconditioner still has the mask of an earlier problem, and mask is empty at first.
        has_changed = dealii::Utilities::MPI::max(static_cast<unsigned int>(pressed != mask),
                                                  x.get_mpi_communicator())
                      > 0;
        if (has_changed)
          {
            mask = std::move(pressed);
            problem.preconditioner.set_mask(mask);
          }
        problem.preconditioner.vmult(correction, r);
        square = dot(correction, r);
      }

      /** direction = what is left of x + direction on the bounds. @return whether it was cut */
      bool project_direction()
      {
        unsigned int n_cut = 0;
        for_each_bound([&](const unsigned int i, const double bound) {
          const double distance = bound - x.local_element(i);
          n_cut += direction.local_element(i) > distance;
          direction.local_element(i) = std::min(direction.local_element(i), distance);
        });
        return dealii::Utilities::MPI::sum(n_cut, x.get_mpi_communicator()) > 0;
      }

      /** As far as the energy falls and the bounds allow. @return whether they allowed it */
      bool advance_along_direction()
      {
        problem.matrix.vmult(product, direction);
        const double slope = dot(r, direction), curvature = dot(direction, product);
        if (!(slope > 0. && curvature > 0.))
          return false; // at the solution, or a correction that was spoiled by the bounds
        double farthest = std::numeric_limits<double>::max();
        for_each_bound([&](const unsigned int i, const double bound) {
          if (direction.local_element(i) > 0.)
            farthest =
              std::min(farthest, (bound - x.local_element(i)) / direction.local_element(i));
        });
        farthest            = dealii::Utilities::MPI::min(farthest, x.get_mpi_communicator());
        const double length = std::min(slope / curvature, farthest);
        x.add(length, direction);
        r.add(-length, product);
        if (length == farthest)
          for_each_bound([&](const unsigned int i, const double bound) {
            // Round-off must not leave a node just before its bound.
            if (bound - x.local_element(i) <= 1e-14 * length * direction.local_element(i))
              x.local_element(i) = bound;
          });
        return length < farthest;
      }
    };
  } // namespace


  SolveReport TruncatedNewtonMultigrid::solve(const ConstrainedProblem &problem,
                                              ActiveSet                &active,
                                              Vector                   &solution,
                                              Vector                   &residual)
  {
    check_sizes(problem, active, solution, residual);
    SolveReport   report;
    FeasiblePoint point(problem, solution, residual);
    const double  round_off = attainable_norm(problem, solution),
                 accepted = std::max(problem.tolerance, round_off), norm = point.norm();
    const double goal =
      norm > accepted ? accepted : std::max(improved_guess(norm, problem.tolerance), round_off);

    report.active_set_iterations = 1;
    bool was_free = true, same_set = false;
    while (point.norm() > goal && report.linear_iterations < maximum_iterations)
      {
        if (!was_free)
          point.nonlinear_step();
        was_free = point.linear_step(was_free && same_set);
        same_set = !point.set_has_changed();
        report.active_set_iterations += !same_set;
        ++report.linear_iterations;
      }
    point.finish(active, report);
    if (point.norm() <= accepted)
      return report;
    report.add(last_resort.solve(problem, active, solution, residual));
    ++report.n_fallbacks;
    return report;
  }
} // namespace signorini
