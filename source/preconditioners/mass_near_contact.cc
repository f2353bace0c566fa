// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/mass_near_contact.h>
#include <signorini/preconditioners/reach_of_forces.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /** How far nodes may move before the neighbourhood follows: two cells, by reach_of_forces(). */
    constexpr double margin = 1. / 16.;
    /** What arrives from many nodes adds up. */
    constexpr double of_many = 1. / 32.;
    /** Of the nodes; a larger neighbourhood saves less than it costs. */
    constexpr double most_nodes = 0.7;
    /** Where less is accepted, nothing is so far away that it does not count. */
    constexpr double least_accuracy = 1e-18;
  } // namespace


  template <int dim>
  MassNearContact<dim>::MassNearContact(const ElasticMatrices<dim>    &matrices,
                                        const ContactCoordinates<dim> &coordinates)
    : matrices(matrices)
    , coordinates(coordinates)
  {
  }


  template <int dim>
  void MassNearContact<dim>::surround(const std::vector<unsigned int> &origins,
                                      const double                     accuracy)
  {
    latest_origins = origins;
    if (is_all)
      return;
    bool is_inside = here != nullptr && of_many * accuracy >= accuracy_here;
    for (const unsigned int node : origins)
      is_inside = is_inside && reach[node] >= margin;
    const MPI_Comm communicator = matrices.pattern.partitioner->get_mpi_communicator();
    if (dealii::Utilities::MPI::min(static_cast<unsigned int>(is_inside), communicator) > 0)
      return;
    origins_here  = origins;
    accuracy_here = margin * of_many * accuracy;
    surround_anew();
  }


  template <int dim>
  void MassNearContact<dim>::widen()
  {
    origins_here = latest_origins;
    accuracy_here *= 0.1;
    surround_anew();
  }


  template <int dim>
  void MassNearContact<dim>::surround_anew()
  {
    ++n_neighbourhoods;
    is_all = coordinates.coupling().any() || !is_small();
    if (is_all)
      {
        here = make_mass_preconditioner(matrices, coordinates);
        return;
      }
    std::vector<char> is_wanted(matrices.pattern.n_owned);
    for (unsigned int node = 0; node < is_wanted.size(); ++node)
      is_wanted[node] = contains(node);
    if (!all)
      all = SweepOrder::of<dim>(matrices.pattern);
    here = make_mass_preconditioner(matrices, coordinates, all->restricted_to(is_wanted));
  }


  template <int dim>
  bool MassNearContact<dim>::is_small()
  {
    if (accuracy_here < least_accuracy)
      return false;
    reach           = reach_of_forces(matrices, origins_here, accuracy_here);
    double n_wanted = 0.;
    for (const double value : reach)
      n_wanted += value >= accuracy_here;
    const auto &partitioner = *matrices.pattern.partitioner;
    return dealii::Utilities::MPI::sum(n_wanted, partitioner.get_mpi_communicator())
           < most_nodes * partitioner.size() / dim;
  }


  template <int dim>
  void MassNearContact<dim>::clear_outside(Vector &correction) const
  {
    for (unsigned int node = 0; node < matrices.pattern.n_owned; ++node)
      if (!contains(node))
        for (unsigned int c = 0; c < dim; ++c)
          correction.local_element(dim * node + c) = 0.;
  }


  template <int dim>
  double MassNearContact<dim>::norm_outside(const Vector &residual) const
  {
    if (is_all)
      return 0.;
    const NodePattern &pattern = matrices.pattern;
    double             square  = 0.;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (!contains(node) && !pattern.is_empty(node))
        {
          double sum = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            sum += residual.local_element(dim * node + c) * residual.local_element(dim * node + c);
          if (sum > 0.)
            square += sum / matrices.mass[pattern.row_start[node]];
        }
    return std::sqrt(
      dealii::Utilities::MPI::sum(square, pattern.partitioner->get_mpi_communicator()));
  }


  template class MassNearContact<2>;
  template class MassNearContact<3>;
} // namespace signorini
