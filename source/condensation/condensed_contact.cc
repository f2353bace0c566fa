// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/condensation/condensed_contact.h>
#include <signorini/variational_inequality/held_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini
{
  namespace
  {
    constexpr unsigned int not_there = dealii::numbers::invalid_unsigned_int;

    /** Nodes that may come into contact next: at least so many. */
    constexpr std::size_t spare_nodes = 16;

    /** Solutions for what the factor has left of the residual by its round-off. */
    constexpr unsigned int most_refinements = 3;

    /** Friction that holds without pressure. */
    bool may_stick_open(const ConstrainedProblem &problem, const std::size_t k)
    {
      return !problem.friction.empty() && problem.friction[k].law.bound(0.) > 0.;
    }

    /**
     * A bound of x'D x / x'K x, D the diagonal of K: from that of M, of which rectangular cells
     * have 2^dim times as much in the diagonal as in the lowest eigenvalue.
     */
    template <int dim>
    double largest_ratio_to_mass(const ElasticMatrices<dim> &matrices, const MatrixSum &sum)
    {
      double largest = 1.;
      for (unsigned int node = 0; node < matrices.pattern.n_owned; ++node)
        if (const unsigned int k = matrices.pattern.row_start[node];
            !matrices.pattern.is_empty(node) && matrices.mass[k] > 0.)
          largest = std::max(largest,
                             matrices.combined_block(node, k, matrices.at_node(node, sum))[0]
                               / (sum.mass * matrices.mass[k]));
      return std::pow(2., dim) * largest;
    }

    void sort_unique(std::vector<unsigned int> &list)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  } // namespace


  template <int dim>
  CondensedContact<dim>::CondensedContact(const ElasticMatrices<dim>        &matrices,
                                          const ContactCoordinates<dim>     &coordinates,
                                          const MatrixSum                   &sum,
                                          std::unique_ptr<ConstrainedSolver> small)
    : matrices(matrices)
    , coordinates(coordinates)
    , sum(sum)
    , small(std::move(small))
    , prescribed(coordinates.prescribed_components())
    , diagonal_over_matrix(largest_ratio_to_mass(matrices, sum))
    , place(matrices.pattern.n_owned, not_there)
    , work(matrices.pattern.partitioner)
  {
  }


  template <int dim>
  SolveReport CondensedContact<dim>::solve(const ConstrainedProblem &problem,
                                           ActiveSet                &active,
                                           Vector                   &solution,
                                           Vector                   &residual)
  {
    check_sizes(problem, active, solution, residual);
    // Steps from the guess: where it is the solution they are zero, without round-off.
    move_to_values(problem, {}, solution);
    compute_residual(problem, solution, residual);
    if (const auto needed = nodes_at_bounds(problem, active, solution); !factor || !has(needed))
      choose_nodes(problem, needed, solution);

    SolveReport report;
    double      error = std::numeric_limits<double>::max();
    for (unsigned int n = 0; n <= most_refinements; ++n)
      {
        Vector next(solution);
        while (true)
          {
            report.add(solve_small(problem, solution, residual, active, next));
            auto needed = nodes_at_bounds(problem, active, next);
            if (has(needed))
              break;
            needed.insert(needed.end(), nodes.begin(), nodes.end()); // they only become more
            choose_nodes(problem, needed, next);
          }
        solution = next;
        move_to_values(problem, active, solution);
        compute_residual(problem, solution, residual);
        const double before = std::exchange(error, error_bound(problem, active, residual));
        if (!std::isfinite(error))
          throw StepError("the system of a step has no finite solution.");
        if (error <= problem.tolerance || error > 0.5 * before)
          break;
      }
    return report;
  }


  template <int dim>
  std::vector<unsigned int>
  CondensedContact<dim>::nodes_at_bounds(const ConstrainedProblem &problem,
                                         const ActiveSet          &active,
                                         const Vector             &solution) const
  {
    std::vector<unsigned int> result;
    for (std::size_t k = 0; k < active.size(); ++k)
      {
        const unsigned int i = problem.bounded_entries[k];
        if (std::isfinite(problem.upper_bounds[k])
            && (active[k] != contact_status::open || may_stick_open(problem, k)
                || solution.local_element(i) > problem.upper_bounds[k] + problem.bound_tolerance))
          result.push_back(i / dim);
      }
    sort_unique(result);
    return result;
  }


  template <int dim>
  double CondensedContact<dim>::error_bound(const ConstrainedProblem &problem,
                                            const ActiveSet          &active,
                                            const Vector             &residual)
  {
    if (diagonal.size() == 0)
      {
        diagonal.reinit(residual);
        problem.matrix.diagonal(diagonal);
      }
    work = residual;
    for (const unsigned int i : problem.fixed_entries)
      work.local_element(i) = 0.;
    for (std::size_t k = 0; k < active.size(); ++k)
      {
        if (contact_status::is_closed(active[k]))
          work.local_element(problem.bounded_entries[k]) = 0.;
        if (!problem.friction.empty())
          for (const unsigned int i : problem.friction[k].entries)
            work.local_element(i) = 0.;
      }
    double square = 0.;
    for (unsigned int i = 0; i < work.locally_owned_size(); ++i)
      square += work.local_element(i) * work.local_element(i) / diagonal.local_element(i);
    return std::sqrt(diagonal_over_matrix * square);
  }


  template <int dim>
  std::vector<unsigned int>
  CondensedContact<dim>::with_partners(std::vector<unsigned int> needed) const
  {
    // Partners may be contact nodes themselves.
    for (unsigned int level = 0; level <= coordinates.coupling().n_levels(); ++level)
      {
        sort_unique(needed);
        std::vector<unsigned int> partners;
        for (const ContactNode<dim> &node : coordinates.surface_nodes())
          if (std::binary_search(needed.begin(), needed.end(), node.node))
            for (const auto &[partner, weight] : node.partners)
              partners.push_back(matrices.pattern.partitioner->global_to_local(dim * partner)
                                 / dim);
        needed.insert(needed.end(), partners.begin(), partners.end());
      }
    sort_unique(needed);
    return needed;
  }


  template <int dim>
  bool CondensedContact<dim>::has(const std::vector<unsigned int> &needed) const
  {
    // What moves the nodes that there are may have changed, too.
    std::vector<unsigned int> all = needed;
    if (coordinates.coupling().changes())
      all.insert(all.end(), nodes.begin(), nodes.end());
    for (const unsigned int node : with_partners(all))
      if (place[node] == not_there)
        return false;
    return true;
  }


  template <int dim>
  void CondensedContact<dim>::choose_nodes(const ConstrainedProblem        &problem,
                                           const std::vector<unsigned int> &needed,
                                           const Vector                    &solution)
  {
    std::vector<unsigned int> chosen = needed;
    sort_unique(chosen);
    std::vector<std::pair<double, unsigned int>> gaps;
    for (std::size_t k = 0; k < problem.bounded_entries.size(); ++k)
      if (const unsigned int i = problem.bounded_entries[k]; std::isfinite(problem.upper_bounds[k]))
        gaps.emplace_back(problem.upper_bounds[k] - solution.local_element(i), i / dim);
    std::sort(gaps.begin(), gaps.end());
    // Needed nodes are among the nearest. A dense matrix of more costs little beside the factor of
    // a large mesh.
    const std::size_t spare = std::max<std::size_t>(spare_nodes, std::sqrt(place.size()) / 4.);
    gaps.resize(std::min(gaps.size(), chosen.size() + spare));
    for (const auto &[gap, node] : gaps)
      chosen.push_back(node);

    nodes = with_partners(std::move(chosen));
    std::fill(place.begin(), place.end(), not_there);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      place[nodes[k]] = k;
    factor = std::make_unique<NodalFactor<dim>>(matrices, sum, prescribed, nodes);
    ++factors_made;
    matrix.reset();
  }


  template <int dim>
  Eigen::SparseMatrix<double> CondensedContact<dim>::contact_to_cartesian()
  {
    const unsigned int                  n = dim * nodes.size();
    std::vector<Eigen::Triplet<double>> triplets;
    work                  = 0.;
    const auto large      = [&](const unsigned int i) { return dim * nodes[i / dim] + i % dim; };
    const auto move_alone = [&](const std::vector<unsigned int> &columns, const auto &column_of) {
      for (const unsigned int column : columns)
        work.local_element(large(column)) = 1.;
      coordinates.displacement_to_cartesian(work);
      for (unsigned int row = 0; row < n; ++row)
        if (const double value = work.local_element(large(row)); value != 0.)
          triplets.emplace_back(row, column_of(row), value);
      for (unsigned int i = 0; i < n; ++i)
        work.local_element(large(i)) = 0.;
      for (const ContactNode<dim> &node : coordinates.surface_nodes()) // they may be carried along
        for (unsigned int c = 0; c < dim; ++c)
          work.local_element(dim * node.node + c) = 0.;
    };
    if (coordinates.coupling().any())
      for (unsigned int column = 0; column < n; ++column)
        move_alone({column}, [&](unsigned int) { return column; });
    else // each node moves itself only: one component of all of them at once
      for (unsigned int c = 0; c < dim; ++c)
        {
          std::vector<unsigned int> columns;
          for (std::size_t k = 0; k < nodes.size(); ++k)
            columns.push_back(dim * k + c);
          move_alone(columns, [&](const unsigned int row) { return row - row % dim + c; });
        }
    Eigen::SparseMatrix<double> result(n, n);
    result.setFromTriplets(triplets.begin(), triplets.end());
    return result;
  }


  template <int dim>
  void CondensedContact<dim>::turn()
  {
    if (matrix && known_turns == coordinates.n_turns())
      return;
    to_cartesian                 = contact_to_cartesian();
    const Eigen::MatrixXd turned = factor->schur_complement() * to_cartesian;
    matrix.emplace(to_cartesian.transpose() * turned);
    known_turns = coordinates.n_turns();
  }


  template <int dim>
  typename CondensedContact<dim>::SmallProblem
  CondensedContact<dim>::small_problem(const ConstrainedProblem &problem,
                                       const Vector             &start,
                                       ActiveSet                &active) const
  {
    SmallProblem result;
    for (std::size_t k = 0; k < active.size(); ++k)
      if (const unsigned int i = problem.bounded_entries[k]; place[i / dim] == not_there)
        active[k] = contact_status::open;
      else
        {
          result.numbers.push_back(k);
          result.statuses.push_back(active[k]);
          result.bounded.push_back(small_entry(i));
          result.bounds.push_back(problem.upper_bounds[k] - start.local_element(i));
          if (!problem.friction.empty())
            result.friction.push_back(small_friction(problem.friction[k], start));
        }
    for (const unsigned int i : problem.fixed_entries)
      if (place[i / dim] != not_there)
        result.fixed.push_back(small_entry(i));
    return result;
  }


  template <int dim>
  SolveReport CondensedContact<dim>::solve_small(const ConstrainedProblem &problem,
                                                 const Vector             &start,
                                                 const Vector             &residual,
                                                 ActiveSet                &active,
                                                 Vector                   &solution)
  {
    turn();
    work = residual;
    coordinates.force_to_cartesian(work);
    const unsigned int    n       = dim * nodes.size();
    const Eigen::VectorXd reduced = to_cartesian.transpose() * factor->condense(work);
    Vector                b(n), x(n), r(n);
    std::copy_n(reduced.data(), n, b.begin());

    SmallProblem              now = small_problem(problem, start, active);
    const std::vector<double> nothing(now.fixed.size(), 0.);
    const SolveReport         report = small->solve({matrix->product,
                                                     matrix->inverse,
                                                     b,
                                                     now.bounded,
                                                     now.bounds,
                                                     now.fixed,
                                                     nothing,
                                                     problem.tolerance,
                                                     problem.bound_tolerance,
                                                     now.friction},
                                            now.statuses,
                                            x,
                                            r);
    for (std::size_t k = 0; k < now.numbers.size(); ++k)
      active[now.numbers[k]] = now.statuses[k];
    factor->expand(to_cartesian * Eigen::Map<const Eigen::VectorXd>(x.begin(), n), solution);
    coordinates.displacement_to_contact(solution);
    solution += start;
    return report;
  }


  template <int dim>
  FrictionNode CondensedContact<dim>::small_friction(FrictionNode node, const Vector &start) const
  {
    for (std::size_t j = 0; j < node.entries.size(); ++j)
      {
        node.past[j] += start.local_element(node.entries[j]);
        node.entries[j] = small_entry(node.entries[j]);
      }
    return node;
  }


  template class CondensedContact<2>;
  template class CondensedContact<3>;
} // namespace signorini
