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
    /**
     * Per node, whether an increment leaves it open by more than it moves along its normal, as seen
     * from what it faces.
     */
    std::vector<bool>
    left_open(DynamicalSystem &system, const Vector &increment, const NormalGap &gap)
    {
      const double    touching = touching_distance(system.length());
      const NormalGap moved    = system.relative_normal(increment),
                      past     = motion_past_obstacles(system, increment);
      std::vector<bool> result(gap.size());
      for (std::size_t k = 0; k < gap.size(); ++k)
        result[k] = gap[k] - moved[k] > std::abs(past[k]) + touching;
      return result;
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


  bool lift_bounds_stopped_in_vain(DynamicalSystem          &system,
                                   const ProjectedPredictor &predictor,
                                   const Vector             &increment,
                                   const NormalGap          &gap,
                                   NormalGap                &bounds)
  {
    if (predictor.effort.n_active == 0)
      return false; // on all processes
    const double            touching = touching_distance(system.length());
    const NormalGap         stopped  = system.relative_normal(predictor.increment);
    const std::vector<bool> is_open  = left_open(system, increment, gap);
    unsigned int            n_lifted = 0;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (stopped[k] >= bounds[k] - touching && is_open[k])
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


  bool lower_bounds_lifted_in_vain(DynamicalSystem   &system,
                                   const Vector      &increment,
                                   const NormalGap   &gap,
                                   const NormalGap   &all_bounds,
                                   std::vector<bool> &lifted,
                                   NormalGap         &bounds)
  {
    const std::vector<bool> is_open   = left_open(system, increment, gap);
    unsigned int            n_in_vain = 0;
    for (std::size_t k = 0; k < gap.size(); ++k)
      n_in_vain += lifted[k] && !is_open[k];
    if (dealii::Utilities::MPI::sum(n_in_vain, increment.get_mpi_communicator()) == 0)
      return false;
    lifted.assign(gap.size(), false);
    bounds = all_bounds;
    return true;
  }
} // namespace signorini
