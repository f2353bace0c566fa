// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/linear_algebra/lanes.h>

namespace signorini
{
  namespace
  {
    /**
     * y += (A + weight M) x, with a weight per row, in one pass over the upper triangle: each block
     * acts once as it is and once transposed. What is wanted is known at compile time, so that a
     * missing matrix is not even read.
     *
     * The blocks of a row of A add up to zero, as a translation has no stress. So A acts on
     * differences of displacements, and its diagonal blocks are not needed: a body that has moved
     * far has forces with the round-off of its strains, not of its way.
     *
     * @param moved per local node whether x is not zero there, if few nodes are: blocks that act on
     *              zeros are not read
     * @return number of blocks that were read
     */
    template <int dim, bool with_mass, bool with_stiffness, bool is_sparse, typename Weight>
    std::size_t multiply(const ElasticMatrices<dim> &matrices,
                         const double               *mass,
                         const Weight               &weight_of,
                         const std::vector<char>    &moved,
                         const double               *x,
                         double                     *y)
    {
      const NodePattern &pattern = matrices.pattern;
      std::size_t        n_read  = is_sparse ? 0 : pattern.row_start[pattern.n_owned];
      for (unsigned int row = 0; row < pattern.n_owned; ++row)
        {
          if (pattern.is_empty(row))
            continue;
          const double        mass_weight = weight_of(row);
          const Lanes<double> x_row       = load(x + 4 * row);
          Lanes<double>       sum         = load(y + 4 * row);
          for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
            {
              const unsigned int column = pattern.columns[k];
              if constexpr (is_sparse)
                {
                  if (!moved[row] && !moved[column])
                    continue;
                  ++n_read;
                }
              const Lanes<double> x_column = load(x + 4 * column);
              if constexpr (with_stiffness)
                prefetch(matrices.stiffness[k].data());
              if constexpr (with_mass)
                sum += mass_weight * mass[k] * x_column;
              if (column == row)
                continue;
              const Lanes<double> difference = x_column - x_row;
              if constexpr (with_stiffness)
                sum += block_product<dim, double>(matrices.stiffness[k].data(), difference);
              if (column >= pattern.n_owned)
                continue;
              Lanes<double> mirrored = load(y + 4 * column);
              if constexpr (with_stiffness)
                mirrored -= block_transposed_product<dim>(matrices.stiffness[k].data(), difference);
              if constexpr (with_mass)
                mirrored += mass_weight * mass[k] * x_row;
              std::memcpy(y + 4 * column, &mirrored, sizeof(mirrored));
            }
          std::memcpy(y + 4 * row, &sum, sizeof(sum));
        }
      return n_read;
    }


    /** Of the nodes of a process; where fewer are moved a product looks which blocks it needs. */
    constexpr double few = 0.5;
  } // namespace


  template <int dim>
  void
  ElasticMatrices<dim>::apply(Vector &destination, const Vector &source, const MatrixSum &sum) const
  {
    apply_with(mass, destination, source, sum);
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_with(const std::vector<double> &mass_values,
                                        Vector                    &destination,
                                        const Vector              &source,
                                        const MatrixSum           &sum) const
  {
    AssertDimension(source.locally_owned_size(), dim * pattern.n_owned);
    AssertDimension(destination.locally_owned_size(), dim * pattern.n_owned);
    AssertDimension(mass_values.size(), pattern.columns.size());
    Assert(&destination != &source,
           dealii::ExcMessage("The result must not overwrite its source."));
    AssertIsFinite(sum.mass);
    AssertIsFinite(sum.stiffness);
    Assert(sum.stiffness > 0. || sum.damping == 0.,
           dealii::ExcMessage("Without A, C has a function of its own."));
    const bool had_ghosts = source.has_ghost_elements();
    if (!had_ghosts)
      source.update_ghost_values();
    padded_source.resize(4 * pattern.n_local);
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        padded_source[4 * node + c] = source.local_element(dim * node + c);
    find_moved_nodes();
    if (!had_ghosts)
      source.zero_out_ghost_values();
    padded_destination.assign(4 * pattern.n_owned, 0.);

    multiply_padded(mass_values, sum);

    destination.zero_out_ghost_values();
    const double factor = sum.stiffness == 0. ? sum.mass : sum.stiffness;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      {
        const double scale = is_damped(sum) ? at_node(node, sum).stiffness : factor;
        for (unsigned int c = 0; c < dim; ++c)
          destination.local_element(dim * node + c) = scale * padded_destination[4 * node + c];
      }
  }


  template <int dim>
  void ElasticMatrices<dim>::find_moved_nodes() const
  {
    unsigned int n_moved = 0;
    moved.resize(pattern.n_local);
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      {
        const double *x        = padded_source.data() + 4 * node;
        n_moved += moved[node] = (x[0] != 0. || x[1] != 0. || (dim == 3 && x[2] != 0.));
      }
    if (n_moved > few * pattern.n_local)
      moved.clear();
  }


  template <int dim>
  void ElasticMatrices<dim>::multiply_padded(const std::vector<double> &mass_values,
                                             const MatrixSum           &sum) const
  {
    const std::true_type  yes;
    const std::false_type no;
    const auto            run = [&](auto          with_mass,
                         auto          with_stiffness,
                         const auto   &weight_of,
                         unsigned long ProductCount::*kind) {
      const auto multiply_with = [&](auto is_sparse) {
        return multiply<dim, with_mass, with_stiffness, is_sparse>(*this,
                                                                   mass_values.data(),
                                                                   weight_of,
                                                                   moved,
                                                                   padded_source.data(),
                                                                   padded_destination.data());
      };
      // Blocks that are read make up products.
      n_read.*kind += moved.empty() ? multiply_with(no) : multiply_with(yes);
      if (const std::size_t all = pattern.row_start[pattern.n_owned]; n_read.*kind >= all)
        {
          n_read.*kind -= all;
          ++(count.*kind);
        }
    };
    if (sum.stiffness == 0.)
      run(
        yes, no, [](unsigned int) { return 1.; }, &ProductCount::mass);
    else if (is_damped(sum))
      run(
        yes,
        yes,
        [&](const unsigned int row) {
          const MatrixSum here = at_node(row, sum);
          return here.mass / here.stiffness;
        },
        &ProductCount::combined);
    else if (sum.mass == 0.)
      run(
        no, yes, [](unsigned int) { return 0.; }, &ProductCount::stiffness);
    else
      run(
        yes,
        yes,
        [weight = sum.mass / sum.stiffness](unsigned int) { return weight; },
        &ProductCount::combined);
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_mass(Vector &destination, const Vector &source) const
  {
    apply(destination, source, {1., 0.});
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_standard_mass(Vector &destination, const Vector &source) const
  {
    apply_with(standard_mass.empty() ? mass : standard_mass, destination, source, {1., 0.});
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_stiffness(Vector &destination, const Vector &source) const
  {
    apply(destination, source, {0., 1.});
  }


  template <int dim>
  void ElasticMatrices<dim>::apply_damping(Vector &destination, const Vector &source) const
  {
    Vector of_mass(source);
    apply_mass(of_mass, source);
    apply_stiffness(destination, source);
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      {
        const RayleighDamping here = damping.empty() ? RayleighDamping() : damping[node];
        for (unsigned int i = dim * node; i < dim * (node + 1); ++i)
          destination.local_element(i) =
            here.mass * of_mass.local_element(i) + here.stiffness * destination.local_element(i);
      }
  }


  template <int dim>
  typename ElasticMatrices<dim>::Block
  ElasticMatrices<dim>::combined_block(const unsigned int node,
                                       const unsigned int position,
                                       const MatrixSum   &sum) const
  {
    AssertIndexRange(position, mass.size());
    const MatrixSum here  = at_node(node, sum);
    Block           block = stiffness[position];
    for (double &entry : block)
      entry *= here.stiffness;
    for (unsigned int c = 0; c < dim; ++c)
      block[dim * c + c] += here.mass * mass[position];
    return block;
  }


  template <int dim>
  void ElasticMatrices<dim>::lump_mass()
  {
    Vector ones(pattern.partitioner), sums(pattern.partitioner);
    ones = 1.;
    apply(sums, ones, {1., 0.});
    sums.update_ghost_values();
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
        mass[k] = pattern.columns[k] == node ? sums.local_element(dim * node) : 0.;
  }


  template class ElasticMatrices<2>;
  template class ElasticMatrices<3>;
} // namespace signorini
