// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/fixed_point.h>

#include <deal.II/base/mpi.h>
#include <deal.II/sundials/kinsol.h>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  Vector FixedPoint::make_unknowns(const std::size_t n_owned, const MPI_Comm communicator)
  {
    const std::size_t n_entries = std::max<std::size_t>(1, n_owned);
    const auto owned = Utilities::MPI::create_ascending_partitioning(communicator, n_entries);
    Vector     unknowns;
    unknowns.reinit(owned[Utilities::MPI::this_mpi_process(communicator)], communicator);
    return unknowns;
  }


  bool FixedPoint::evaluate(const Vector &current, Vector &image)
  {
    // The accelerated iterate is no number where the differences that it combines are multiples of
    // each other. Maxima would overlook that, the sum over all processes does not.
    if (!std::isfinite(current.l1_norm()))
      return false;
    ++iterations;
    const double difference = function(current, image);
    if (difference < smallest_difference)
      {
        smallest_difference = difference;
        best_image          = image;
      }
    return difference > limits.aim && difference < 100. * smallest_difference;
  }


  void FixedPoint::run(const unsigned int anderson_depth)
  {
    Assert(limits.aim > 0. && limits.good_enough >= limits.aim && limits.maximum_iterations > 0,
           ExcMessage("What is aimed at is good enough, and takes an iteration."));
    const unsigned int end = iterations + limits.maximum_iterations;
    double             before;
    do
      {
        before = smallest_difference;
        run_until_astray(anderson_depth, end);
      }
    while (!converged() && smallest_difference < 0.5 * before && iterations < end);
  }


  void FixedPoint::run_until_astray(const unsigned int anderson_depth, const unsigned int end)
  {
    using Solver = SUNDIALS::KINSOL<Vector>;
    Solver::AdditionalData options;
    options.strategy                      = Solver::AdditionalData::fixed_point;
    options.maximum_non_linear_iterations = 2 * limits.maximum_iterations;
    options.function_tolerance     = std::numeric_limits<double>::min(); // the end is decided here
    options.anderson_subspace_size = anderson_depth;
    Vector values                  = best_image;
    Solver solver(options, values.get_mpi_communicator());
    solver.reinit_vector = [&](Vector &vector) { vector.reinit(values); };

    // An image that is its origin ends the iteration. That way KINSOL never fails, which its
    // wrapper reports by an assertion only, and no exception has to pass through C.
    bool go_on                = true;
    solver.iteration_function = [&](const Vector &current, Vector &image) {
      try
        {
          go_on = go_on && iterations < end && evaluate(current, image);
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
} // namespace signorini
