// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/base/contact_status.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_indicator = 4.;

    /**
     * 1 / gap in the first component of contact nodes and of the nodes that move their other side,
     * the largest one counts.
     */
    template <int dim>
    Vector closeness(const Discretization<dim>           &discretization,
                     const std::vector<ContactNode<dim>> &nodes)
    {
      const auto &partitioner = *discretization.matrices().pattern.partitioner;
      std::vector<types::global_dof_index> partners;
      for (const ContactNode<dim> &node : nodes)
        for (const auto &[partner, weight] : node.partners)
          partners.push_back(partner);
      Vector       result(discretization.locally_owned(),
                    entries_of_nodes<dim>(discretization.dof_handler().n_dofs(), partners),
                    discretization.communicator());
      const double smallest = gap_round_off(discretization.mesh().body_size());
      for (const ContactNode<dim> &node : nodes)
        {
          const double value = 1. / std::max(node.gap, smallest);
          const auto   raise = [&](const types::global_dof_index dof) {
            result(dof) = std::max(result(dof), value);
          };
          raise(partitioner.local_to_global(dim * node.node));
          for (const auto &[partner, weight] : node.partners)
            raise(dim * partner);
        }
      result.compress(VectorOperation::max);
      return result;
    }
  } // namespace


  template <int dim>
  DistanceIndicator<dim>::DistanceIndicator(const Discretization<dim>  &discretization,
                                            const ContactSurface<dim>  &surface,
                                            const AdaptivityParameters &parameters,
                                            const double                first_step_size,
                                            const double                least)
    : discretization(discretization)
    , surface(surface)
    , parameters(parameters)
    , first_step_size(first_step_size)
    , least(least)
  {
  }


  template <int dim>
  dealii::Vector<double> DistanceIndicator<dim>::evaluate(const StepRecord &step) const
  {
    // The mesh made now serves the steps until the next change, and one to be sure.
    const double step_size = step.step_size > 0. ? step.step_size : first_step_size;
    const double n_steps =
      parameters.steps_between > 0 ? parameters.steps_between : parameters.longest_wait();
    const double ahead = (n_steps + 1.) * step_size;
    Vector       soon  = step.end.displacement;
    soon.add(ahead, step.end.velocity);
    const auto distance_of = [&](const CellAccessor<dim> &cell) {
      return parameters.distance > 0. ? parameters.distance
                                      : 3. * cell.diameter() / std::sqrt(double(dim));
    };
    double largest_cell = 0.;
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        largest_cell = std::max(largest_cell, distance_of(*cell));
    // Beyond, cells may be coarsened anyway.
    const double reach = Utilities::MPI::max(largest_cell, discretization.communicator()) / least;
    std::vector<ContactNode<dim>> near = surface.near_nodes(step.end.displacement, reach);
    for (const ContactNode<dim> &node : surface.near_nodes_at(step.end.time + ahead, soon, reach))
      near.push_back(node);

    const Vector close = discretization.interpolate_hanging_nodes(closeness(discretization, near));
    dealii::Vector<double> result(discretization.mesh().triangulation().n_active_cells());
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        {
          double largest = 0.;
          for (const unsigned int v : cell->vertex_indices())
            largest = std::max(largest, close(cell->vertex_dof_index(v, 0)));
          result(cell->active_cell_index()) =
            std::min(largest_indicator, distance_of(*cell) * largest);
        }
    return result;
  }


  template class DistanceIndicator<2>;
  template class DistanceIndicator<3>;
} // namespace signorini
