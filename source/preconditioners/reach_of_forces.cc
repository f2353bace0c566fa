// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/reach_of_forces.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini
{
  namespace
  {
    /** (2 - 3^(1/2)) / (1/4) */
    constexpr double decay_over_coupling = 1.0718;


    /** m_ii^(-1/2) per local node. */
    template <int dim>
    std::vector<double> inverse_roots(const ElasticMatrices<dim> &matrices)
    {
      const NodePattern  &pattern = matrices.pattern;
      std::vector<double> result(pattern.n_local, 0.);
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        if (!pattern.is_empty(node))
          if (const double mass = matrices.mass[pattern.row_start[node]]; mass > 0.)
            result[node] = 1. / std::sqrt(mass);
      tell_ghosts<dim>(result, pattern);
      return result;
    }
  } // namespace


  template <int dim>
  std::vector<double> reach_of_forces(const ElasticMatrices<dim>      &matrices,
                                      const std::vector<unsigned int> &origins,
                                      const double                     least)
  {
    const NodePattern        &pattern = matrices.pattern;
    const std::vector<double> roots   = inverse_roots(matrices);
    std::vector<double>       reach(pattern.n_local, 0.);
    for (const unsigned int node : origins)
      reach[node] = 1.;

    bool       any_change = true;
    const auto spread     = [&](const unsigned int node) {
      for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
        {
          unsigned int lower = pattern.columns[k], higher = node;
          if (reach[higher] < reach[lower])
            std::swap(lower, higher);
          if (reach[higher] < least || lower >= pattern.n_owned)
            continue; // ghosts are told by their owners
          const double ratio = roots[node] * roots[pattern.columns[k]] * std::abs(matrices.mass[k]);
          const double arrives = reach[higher] * std::min(1., decay_over_coupling * ratio);
          if (arrives > reach[lower] && arrives >= least)
            {
              reach[lower] = arrives;
              any_change   = true;
            }
        }
    };
    // Forth and back: a way may go on in the order of the nodes or against it.
    const MPI_Comm communicator = pattern.partitioner->get_mpi_communicator();
    while (any_change)
      {
        tell_ghosts<dim>(reach, pattern);
        any_change = false;
        for (unsigned int node = 0; node < pattern.n_owned; ++node)
          spread(node);
        for (unsigned int node = pattern.n_owned; node-- > 0;)
          spread(node);
        any_change =
          dealii::Utilities::MPI::max(static_cast<unsigned int>(any_change), communicator) > 0;
      }
    reach.resize(pattern.n_owned);
    return reach;
  }


  template std::vector<double>
  reach_of_forces(const ElasticMatrices<2> &, const std::vector<unsigned int> &, double);
  template std::vector<double>
  reach_of_forces(const ElasticMatrices<3> &, const std::vector<unsigned int> &, double);
} // namespace signorini
