// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/variational_inequality/attainable_norm.h>
#include <signorini/variational_inequality/frictional_newton.h>
#include <signorini/variational_inequality/held_values.h>
#include <signorini/variational_inequality/node_stiffness.h>
#include <signorini/variational_inequality/status_record.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace signorini
{
  namespace
  {
    /** By problems of Tresca's friction to where Newton's method may begin anew. */
    constexpr unsigned int most_detours = 4;

    /** Of all friction: where more turns round, a body as a whole may do so. */
    constexpr double most_that_turns = 0.25;


    /** How large the iterates are, from which more can be lost than is won. */
    class IterateSizes
    {
    public:
      /** @param negligible a length */
      IterateSizes(const Vector &first, const double tolerance, const double negligible)
        : tolerance(tolerance)
        , negligible(negligible)
        , at_start(first.l2_norm())
        , now(at_start)
        , largest(at_start)
      {
      }

      void restart(const Vector &first, const double new_tolerance)
      {
        *this = IterateSizes(first, new_tolerance, negligible);
      }

      /** @param lost of the residual, on the way there */
      void add(const Vector &iterate, const double lost)
      {
        now      = iterate.l2_norm();
        largest  = std::max(largest, now);
        at_start = is_first ? largest : at_start;
        is_first = false;
        all_lost += lost;
      }

      /** Newton's method is lost. */
      bool went_astray() const { return !(now <= 1e4 * std::max(at_start, negligible)); }
      /** The round-off of larger iterates, or of a solver, is in the residual that they leave. */
      bool left_round_off() const { return largest > 10. * now || all_lost > 0.1 * tolerance; }
      void forget()
      {
        largest  = now;
        all_lost = 0.;
      }

      double tolerance;

    private:
      double negligible;
      double at_start, now, largest, all_lost = 0.;
      bool   is_first = true;
    };
  } // namespace


  SolveReport FrictionalNewton::solve(const ConstrainedProblem &problem,
                                      ActiveSet                &status,
                                      Vector                   &solution,
                                      Vector                   &residual)
  {
    check_sizes(problem, status, solution, residual);
    AssertDimension(problem.friction.size(), status.size());
    stiffness          = node_stiffness(problem);
    outcome            = Outcome::undecided;
    turns_at_once      = true;
    SolveReport report = iterate(problem, status, solution, residual, problem.continues);
    if (outcome == Outcome::solved)
      return report;
    ++report.n_fallbacks;
    for (unsigned int n = 0; n < most_detours && outcome == Outcome::undecided; ++n)
      {
        report.add(fallback.approach(problem, status, solution, residual));
        report.add(iterate(problem, status, solution, residual, false));
      }
    if (outcome != Outcome::solved)
      report.add(fallback.solve(problem, status, solution, residual));
    return report;
  }


  SolveReport FrictionalNewton::iterate(const ConstrainedProblem &problem,
                                        ActiveSet                &status,
                                        Vector                   &solution,
                                        Vector                   &residual,
                                        const bool                continues)
  {
    SolveReport     report;
    StatusRecord    record(solution);
    Precision       precision = Precision::rough;
    double          last_norm = 0.;
    const ActiveSet at_start  = status;
    start(problem, status, solution, residual, continues);
    IterateSizes sizes(solution, tolerance, problem.bound_tolerance);
    while (report.active_set_iterations < limits.maximum_iterations)
      {
        ++report.active_set_iterations;
        linearise(problem, status, solution, residual);
        const bool is_guess = report.linear_iterations == 0 && !continues;
        const auto linear   = step(problem, solution, residual, precision, last_norm, is_guess);
        report.add_iterations(linear.iterations, linear.saved_iterations);
        if (!linear.converged)
          {
            outcome = Outcome::no_linear_solution;
            break;
          }
        sizes.add(solution, slip.round_off());
        if (sizes.went_astray())
          {
            solution = 0.;
            residual = problem.right_hand_side;
            start(problem, status = at_start, solution, residual, false);
            sizes.restart(solution, tolerance = std::max(tolerance, sizes.tolerance));
            if (!may_be_for_want_of_accuracy(record, precision))
              break;
            continue;
          }
        if (update(problem, status, solution, residual) == 0)
          {
            if (sizes.left_round_off())
              {
                compute_residual(problem, solution, residual);
                sizes.forget();
              }
            else if (linear.iterations == 0 || problem.is_rough)
              {
                report.n_active = record.n_closed(status);
                outcome         = Outcome::solved;
                return report;
              }
            precision = std::max(precision, Precision::settled);
          }
        else if (is_cycle(record, status, precision))
          break;
        else
          hold(problem, status, solution, residual);
        last_norm = slip.any() ? slip.initial_norm() : 0.;
      }
    return report;
  }


  bool FrictionalNewton::may_be_for_want_of_accuracy(StatusRecord &record, Precision &precision)
  {
    record.forget();
    return std::exchange(precision, Precision::full) != Precision::full;
  }


  bool
  FrictionalNewton::is_cycle(StatusRecord &record, const ActiveSet &status, Precision &precision)
  {
    if (!record.is_new(status))
      {
        if (!std::exchange(turns_at_once, false))
          return !may_be_for_want_of_accuracy(record, precision);
        record.forget();
        return false;
      }
    if (precision == Precision::settled)
      precision = Precision::rough;
    return false;
  }


  void FrictionalNewton::start(const ConstrainedProblem &problem,
                               ActiveSet                &status,
                               Vector                   &solution,
                               Vector                   &residual,
                               const bool                continues)
  {
    for (std::size_t k = 0; k < status.size(); ++k)
      if (problem.upper_bounds[k] == std::numeric_limits<double>::infinity())
        status[k] = contact_status::open; // a guess from elsewhere
      else if (contact_status::sticks(status[k]) && problem.friction[k].entries.empty())
        status[k] = contact_status::slip;
    if (continues)
      hold(problem, status, solution, residual);
    else
      {
        move_to_values(problem, status, solution);
        compute_residual(problem, solution, residual);
      }
    // Beyond round-off GMRES would go on to a space that is exhausted, and spoil the forces.
    tolerance = std::max(problem.tolerance, attainable_norm(problem, solution));
    slipping.clear();
    // What continues ended with its statuses, as the forces of the linearised law told them. Those
    // are gone: the residual may tell others, which the first step would take back at the cost of
    // what the latest iterate had achieved.
    if (!continues && update(problem, status, solution, residual) > 0)
      hold(problem, status, solution, residual);
  }


  bool FrictionalNewton::few_turn_round(const ConstrainedProblem &problem,
                                        const ActiveSet          &status,
                                        const Vector             &solution,
                                        const Vector             &residual) const
  {
    double turning = 0., all = 0.; // bounds of the forces
    auto   slipped = slipping.begin();
    for (std::size_t k = 0; k < status.size(); ++k)
      {
        const FrictionNode &node   = problem.friction[k];
        NodeForces          forces = node_forces(node,
                                        problem.bounded_entries[k],
                                        contact_status::is_closed(status[k]),
                                        solution,
                                        residual);
        const double        bound  = node.law.bound(forces.normal);
        all += bound;
        if (slipped == slipping.end() || *slipped != k)
          continue;
        forces.tangential = slip.forces()[slipped++ - slipping.begin()];
        if (may_turn_round(node.law, forces, stiffness[k]))
          turning += bound;
      }
    const double more = turning - most_that_turns * all;
    return dealii::Utilities::MPI::sum(more, solution.get_mpi_communicator()) <= 0.;
  }


  unsigned int FrictionalNewton::update(const ConstrainedProblem &problem,
                                        ActiveSet                &status,
                                        const Vector             &solution,
                                        const Vector             &residual) const
  {
    unsigned int n_changes = 0;
    auto         slipped   = slipping.begin();
    const bool   may_turn  = turns_at_once && few_turn_round(problem, status, solution, residual);
    for (std::size_t k = 0; k < status.size(); ++k)
      {
        const unsigned int  i      = problem.bounded_entries[k];
        const FrictionNode &node   = problem.friction[k];
        const char          old    = status[k];
        const double        beyond = solution.local_element(i) - problem.upper_bounds[k];
        const bool          was    = contact_status::is_closed(old);
        const bool          closed =
          was ? residual.local_element(i) >= 0. : beyond > problem.bound_tolerance;
        status[k] = closed ? contact_status::slip : contact_status::open;
        if (node.law.any() && !node.entries.empty())
          {
            NodeForces  forces = node_forces(node, i, closed && was, solution, residual);
            SlipHistory history;
            history.has_stuck   = was == closed && contact_status::sticks(old);
            history.has_slipped = slipped != slipping.end() && *slipped == k;
            if (history.has_slipped)
              {
                forces.tangential = slip.forces()[slipped++ - slipping.begin()];
                if (was && !closed)
                  forces.tangential =
                    TangentVector::Zero(); // under tension the linearised law points backwards
              }
            if (closed && !was)
              forces = {stiffness[k] * beyond,
                        TangentVector::Zero(),
                        forces.slip}; // about what will hold it
            history.stops_first = !(may_turn && may_turn_round(node.law, forces, stiffness[k]));
            if (!node.slides && sticks(node.law, forces, stiffness[k], history))
              status[k] = closed ? contact_status::stick : contact_status::hang;
          }
        n_changes += (status[k] != old);
      }
    return dealii::Utilities::MPI::sum(n_changes, solution.get_mpi_communicator());
  }


  void FrictionalNewton::hold(const ConstrainedProblem &problem,
                              const ActiveSet          &status,
                              Vector                   &solution,
                              Vector                   &residual)
  {
    correction                 = solution;
    const unsigned int n_moved = move_to_values(problem, status, solution);
    if (dealii::Utilities::MPI::sum(n_moved, solution.get_mpi_communicator()) == 0)
      return; // entries were only released: the solution is as it was
    correction.sadd(-1., 1., solution);
    product.reinit(solution, true);
    problem.matrix.vmult(product, correction);
    residual -= product;
  }


  void FrictionalNewton::set_mask(const ConstrainedProblem &problem, const ActiveSet &status)
  {
    Mask mask(problem.right_hand_side.locally_owned_size(), 0);
    for (const unsigned int j : problem.fixed_entries)
      mask[j] = 1;
    for (std::size_t k = 0; k < status.size(); ++k)
      {
        if (contact_status::is_closed(status[k]))
          mask[problem.bounded_entries[k]] = 1;
        if (contact_status::sticks(status[k]))
          for (const unsigned int i : problem.friction[k].entries)
            mask[i] = 1;
      }
    problem.preconditioner.set_mask(mask);
  }


  void FrictionalNewton::linearise(const ConstrainedProblem &problem,
                                   const ActiveSet          &status,
                                   const Vector             &solution,
                                   const Vector             &residual)
  {
    set_mask(problem, status);
    slip.clear();
    slipping.clear();
    for (std::size_t k = 0; k < status.size(); ++k)
      if (!contact_status::sticks(status[k]) && !problem.friction[k].entries.empty())
        {
          const FrictionNode &node = problem.friction[k];
          const unsigned int  i    = problem.bounded_entries[k];
          const NodeForces    forces =
            node_forces(node, i, contact_status::is_closed(status[k]), solution, residual);
          if (node.law.bound(forces.normal) > 0.)
            {
              slip.add(i,
                       node,
                       linearise_slip(node.law, forces, stiffness[k], node.entries.size()),
                       stiffness[k]);
              slipping.push_back(k);
            }
        }
    slip.finish(solution.get_mpi_communicator());
  }


  LinearReport FrictionalNewton::step(const ConstrainedProblem &problem,
                                      Vector                   &solution,
                                      Vector                   &residual,
                                      const Precision           precision,
                                      const double              last_norm,
                                      const bool                is_guess)
  {
    if (!slip.any())
      return conjugate_gradients.solve(problem.matrix,
                                       problem.preconditioner,
                                       solution,
                                       residual,
                                       tolerance,
                                       precision == Precision::rough ? rough_reduction : 0.,
                                       limits.maximum_linear_iterations,
                                       is_guess);
    const auto limits_for = [&](const double norm) {
      double reduction = problem.is_rough ? reduction_of_trial : rough_reduction;
      if (precision == Precision::settled && slip.any_turning() && last_norm > 0.)
        reduction = std::min(
          reduction, norm * norm / (last_norm * last_norm)); // what Newton's method may hope for
      else if (precision != Precision::rough)
        reduction = 0.;
      return SolverLimits{tolerance, reduction, limits.maximum_linear_iterations, false};
    };
    const auto report = slip.solve(problem, residual, correction, limits_for);
    solution += correction;
    return report;
  }
} // namespace signorini
