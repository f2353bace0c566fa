// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>
#include <signorini/linear_algebra/improved_guess.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/variational_inequality/attainable_norm.h>
#include <signorini/variational_inequality/held_values.h>
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
        , cut(solution)
        , product(solution)
        , product_of_uncut(solution)
      {
        for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
          x.local_element(problem.fixed_entries[j]) = problem.fixed_values[j];
        for_each_bound([&](const unsigned int i, const double bound) {
          x.local_element(i) = std::min(x.local_element(i), bound);
        });
        compute_residual(problem, x, r);
        problem.matrix.diagonal(diagonal);
        truncate();
      }

      /**
       * Of the residual: where nothing is truncated in the norm of the preconditioner, and of
       * forces that pull at a bound in that of the diagonal.
       */
      double norm() const { return std::sqrt(std::abs(square) + pulling); }

      /** Whether more can be gained by leaving bounds than by a linear step. */
      bool should_release() const { return pulling > std::abs(square); }

      /** Whether entries are truncated that were not in the last linear step, or the reverse. */
      bool set_has_changed() const { return has_changed; }

      /** Along the scaled gradient, and onto the bounds. */
      void nonlinear_step()
      {
        for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
          cut.local_element(i) = damping * r.local_element(i) / diagonal.local_element(i);
        for (const unsigned int j : problem.fixed_entries)
          cut.local_element(j) = 0.;
        const bool is_cut = project(cut);
        const Line line   = look_along(cut, product, is_cut);
        advance(line, cut, product);
        if (line.best < 1.)
          damping *= 0.7; // shorter ones end on the bounds that they are cut at
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
        cut               = direction;
        const bool is_cut = project(cut);
        const Line line   = look_along(cut, product, is_cut);
        bool       uncut  = !is_cut;
        if (is_cut && line.best < 1.)
          {
            // A body that falls as a whole would be bent by what its first nodes meet: it can also
            // fall until then.
            const Line other = look_along(direction, product_of_uncut, false);
            uncut            = other.gain() > line.gain();
            if (uncut)
              advance(other, direction, product_of_uncut);
          }
        if (!uncut || !is_cut)
          advance(line, cut, product);
        truncate();
        return !is_cut && line.length == line.best;
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
      Vector                    diagonal, direction, correction, cut, product, product_of_uncut;
      Mask                      mask;
      double                    square = 0., last_square = 0., pulling = 0.;
      double                    damping     = 0.5; ///< of nonlinear steps
      bool                      has_changed = true;

      template <typename Action>
      void for_each_bound(const Action &action) const
      {
        for (std::size_t k = 0; k < problem.bounded_entries.size(); ++k)
          action(problem.bounded_entries[k], problem.upper_bounds[k]);
      }

      /** Hold what is at its bound, and see what a linear step would do. */
      void truncate()
      {
        Mask held(x.locally_owned_size(), 0);
        for (const unsigned int j : problem.fixed_entries)
          held[j] = 1;
        pulling = 0.;
        for_each_bound([&](const unsigned int i, const double bound) {
          held[i] = x.local_element(i) >= bound;
          if (const double force = r.local_element(i); held[i] && force < 0.)
            pulling += force * force / diagonal.local_element(i);
        });
        pulling = dealii::Utilities::MPI::sum(pulling, x.get_mpi_communicator());
        // The preconditioner still has the mask of an earlier problem, and mask is empty at first.
        has_changed = dealii::Utilities::MPI::max(static_cast<unsigned int>(held != mask),
                                                  x.get_mpi_communicator())
                      > 0;
        if (has_changed)
          {
            mask = std::move(held);
            problem.preconditioner.set_mask(mask);
          }
        problem.preconditioner.vmult(correction, r);
        square = dot(correction, r);
      }

      /** What is left of a direction on the bounds. @return whether it was cut */
      bool project(Vector &d) const
      {
        unsigned int n_cut = 0;
        for_each_bound([&](const unsigned int i, const double bound) {
          const double distance = bound - x.local_element(i);
          n_cut += d.local_element(i) > distance;
          d.local_element(i) = std::min(d.local_element(i), distance);
        });
        return dealii::Utilities::MPI::sum(n_cut, x.get_mpi_communicator()) > 0;
      }

      /** The energy along a direction. */
      struct Line
      {
        double slope = 0., curvature = 0.;
        double best   = 1.; ///< length with the least energy; 1 if the energy does not fall
        double length = 0.; ///< to go

        double gain() const { return length * (slope - 0.5 * length * curvature); }
      };

      /**
       * How far to go: as the energy falls and the bounds allow. What was cut should end at its
       * bound, so a whole step is then preferred to the longest.
       */
      Line look_along(const Vector &d, Vector &product_with, const bool is_cut) const
      {
        problem.matrix.vmult(product_with, d);
        Line line;
        line.slope     = dot(r, d);
        line.curvature = dot(d, product_with);
        if (!(line.slope > 0. && line.curvature > 0.))
          return line; // the bounds have spoiled the direction
        line.best   = line.slope / line.curvature;
        line.length = is_cut ? std::min(line.best, 1.) : std::min(line.best, farthest_step(d));
        return line;
      }

      void advance(const Line &line, const Vector &d, const Vector &product_with)
      {
        x.add(line.length, d);
        r.add(-line.length, product_with);
        for_each_bound([&](const unsigned int i, const double bound) {
          // Round-off must not leave a node just beside its bound.
          const double distance = bound - x.local_element(i);
          if (distance <= 1e-14 * line.length * d.local_element(i) || distance < 0.)
            x.local_element(i) = bound;
        });
      }

      double farthest_step(const Vector &d) const
      {
        double farthest = std::numeric_limits<double>::max();
        for_each_bound([&](const unsigned int i, const double bound) {
          if (d.local_element(i) > 0.)
            farthest = std::min(farthest, (bound - x.local_element(i)) / d.local_element(i));
        });
        return dealii::Utilities::MPI::min(farthest, x.get_mpi_communicator());
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
        heed_interruption(solution.get_mpi_communicator());
        const bool is_linear = was_free && !point.should_release();
        if (!is_linear)
          point.nonlinear_step();
        was_free = point.linear_step(is_linear && same_set);
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
