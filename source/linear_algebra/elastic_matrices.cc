// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/linear_algebra/lanes.h>

namespace signorini
{
  namespace
  {
    /** One pass over the rows; the factors are compile-time flags so that a missing matrix is not even read. */
    template <int dim, bool with_mass, bool with_stiffness>
    void multiply(const ElasticMatrices<dim> &matrices,
                  double                     *destination,
                  const double               *source,
                  const double                mass_factor,
                  const double                stiffness_factor)
    {
      const unsigned int *columns = matrices.pattern.columns.data();
      for (unsigned int row = 0; row < matrices.pattern.n_owned; ++row)
        {
          Lanes<double>      elastic{}, inertial{};
          const unsigned int end = matrices.pattern.row_start[row + 1];
          for (unsigned int k = matrices.pattern.row_start[row]; k < end; ++k)
            {
              const double *x = source + dim * columns[k];
              if constexpr (with_stiffness)
                elastic += block_product<dim>(matrices.stiffness[k].data(), x);
              if constexpr (with_mass) // the source ends with its last number, hence no load()
                inertial += matrices.mass[k] * Lanes<double>{x[0], x[1], dim == 3 ? x[dim - 1] : 0., 0.};
            }
          for (unsigned int c = 0; c < dim; ++c)
            destination[dim * row + c] = mass_factor * inertial[c] + stiffness_factor * elastic[c];
        }
    }
  } // namespace


  template <int dim>
  void ElasticMatrices<dim>::apply(Vector       &destination,
                                   const Vector &source,
                                   const double  mass_factor,
                                   const double  stiffness_factor) const
  {
    const bool had_ghosts = source.has_ghost_elements();
    if (!had_ghosts)
      source.update_ghost_values();
    destination.zero_out_ghost_values();
    if (stiffness_factor == 0.)
      {
        multiply<dim, true, false>(*this, destination.begin(), source.begin(), mass_factor, 0.);
        ++count.mass;
      }
    else if (mass_factor == 0.)
      {
        multiply<dim, false, true>(*this, destination.begin(), source.begin(), 0., stiffness_factor);
        ++count.stiffness;
      }
    else
      {
        multiply<dim, true, true>(*this, destination.begin(), source.begin(), mass_factor, stiffness_factor);
        ++count.combined;
      }
    if (!had_ghosts)
      source.zero_out_ghost_values();
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_mass(Vector &destination, const Vector &source) const
  {
    apply(destination, source, 1., 0.);
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_stiffness(Vector &destination, const Vector &source) const
  {
    apply(destination, source, 0., 1.);
  }


  template <int dim>
  typename ElasticMatrices<dim>::Block
  ElasticMatrices<dim>::combined_block(const unsigned int position,
                                       const double       mass_factor,
                                       const double       stiffness_factor) const
  {
    Block block = stiffness[position];
    for (double &entry : block)
      entry *= stiffness_factor;
    for (unsigned int c = 0; c < dim; ++c)
      block[dim * c + c] += mass_factor * mass[position];
    return block;
  }


  template <int dim>
  void ElasticMatrices<dim>::lump_mass()
  {
    Vector ones(pattern.partitioner), sums(pattern.partitioner);
    ones = 1.;
    apply(sums, ones, 1., 0.);
    sums.update_ghost_values();
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
        mass[k] = pattern.columns[k] == node ? sums.local_element(dim * node) : 0.;
  }


  template class ElasticMatrices<2>;
  template class ElasticMatrices<3>;
} // namespace signorini
