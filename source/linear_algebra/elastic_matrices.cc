// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/linear_algebra/lanes.h>

namespace signorini
{
  namespace
  {
    /**
     * y += (A + mass_weight M) x in one pass over the upper triangle: each block acts once as it is
     * and once transposed. What is wanted is known at compile time, so that a missing matrix is not
     * even read.
     */
    template <int dim, bool with_mass, bool with_stiffness>
    void multiply(const ElasticMatrices<dim> &matrices,
                  const double               *mass,
                  const double                mass_weight,
                  const double               *x,
                  double                     *y)
    {
      const NodePattern &pattern = matrices.pattern;
      for (unsigned int row = 0; row < pattern.n_owned; ++row)
        {
          if (pattern.is_empty(row))
            continue;
          const Lanes<double> x_row = load(x + 4 * row);
          Lanes<double>       sum   = load(y + 4 * row);
          for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
            {
              const unsigned int column = pattern.columns[k];
              if constexpr (with_stiffness)
                sum += block_product<dim>(matrices.stiffness[k].data(), x + 4 * column);
              if constexpr (with_mass)
                sum += mass_weight * mass[k] * load(x + 4 * column);
              if (column == row || column >= pattern.n_owned)
                continue;
              Lanes<double> mirrored = load(y + 4 * column);
              if constexpr (with_stiffness)
                mirrored +=
                  block_transposed_product<dim, double>(matrices.stiffness[k].data(), x_row);
              if constexpr (with_mass)
                mirrored += mass_weight * mass[k] * x_row;
              std::memcpy(y + 4 * column, &mirrored, sizeof(mirrored));
            }
          std::memcpy(y + 4 * row, &sum, sizeof(sum));
        }
    }
  } // namespace


  template <int dim>
  void ElasticMatrices<dim>::apply(Vector       &destination,
                                   const Vector &source,
                                   const double  mass_factor,
                                   const double  stiffness_factor) const
  {
    apply_with(mass, destination, source, mass_factor, stiffness_factor);
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_with(const std::vector<double> &mass_values,
                                        Vector                    &destination,
                                        const Vector              &source,
                                        const double               mass_factor,
                                        const double               stiffness_factor) const
  {
    AssertDimension(source.locally_owned_size(), dim * pattern.n_owned);
    AssertDimension(destination.locally_owned_size(), dim * pattern.n_owned);
    AssertDimension(mass_values.size(), pattern.columns.size());
    Assert(&destination != &source,
           dealii::ExcMessage("The result must not overwrite its source."));
    AssertIsFinite(mass_factor);
    AssertIsFinite(stiffness_factor);
    const bool had_ghosts = source.has_ghost_elements();
    if (!had_ghosts)
      source.update_ghost_values();
    padded_source.resize(4 * pattern.n_local);
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        padded_source[4 * node + c] = source.local_element(dim * node + c);
    if (!had_ghosts)
      source.zero_out_ghost_values();
    padded_destination.assign(4 * pattern.n_owned, 0.);

    double factor = stiffness_factor;
    if (stiffness_factor == 0.)
      {
        multiply<dim, true, false>(
          *this, mass_values.data(), 1., padded_source.data(), padded_destination.data());
        factor = mass_factor;
        ++count.mass;
      }
    else if (mass_factor == 0.)
      {
        multiply<dim, false, true>(
          *this, mass_values.data(), 0., padded_source.data(), padded_destination.data());
        ++count.stiffness;
      }
    else
      {
        const double mass_weight = mass_factor / stiffness_factor;
        multiply<dim, true, true>(
          *this, mass_values.data(), mass_weight, padded_source.data(), padded_destination.data());
        ++count.combined;
      }

    destination.zero_out_ghost_values();
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        destination.local_element(dim * node + c) = factor * padded_destination[4 * node + c];
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_mass(Vector &destination, const Vector &source) const
  {
    apply(destination, source, 1., 0.);
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_standard_mass(Vector &destination, const Vector &source) const
  {
    apply_with(standard_mass.empty() ? mass : standard_mass, destination, source, 1., 0.);
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
    AssertIndexRange(position, mass.size());
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
