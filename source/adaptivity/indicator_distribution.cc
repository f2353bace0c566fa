// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/indicator_distribution.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    constexpr unsigned int bins_per_octave = 16, n_bins = 60 * bins_per_octave;
    constexpr double       infinity = std::numeric_limits<double>::infinity();
  } // namespace


  template <int dim>
  IndicatorDistribution::IndicatorDistribution(
    const dealii::parallel::distributed::Triangulation<dim> &triangulation,
    const dealii::Vector<double>                            &squares,
    const std::vector<bool>                                 &counts)
    : n(triangulation.n_global_active_cells())
    , sums(n_bins)
    , numbers(n_bins)
  {
    const MPI_Comm communicator = triangulation.get_communicator();
    for (const double value : squares)
      largest = std::max(largest, value);
    largest = dealii::Utilities::MPI::max(largest, communicator);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (const unsigned int index = cell->active_cell_index();
          cell->is_locally_owned() && squares(index) > 0.)
        {
          // Half a bin away from the largest one: values that agree with it but for round-off share
          // its bin.
          const double       octaves = std::log2(largest / squares(index));
          const unsigned int bin =
            std::min(n_bins - 1., std::floor(std::max(0., bins_per_octave * octaves + 0.5)));
          sums[bin] += squares(index);
          numbers[bin] += counts[index];
        }
    dealii::Utilities::MPI::sum(sums, communicator, sums);
    dealii::Utilities::MPI::sum(numbers, communicator, numbers);
    for (const double value : sums)
      sum += value;
  }


  double IndicatorDistribution::lower_end(const unsigned int bin) const
  {
    return bin + 1 == n_bins ? std::numeric_limits<double>::min()
                             : largest * std::exp2(-(bin + 0.5) / bins_per_octave);
  }


  double IndicatorDistribution::threshold_of_part(const double part) const
  {
    double above = 0.;
    if (part > 0. && sum > 0.)
      for (unsigned int bin = 0; bin < n_bins; ++bin)
        {
          above += sums[bin];
          if (above >= (1. - 1e-12) * part * sum)
            return lower_end(bin);
        }
    return infinity;
  }


  double IndicatorDistribution::threshold_of_rest(const double part) const
  {
    double above = 0.;
    if (sum > 0.)
      for (unsigned int bin = 0; bin < n_bins; ++bin)
        {
          above += sums[bin];
          if (sum - above <= part * sum)
            return lower_end(bin);
        }
    return 0.;
  }


  double IndicatorDistribution::threshold_of_number(const double number) const
  {
    double above = 0.;
    for (unsigned int bin = 0; bin < n_bins; ++bin)
      {
        above += numbers[bin];
        if (above > number)
          return bin == 0 ? infinity : lower_end(bin - 1);
      }
    return 0.;
  }


  template IndicatorDistribution::IndicatorDistribution(
    const dealii::parallel::distributed::Triangulation<2> &,
    const dealii::Vector<double> &,
    const std::vector<bool> &);
  template IndicatorDistribution::IndicatorDistribution(
    const dealii::parallel::distributed::Triangulation<3> &,
    const dealii::Vector<double> &,
    const std::vector<bool> &);
} // namespace signorini
