// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_indicator_distribution_h
#define signorini_adaptivity_indicator_distribution_h

#include <deal.II/distributed/tria.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace signorini
{
  /**
   * How the squared indicators are distributed over the cells of all processes, as a histogram of
   * sixteenths of octaves below the largest one. It answers with one reduction what thresholds do,
   * and cells whose indicators differ by round-off only stand in the same bin, so that symmetric
   * motions keep symmetric meshes on any number of processes.
   */
  class IndicatorDistribution
  {
  public:
    /**
     * Collective.
     * @param squares eta_T^2 by active_cell_index
     * @param counts  which cells count in threshold_of_number()
     */
    template <int dim>
    IndicatorDistribution(const dealii::parallel::distributed::Triangulation<dim> &triangulation,
                          const dealii::Vector<double>                            &squares,
                          const std::vector<bool>                                 &counts);

    double       total() const { return sum; }
    unsigned int n_cells() const { return n; }

    /**
     * The largest threshold such that cells with squares >= it make at least this part of the
     * total; infinity if the part or the total is zero.
     */
    double threshold_of_part(double part) const;

    /**
     * The largest threshold such that cells with squares < it make at most this part of the total;
     * zero if the total is.
     */
    double threshold_of_rest(double part) const;

    /** The smallest threshold such that at most so many of the cells that count have squares >= it.
     */
    double threshold_of_number(double number) const;

  private:
    double              largest = 0., sum = 0.;
    unsigned int        n = 0;
    std::vector<double> sums, numbers; ///< by bin

    /** The lower end of a bin. */
    double lower_end(unsigned int bin) const;
  };
} // namespace signorini

#endif
