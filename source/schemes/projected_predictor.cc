// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/projected_predictor.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** Whether a node is left open by more than it moves along its normal. */
    bool is_left_open(const double gap, const double motion, const double touching)
    {
      return gap - motion > std::abs(motion) + touching;
    }
  } // namespace


  ProjectedPredictor project_predictor(DynamicalSystem &system,
                                       const State     &state,
                                       const double     step_size,
                                       const NormalGap &bounds)
  {
    ProjectedPredictor result;
    result.increment = state.velocity;
    result.increment *= step_size;
    result.effort = system.capabilities().projections->project(
      result.increment, bounds, step_size, result.correction, result.mass_correction);
    result.increment += result.correction;
    return result;
  }


  bool lift_bounds_stopped_in_vain(const DynamicalSystem    &system,
                                   const ProjectedPredictor &predictor,
                                   const Vector             &increment,
                                   const NormalGap          &gap,
                                   NormalGap                &bounds)
  {
    if (predictor.effort.n_active == 0)
      return false; // on all processes
    const double    touching = touching_distance(system.length());
    const NormalGap stopped  = system.relative_normal(predictor.increment),
                    moved    = system.relative_normal(increment);
    unsigned int n_lifted    = 0;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (stopped[k] >= bounds[k] - touching && is_left_open(gap[k], moved[k], touching))
        {
          bounds[k] = std::numeric_limits<double>::infinity();
          ++n_lifted;
        }
    return dealii::Utilities::MPI::sum(n_lifted, increment.get_mpi_communicator()) > 0;
  }


  NormalGap lift_bounds(const NormalGap &all_bounds, const std::vector<bool> &lifted)
  {
    AssertDimension(lifted.size(), all_bounds.size());
    NormalGap bounds = all_bounds;
    for (std::size_t k = 0; k < bounds.size(); ++k)
      if (lifted[k])
        bounds[k] = std::numeric_limits<double>::infinity();
    return bounds;
  }


  bool lower_bounds_lifted_in_vain(const DynamicalSystem &system,
                                   const Vector          &increment,
                                   const NormalGap       &gap,
                                   const NormalGap       &all_bounds,
                                   std::vector<bool>     &lifted,
                                   NormalGap             &bounds)
  {
    const double    touching  = touching_distance(system.length());
    const NormalGap moved     = system.relative_normal(increment);
    unsigned int    n_in_vain = 0;
    for (std::size_t k = 0; k < gap.size(); ++k)
      n_in_vain += lifted[k] && !is_left_open(gap[k], moved[k], touching);
    if (dealii::Utilities::MPI::sum(n_in_vain, increment.get_mpi_communicator()) == 0)
      return false;
    lifted.assign(gap.size(), false);
    bounds = all_bounds;
    return true;
  }
} // namespace signorini
