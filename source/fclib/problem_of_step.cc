// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/fclib/problem_of_step.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    using Triplets = std::vector<Eigen::Triplet<double>>;

    /** Cartesian entries: which number they have in v, and what the others are known to be. */
    class Unknowns
    {
    public:
      static constexpr int none = -1;

      template <int dim>
      Unknowns(const NodePattern             &pattern,
               const ContactCoordinates<dim> &coordinates,
               const Vector                  &velocity)
        : velocity(velocity)
        , numbers(dim * pattern.n_owned, 0)
      {
        for (unsigned int node = 0; node < pattern.n_owned; ++node)
          if (pattern.is_empty(node)) // hanging
            std::fill_n(numbers.begin() + dim * node, dim, none);
        for (const unsigned int entry : coordinates.dirichlet_entries())
          numbers[along_axis<dim>(coordinates.node_frames().at(entry / dim), entry)] = none;
        for (int &number : numbers)
          if (number != none)
            number = n++;
      }

      int size() const { return n; }

      int number(const unsigned int entry) const { return numbers[entry]; }

      double value(const unsigned int entry) const { return velocity.local_element(entry); }

      Eigen::VectorXd of(const Vector &vector, const double factor) const
      {
        Eigen::VectorXd result(n);
        for (unsigned int entry = 0; entry < numbers.size(); ++entry)
          if (numbers[entry] != none)
            result[numbers[entry]] = factor * vector.local_element(entry);
        return result;
      }

    private:
      const Vector    &velocity;
      std::vector<int> numbers;
      int              n = 0;

      /** A prescribed entry of a frame is along an axis: the entry of the node for that one. */
      template <int dim>
      static unsigned int along_axis(const std::array<double, dim * dim> &frame,
                                     const unsigned int                   entry)
      {
        const unsigned int node = entry / dim, row = entry % dim;
        unsigned int       axis = 0;
        for (unsigned int c = 1; c < dim; ++c)
          if (std::abs(frame[dim * row + c]) > std::abs(frame[dim * row + axis]))
            axis = c;
        return dim * node + axis;
      }
    };


    FrictionalProblem::Matrix matrix(const int rows, const int columns, const Triplets &entries)
    {
      FrictionalProblem::Matrix result(rows, columns);
      result.setFromTriplets(entries.begin(), entries.end());
      return result;
    }


    /** M; what prescribed entries do to the others goes from the right-hand side. */
    template <int dim>
    FrictionalProblem::Matrix step_matrix(const ElasticMatrices<dim> &matrices,
                                          const MatrixSum            &sum,
                                          const Unknowns             &unknowns,
                                          Eigen::VectorXd            &right_hand_side)
    {
      const NodePattern &pattern = matrices.pattern;
      Triplets           entries;
      entries.reserve(2 * dim * dim * pattern.columns.size());
      const auto add =
        [&](const unsigned int row_entry, const unsigned int column_entry, const double value) {
          const int row = unknowns.number(row_entry), column = unknowns.number(column_entry);
          if (row == Unknowns::none)
            return;
          if (column != Unknowns::none)
            entries.emplace_back(row, column, value);
          else
            right_hand_side[row] -= value * unknowns.value(column_entry);
        };
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          {
            const unsigned int other = pattern.columns[k];
            const auto         block = matrices.combined_block(node, k, sum);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                {
                  add(dim * node + c, dim * other + d, block[dim * d + c]);
                  if (other != node)
                    add(dim * other + d, dim * node + c, block[dim * d + c]);
                }
          }
      return matrix(unknowns.size(), unknowns.size(), entries);
    }


    /** The contacts of a problem, one after the other. */
    template <int dim>
    class Contacts
    {
    public:
      Contacts(const Unknowns &unknowns, const double step_size)
        : unknowns(unknowns)
        , step_size(step_size)
      {
      }

      /**
       * @param tangents entries with friction
       * @param drag     motion of the obstacle along them, in contact coordinates; empty: none
       * @param bound    of the normal entry
       * @param friction reaction, in contact coordinates; empty: none
       */
      void add(const ContactNode<dim>          &node,
               const std::vector<unsigned int> &tangents,
               const Vector                    &drag,
               const double                     bound,
               const double                     normal_reaction,
               const Vector                    &friction)
      {
        const bool has_friction = !tangents.empty() && node.friction.coefficient > 0.;
        mu.push_back(has_friction ? node.friction.coefficient : 0.);
        add_component(node, node.row, bound);
        r.push_back(-normal_reaction / step_size);
        for (unsigned int row = 0; row < dim; ++row)
          {
            if (row == node.row)
              continue;
            const unsigned int entry = dim * node.node + row;
            const bool         acts =
              has_friction && std::find(tangents.begin(), tangents.end(), entry) != tangents.end();
            r.push_back(acts ? -friction.local_element(entry) / step_size : 0.);
            if (acts || !has_friction)
              add_component(node, row, acts && drag.size() > 0 ? drag.local_element(entry) : 0.);
            else
              w.push_back(0.);
          }
      }

      void give(FrictionalProblem &problem) const
      {
        const auto all = [](const std::vector<double> &values) {
          return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
        };
        problem.dim = dim;
        problem.H   = matrix(unknowns.size(), w.size(), entries);
        problem.w   = all(w);
        problem.mu  = all(mu);
        problem.r   = all(r);
      }

    private:
      const Unknowns     &unknowns;
      const double        step_size;
      Triplets            entries;
      std::vector<double> w, mu, r;

      /** u = (from - what the node moves along a row of its frame) / step size. */
      void add_component(const ContactNode<dim> &node, const unsigned int row, const double from)
      {
        const int column = w.size();
        w.push_back(from / step_size);
        const auto subtract = [&](const unsigned int moved_node, const double weight) {
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double       value = -weight * node.frame[dim * row + c];
              const unsigned int entry = dim * moved_node + c;
              if (unknowns.number(entry) != Unknowns::none)
                entries.emplace_back(unknowns.number(entry), column, value);
              else
                w[column] += value * unknowns.value(entry);
            }
        };
        subtract(node.node, 1.);
        if (node.relative[row])
          for (const auto &[partner, weight] : node.partners)
            subtract(partner, -weight);
      }
    };
  } // namespace


  template <int dim>
  FrictionalProblem problem_of_step(const Discretization<dim>     &discretization,
                                    const ContactCoordinates<dim> &coordinates,
                                    const IncrementProblem        &problem,
                                    const IncrementSolution       &solution,
                                    const Vector                  *obstacle_motion)
  {
    AssertDimension(dealii::Utilities::MPI::n_mpi_processes(discretization.communicator()), 1U);
    Assert(problem.further_reaction == nullptr,
           dealii::ExcMessage("FCLIB's friction belongs to the normal forces of its problem."));
    const ElasticMatrices<dim> &matrices = discretization.matrices();
    const double                tau      = problem.step_size;
    Vector                      velocity = solution.increment;
    velocity /= tau;
    const Unknowns unknowns(matrices.pattern, coordinates, velocity);

    FrictionalProblem result;
    result.start_time         = problem.start.time;
    result.step_size          = tau;
    result.force_per_reaction = tau / problem.force_factor;
    result.f                  = unknowns.of(problem.right_hand_side, 1. / tau);
    result.M                  = step_matrix(matrices,
                           MatrixSum{1., problem.stiffness_factor, problem.damping_factor},
                           unknowns,
                           result.f);

    Vector friction = solution.friction_reaction, drag;
    if (friction.size() > 0)
      coordinates.force_to_contact(friction);
    if (obstacle_motion != nullptr)
      {
        drag = *obstacle_motion;
        coordinates.displacement_to_contact(drag);
      }
    Contacts<dim> contacts(unknowns, tau);
    for (std::size_t k = 0; k < problem.bounds.size(); ++k)
      if (std::isfinite(problem.bounds[k]))
        contacts.add(coordinates.surface_nodes()[k],
                     coordinates.tangential_entries()[k],
                     drag,
                     problem.bounds[k],
                     solution.normal_reaction[k],
                     friction);
    contacts.give(result);
    result.v = unknowns.of(velocity, 1.);
    result.u = result.H.transpose() * result.v + result.w;
    return result;
  }


  template FrictionalProblem problem_of_step(const Discretization<2> &,
                                             const ContactCoordinates<2> &,
                                             const IncrementProblem &,
                                             const IncrementSolution &,
                                             const Vector *);
  template FrictionalProblem problem_of_step(const Discretization<3> &,
                                             const ContactCoordinates<3> &,
                                             const IncrementProblem &,
                                             const IncrementSolution &,
                                             const Vector *);
} // namespace signorini
