// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/variational_inequality/attainable_norm.h>
#include <signorini/variational_inequality/held_values.h>
#include <signorini/variational_inequality/node_stiffness.h>
#include <signorini/variational_inequality/slip_system.h>
#include <signorini/variational_inequality/status_record.h>
#include <signorini/variational_inequality/tresca_friction.h>
#include <signorini/variational_inequality/tresca_minimisation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    using dealii::Utilities::MPI::sum;

    /**
     * Of one Newton step. Far beyond what a reduction by 100 takes; a step that is cut short here
     * does no harm, as the next move goes on from the best point of its direction.
     */
    constexpr unsigned int maximum_linear_iterations = 10000;

    /** What is accepted at least, in what round-off leaves of a residual. */
    constexpr double beyond_round_off = 10.;

    /** Of the length of a step, in its longest one. */
    constexpr double resolution = 1e-14;

    /** Of nodes in one Newton step; then a proximal step may release some of them. */
    constexpr unsigned int maximum_holdings = 50;

    /** The method at a point x with the residual b - K x. */
    class Descent
    {
    public:
      Descent(const ConstrainedProblem  &problem,
              const std::vector<double> &bounds,
              Vector                    &solution,
              Vector                    &residual)
        : problem(problem)
        , bounds(bounds)
        , solution(solution)
        , residual(residual)
        , stiffness(node_stiffness(problem))
        , diagonal(solution)
        , target(solution)
        , direction(solution)
        , product(solution)
        , is_fixed(solution.locally_owned_size(), 0)
        , friction(problem, bounds, solution, residual)
      {
        problem.matrix.diagonal(diagonal);
        for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
          {
            solution.local_element(problem.fixed_entries[j]) = problem.fixed_values[j];
            is_fixed[problem.fixed_entries[j]]               = 1;
          }
        for (std::size_t k = 0; k < bounds.size(); ++k)
          {
            double &normal = solution.local_element(problem.bounded_entries[k]);
            normal         = std::min(normal, problem.upper_bounds[k]);
          }
        stop_slip_of_round_off(0.); // of the guess
        update_residual();
      }

      /**
       * A step against the gradient in the metric of the diagonal, with bounds and friction taken
       * exactly, shortened to the minimum of J.
       */
      void proximal_step()
      {
        target = solution;
        for (unsigned int i = 0; i < is_fixed.size(); ++i)
          if (!is_fixed[i])
            target.local_element(i) += residual.local_element(i) / diagonal.local_element(i);
        for (std::size_t k = 0; k < bounds.size(); ++k)
          {
            clip_normal(k);
            if (!friction.acts(k))
              continue;
            const NodeForces    node = friction.forces(k);
            const TangentVector free = node.slip + node.tangential / stiffness[k];
            const double        size = free.norm(), lost = bounds[k] / stiffness[k];
            friction.set_slip(target,
                              k,
                              size > lost ? TangentVector((1. - lost / size) * free)
                                          : TangentVector(TangentVector::Zero()));
          }
        move();
      }

      /**
       * @return iterations of the linear solver; zero if x is the minimum among the points with
       *         these statuses
       */
      unsigned int newton_step(const ActiveSet &status)
      {
        Mask mask = held(status);
        // A node that has come to its bound or to rest, and would go on beyond, is held: it would
        // not let any other one move.
        unsigned int n_iterations = 0;
        bool         goes_on      = true;
        for (unsigned int n = 0; n < maximum_holdings && goes_on; ++n)
          {
            n_iterations += solve_linearised(mask);
            if (n_iterations == 0)
              return 0;
            target = solution;
            target += direction;
            if (hold_blocked(mask))
              continue;
            move_to_first_bound();
            const bool is_blocked = hold_blocked(mask), rests = hold_resting(mask);
            goes_on = is_blocked || rests;
          }
        return n_iterations;
      }

      /**
       * What holds each node at x. @return whether a held node wants to be released, on any
       * process
       */
      bool find_status(ActiveSet &status) const
      {
        unsigned int wrong = 0;
        for (std::size_t k = 0; k < bounds.size(); ++k)
          {
            const unsigned int i      = problem.bounded_entries[k];
            const bool         closed = solution.local_element(i) >= problem.upper_bounds[k]
                                && residual.local_element(i) >= 0.;
            if (friction.acts(k) && friction.rests(k))
              status[k] = closed ? contact_status::stick : contact_status::hang;
            else
              status[k] = closed ? contact_status::slip : contact_status::open;
            wrong += friction.acts(k) && friction.forces(k).slip.norm() == 0. && !friction.rests(k);
          }
        return sum(wrong, solution.get_mpi_communicator()) > 0;
      }

    private:
      const ConstrainedProblem  &problem;
      const std::vector<double> &bounds;
      Vector                    &solution, &residual;
      const std::vector<double>  stiffness;
      Vector                     diagonal, target, direction, product;
      Mask                       is_fixed;
      SlipSystem                 slip;
      const TrescaFriction       friction;

      /** What statuses hold. */
      Mask held(const ActiveSet &status) const
      {
        Mask mask = is_fixed;
        for (std::size_t k = 0; k < bounds.size(); ++k)
          {
            if (contact_status::is_closed(status[k]))
              mask[problem.bounded_entries[k]] = 1;
            if (friction.acts(k) && friction.rests(k))
              hold_tangentially(k, mask);
          }
        return mask;
      }

      /** The direction to the minimum of the entries that a mask leaves. @return iterations */
      unsigned int solve_linearised(const Mask &mask)
      {
        slip.clear();
        for (std::size_t k = 0; k < bounds.size(); ++k)
          if (moves(k, mask))
            slip.add(
              problem.bounded_entries[k], problem.friction[k], friction.condition(k), stiffness[k]);
        slip.finish(solution.get_mpi_communicator());
        problem.preconditioner.set_mask(mask);
        product           = residual;
        const auto report = slip.solve_symmetric(
          problem,
          product,
          direction,
          std::max(problem.tolerance, beyond_round_off * attainable_norm(problem, solution)),
          1e-2,
          maximum_linear_iterations);
        if (report.iterations == 0 && !report.converged)
          throw StepError("The preconditioner is indefinite. Choose another `Preconditioner`.");
        return report.iterations;
      }

      /**
       * Hold entries at their bounds whose target is beyond, and nodes without slip whose target is
       * against the force that is to make them slip. @return whether any, anywhere
       */
      bool hold_blocked(Mask &mask) const
      {
        unsigned int n = 0;
        for (std::size_t k = 0; k < bounds.size(); ++k)
          {
            const unsigned int i = problem.bounded_entries[k];
            if (!mask[i] && solution.local_element(i) >= problem.upper_bounds[k]
                && target.local_element(i) > problem.upper_bounds[k])
              {
                mask[i] = 1;
                ++n;
              }
            if (moves(k, mask) && friction.forces(k).slip.norm() == 0.
                && friction.forces(k).tangential.dot(target_slip(k)) < 0.)
              n += hold_tangentially(k, mask);
          }
        return sum(n, solution.get_mpi_communicator()) > 0;
      }

      /** Hold nodes that have come to rest. @return whether any, anywhere */
      bool hold_resting(Mask &mask) const
      {
        unsigned int n = 0;
        for (std::size_t k = 0; k < bounds.size(); ++k)
          if (moves(k, mask) && friction.rests(k))
            n += hold_tangentially(k, mask);
        return sum(n, solution.get_mpi_communicator()) > 0;
      }

      /** Whether there is friction, and the node is not held against it. */
      bool moves(const std::size_t k, const Mask &mask) const
      {
        return friction.acts(k) && !mask[problem.friction[k].entries.front()];
      }

      /** @return 1, the number of nodes */
      unsigned int hold_tangentially(const std::size_t k, Mask &mask) const
      {
        for (const unsigned int i : problem.friction[k].entries)
          mask[i] = 1;
        return 1;
      }

      TangentVector target_slip(const std::size_t k) const
      {
        return problem.friction[k].past + tangential_entries(problem.friction[k], target);
      }

      void clip_normal(const std::size_t k)
      {
        double &normal = target.local_element(problem.bounded_entries[k]);
        normal         = std::min(normal, problem.upper_bounds[k]);
      }

      /**
       * To the minimum of J on the segment from x to the target; entries that reach a bound or a
       * kink are there exactly.
       */
      void move()
      {
        direction = target;
        direction -= solution;
        problem.matrix.vmult(product, direction);
        const double length = step_length(dot(direction, product));
        if (length == 1.)
          solution = target;
        else
          solution.add(length, direction);
        stop_slip_of_round_off(1.);
        update_residual();
      }

      /**
       * Straight to the minimum of J on the way to the target, but no further than to the first
       * bound, where the node is exactly then. (Towards a target with all bounds and kinks taken
       * into account, which is no smooth displacement any more, J hardly falls.)
       */
      void move_to_first_bound()
      {
        direction = target;
        direction -= solution;
        std::vector<double> distances(bounds.size(), std::numeric_limits<double>::infinity());
        double              first = 1.;
        for (std::size_t k = 0; k < bounds.size(); ++k)
          {
            const unsigned int i = problem.bounded_entries[k];
            if (target.local_element(i) > problem.upper_bounds[k])
              distances[k] =
                (problem.upper_bounds[k] - solution.local_element(i)) / direction.local_element(i);
            first = std::min(first, distances[k]);
          }
        first = dealii::Utilities::MPI::min(first, solution.get_mpi_communicator());
        problem.matrix.vmult(product, direction);
        const double length = step_length(dot(direction, product), first);
        solution.add(length, direction);
        for (std::size_t k = 0; k < bounds.size(); ++k)
          if (distances[k] <= length)
            solution.local_element(problem.bounded_entries[k]) = problem.upper_bounds[k];
        stop_slip_of_round_off(first);
        update_residual();
      }

      void update_residual() { compute_residual(problem, solution, residual); }

      /**
       * @param longest of the lengths that the last step could have had
       *
       * A step that ends just short of a kink leaves a part of 1e-15 of the slip, and the next one
       * a part of that. The node would count as slipping, with all the force of its bound: the
       * curvature of |slip| hides it from Newton's method.
       */
      void stop_slip_of_round_off(const double longest)
      {
        for (std::size_t k = 0; k < bounds.size(); ++k)
          if (friction.acts(k))
            {
              const double slipped = friction.forces(k).slip.norm();
              const double change  = tangential_entries(problem.friction[k], direction).norm();
              if (slipped > 0.
                  && (stiffness[k] * slipped <= TrescaFriction::round_off * bounds[k]
                      || slipped <= resolution * longest * change))
                friction.set_slip(solution, k, TangentVector::Zero());
            }
      }

      /**
       * The zero of the derivative of J, which grows along the segment, or the longest length. What
       * friction balances is taken out node by node: it may be larger by the inverse of round-off
       * than what is left.
       */
      double step_length(const double curvature, const double longest = 1.)
      {
        Vector &unbalanced = product;
        unbalanced         = residual;
        for (std::size_t k = 0; k < bounds.size(); ++k)
          if (friction.acts(k))
            add_to_tangential_entries(problem.friction[k], -friction.force(k), unbalanced);
        const double linear     = dot(unbalanced, direction);
        const auto   derivative = [&](const double length) {
          double change = 0.;
          for (std::size_t k = 0; k < bounds.size(); ++k)
            if (friction.acts(k))
              change += friction.change(k, direction, length);
          return length * curvature - linear + sum(change, solution.get_mpi_communicator());
        };
        if (derivative(longest) <= 0.)
          return longest;
        double low = 0., high = longest;
        for (unsigned int n = 0; n < 50; ++n)
          {
            const double middle                    = 0.5 * (low + high);
            (derivative(middle) < 0. ? low : high) = middle;
          }
        return low;
      }
    };
  } // namespace


  SolveReport TrescaMinimisation::solve(const ConstrainedProblem  &problem,
                                        const std::vector<double> &bounds,
                                        ActiveSet                 &status,
                                        Vector                    &solution,
                                        Vector                    &residual)
  {
    check_sizes(problem, status, solution, residual);
    AssertDimension(bounds.size(), status.size());
    AssertDimension(problem.friction.size(), status.size());
    Assert(
      std::none_of(bounds.begin(), bounds.end(), [](const double bound) { return bound < 0.; }),
      dealii::ExcMessage("A bound of the friction is not negative."));
    Descent     descent(problem, bounds, solution, residual);
    SolveReport report;
    while (report.active_set_iterations < maximum_iterations)
      {
        ++report.active_set_iterations;
        const bool         unsettled = descent.find_status(status);
        const unsigned int effort    = descent.newton_step(status);
        report.linear_iterations += effort + 1;
        if (effort == 0 && !unsettled)
          {
            report.n_active = StatusRecord(solution).n_closed(status);
            return report;
          }
        descent.proximal_step();
      }
    throw StepError("The inequality of this step was not solved to its tolerance: the minimisation "
                    "with given bounds of friction did not converge. Choose a larger "
                    "Solver/Tolerance or a smaller Time/Step size.");
  }
} // namespace signorini
