// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/goals/stress_error.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  void StressError<dim>::see(const StressOfInterest<dim>  &stress,
                             const Mesh<dim>              &mesh,
                             const StepRecord             &step,
                             const ContactZones<dim>      &zones,
                             const dealii::Vector<double> &squares,
                             const unsigned int            maximum_level,
                             dealii::Vector<double>       &relative_squares)
  {
    const State &state = step.end;
    history.begin(state.time, step.step_size);
    stress_name = stress.name();

    const auto   calibration = stress.calibration();
    const double size        = std::sqrt(stress.squared_size(state));
    const double scale       = std::max(size, std::sqrt(stress.usual_squared_size(state)));
    const dealii::Vector<double> errors = stress.squared_errors(state, zones, squares);
    largest                             = std::max(largest, scale);
    double whole = 0., at_limit = 0.;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          const double error = errors(cell->active_cell_index());
          whole += error;
          if (static_cast<unsigned int>(cell->level()) >= maximum_level)
            at_limit += error;
        }
    for (double *sum : {&whole, &at_limit})
      *sum = dealii::Utilities::MPI::sum(*sum, mesh.communicator());
    if (scale == 0.)
      return;
    const double error =
      scale * calibration.factor * std::pow(std::sqrt(whole) / scale, calibration.power);
    history.sums.stress += history.length() * std::pow(scale, 2);
    history.sums.error += history.length() * std::pow(error, 2);
    // The estimate whose error is the target in units of the largest stress so far.
    const double of_target =
      scale * std::pow(target * largest / (calibration.factor * scale), 1. / calibration.power);
    relative_squares.add(1. / std::max(std::pow(of_target, 2), 2. * at_limit), errors);
  }


  template <int dim>
  double StressError<dim>::relative_error() const
  {
    return has_seen_stress() ? std::sqrt(history.sums.error / history.sums.stress) : 0.;
  }


  template class StressError<2>;
  template class StressError<3>;
} // namespace signorini
