// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/node_impulses.h>

#include <deal.II/base/mpi.h>
#include <deal.II/sundials/kinsol.h>

#include <cmath>
#include <exception>
#include <limits>
#include <random>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int maximum_iterations = 200, anderson_depth = 8, n_probes = 4;
    // Changes of velocity in an iteration, relative to the largest velocity: aimed at, and good enough where round-off is in the way.
    constexpr double aim = 1e-10, good_enough = 1e-8;

    /** The equations of the nodes with a force, in unknowns without unit. */
    class NodeEquations
    {
    public:
      NodeEquations(DynamicalSystem &system, const NodeContact &contact);

      bool trivial() const { return speed == 0.; }

      /** A vector of unknowns y_p = D_p I_p / speed, zero. */
      Vector make_unknowns() const { return unknowns; }

      /** next = the solutions of the equations of the single nodes. */
      void iterate(const Vector &current, Vector &next) const;

      /** I of all contact nodes. */
      std::vector<double> impulses(const Vector &values) const;

    private:
      DynamicalSystem          &system;
      const NormalGap          &approach;
      std::vector<unsigned int> nodes;      ///< those with a force
      std::vector<double>       work;       ///< Lambda_p gamma_p of each of them
      std::vector<double>       diagonal;   ///< D_p
      double                    speed = 0.; ///< the largest velocity that may appear
      Vector                    unknowns;

      /** G I at all contact nodes. */
      NormalGap response(const std::vector<double> &impulses) const
      {
        return system.relative_normal(system.solve_mass(system.capabilities().impulses->normal_forces(impulses)));
      }

      void estimate_diagonal();
    };


    /** KINSOL's fixed point iteration, watched. */
    class FixedPoint
    {
    public:
      explicit FixedPoint(const NodeEquations &equations)
        : equations(equations)
        , best(equations.make_unknowns())
      {
      }

      /** Go on from the best image so far. */
      void run(unsigned int anderson_depth);

      bool converged() const { return smallest_change <= good_enough; }

      const NodeEquations &equations;
      Vector               best; ///< the image that differs least from its origin; no entry is negative
      double               smallest_change = std::numeric_limits<double>::max();
      unsigned int         n_iterations    = 0;

    private:
      std::exception_ptr exception;

      /** @return whether to go on */
      bool evaluate(const Vector &current, Vector &image);
    };


    bool FixedPoint::evaluate(const Vector &current, Vector &image)
    {
      ++n_iterations;
      equations.iterate(current, image);
      Vector difference = image;
      difference -= current;
      const double change = difference.linfty_norm();
      if (change < smallest_change)
        {
          smallest_change = change;
          best            = image;
        }
      return change > aim && change < 100. * smallest_change;
    }


    void FixedPoint::run(const unsigned int anderson_depth)
    {
      using Solver = SUNDIALS::KINSOL<Vector>;
      Solver::AdditionalData options;
      options.strategy                      = Solver::AdditionalData::fixed_point;
      options.maximum_non_linear_iterations = 2 * maximum_iterations;
      options.function_tolerance            = 0.1 * aim;
      options.anderson_subspace_size        = anderson_depth;
      Vector values                         = best;
      Solver solver(options, values.get_mpi_communicator());
      solver.reinit_vector = [&](Vector &vector) { vector.reinit(values); };

      // An image that is its origin ends the iteration. That way KINSOL never fails, which its wrapper reports by an assertion only,
      // and no exception has to pass through C.
      bool               go_on  = true;
      const unsigned int end    = n_iterations + maximum_iterations;
      solver.iteration_function = [&](const Vector &current, Vector &image) {
        try
          {
            go_on = go_on && n_iterations < end && evaluate(current, image);
          }
        catch (...)
          {
            exception = std::current_exception();
            go_on     = false;
          }
        if (!go_on)
          image = current;
        return 0;
      };
      solver.solve(values);
      if (exception)
        std::rethrow_exception(exception);
    }


    NodeEquations::NodeEquations(DynamicalSystem &system, const NodeContact &contact)
      : system(system)
      , approach(contact.approach)
    {
      for (unsigned int p = 0; p < contact.force.size(); ++p)
        if (contact.force[p] > 0.)
          {
            nodes.push_back(p);
            work.push_back(contact.force[p] * std::max(0., contact.gap[p])); // below zero by round-off
          }
      estimate_diagonal();

      const MPI_Comm communicator = system.make_vector().get_mpi_communicator();
      for (unsigned int k = 0; k < nodes.size(); ++k)
        speed = std::max(speed, std::abs(approach[nodes[k]]) + std::sqrt(2. * diagonal[k] * work[k]));
      speed = Utilities::MPI::max(speed, communicator);

      // KINSOL's operations on vectors want an entry on each process. An idle one stays zero.
      const unsigned int n_owned = std::max<std::size_t>(1, nodes.size());
      const auto         owned   = Utilities::MPI::create_ascending_partitioning(communicator, n_owned);
      unknowns.reinit(owned[Utilities::MPI::this_mpi_process(communicator)], communicator);
    }


    void NodeEquations::estimate_diagonal()
    {
      diagonal.assign(nodes.size(), 0.);
      std::mt19937        random; // the same numbers in each step: a step depends on the state alone
      std::vector<double> signs(approach.size(), 0.);
      for (unsigned int probe = 0; probe < n_probes; ++probe)
        {
          for (const unsigned int p : nodes)
            signs[p] = random() % 2 ? 1. : -1.;
          const NormalGap product = response(signs);
          for (unsigned int k = 0; k < nodes.size(); ++k)
            diagonal[k] += product[nodes[k]] * product[nodes[k]] / n_probes;
        }
      for (double &entry : diagonal)
        entry = std::sqrt(entry);
    }


    std::vector<double> NodeEquations::impulses(const Vector &values) const
    {
      std::vector<double> result(approach.size(), 0.);
      for (unsigned int k = 0; k < nodes.size(); ++k)
        result[nodes[k]] = speed / diagonal[k] * values.local_element(k);
      return result;
    }


    void NodeEquations::iterate(const Vector &current, Vector &next) const
    {
      const NormalGap change = response(impulses(current));
      next                   = 0.;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        {
          const double omega = approach[nodes[k]] - 0.5 * change[nodes[k]] + 0.5 * speed * current.local_element(k);
          const double root  = std::sqrt(omega * omega + 2. * diagonal[k] * work[k]);
          // omega + root without cancellation
          const double sum =
            omega > 0. ? omega + root : (work[k] > 0. ? 2. * diagonal[k] * work[k] / (root - omega) : 0.);
          next.local_element(k) = sum / speed;
        }
    }
  } // namespace


  NodeImpulses solve_node_impulses(DynamicalSystem &system, const NodeContact &contact)
  {
    const NodeEquations equations(system, contact);
    FixedPoint          fixed_point(equations);
    NodeImpulses        result;
    if (!equations.trivial())
      for (const unsigned int depth :
           {anderson_depth, 0U}) // acceleration may lead astray, the plain iteration descends
        if (!fixed_point.converged())
          fixed_point.run(depth);
    result.iterations = fixed_point.n_iterations;
    result.converged  = equations.trivial() || fixed_point.converged();
    result.impulses   = equations.impulses(fixed_point.best);
    return result;
  }
} // namespace signorini
