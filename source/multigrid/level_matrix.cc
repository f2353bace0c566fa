// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/level_matrix.h>

namespace signorini
{
  namespace
  {
    /** Of sums over a row of the stiffness, in parts of its diagonal block. */
    constexpr double round_off = 1e-10;

    template <int dim>
    LocalNodes nodes_of(const NodePattern &pattern)
    {
      LocalNodes nodes;
      nodes.n_owned     = pattern.n_owned;
      nodes.first_owned = pattern.partitioner->local_range().first / dim;
      for (unsigned int node = pattern.n_owned; node < pattern.n_local; ++node)
        nodes.ghosts.push_back(pattern.partitioner->local_to_global(dim * node) / dim);
      return nodes;
    }


    /** Numbers of different blocks side by side: eight in single precision, four in double. */
    template <typename Number>
    using SideBySide __attribute__((vector_size(32))) = Number;

    template <typename Number>
    SideBySide<Number> load_side_by_side(const Number *numbers)
    {
      SideBySide<Number> lanes;
      std::memcpy(&lanes, numbers, sizeof(lanes));
      return lanes;
    }

    template <typename Many>
    constexpr bool are_eight = sizeof(Many) / sizeof(std::declval<Many>()[0]) == 8;

    template <typename Many>
    auto sum_of(const Many lanes)
    {
      const auto sum_of_four = [](const auto four) {
        return (four[0] + four[1]) + (four[2] + four[3]);
      };
      if constexpr (are_eight<Many>)
        return sum_of_four(__builtin_shufflevector(lanes, lanes, 0, 1, 2, 3)
                           + __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7));
      else
        return sum_of_four(lanes);
    }

    /** Picks of the lanes of a (0 to 3) and b (4 to 7); of eight lanes in both halves alike. */
    template <int... lanes, typename Many>
    Many pick(const Many a, const Many b)
    {
      if constexpr (are_eight<Many>)
        return __builtin_shufflevector(
          a, b, (lanes < 4 ? lanes : lanes + 4)..., (lanes < 4 ? lanes + 4 : lanes + 8)...);
      else
        return __builtin_shufflevector(a, b, lanes...);
    }

    // Four vectors are transposed as a matrix of two by two pairs, by two picks each.
    template <typename Many>
    Many lower_pairs(const Many a, const Many b)
    {
      return pick<0, 4, 1, 5>(a, b);
    }
    template <typename Many>
    Many upper_pairs(const Many a, const Many b)
    {
      return pick<2, 6, 3, 7>(a, b);
    }
    template <typename Many>
    Many lower_halves(const Many a, const Many b)
    {
      return pick<0, 1, 4, 5>(a, b);
    }
    template <typename Many>
    Many upper_halves(const Many a, const Many b)
    {
      return pick<2, 3, 6, 7>(a, b);
    }


    /** A loop that is unrolled at any level of optimisation. */
    template <int dim, typename Action>
    inline void for_each_component(const Action &action)
    {
      action(std::integral_constant<unsigned int, 0>());
      action(std::integral_constant<unsigned int, 1>());
      if constexpr (dim == 3)
        action(std::integral_constant<unsigned int, 2>());
    }

    /** Component c of all nodes, for each c. */
    template <int dim, typename Number>
    void gather(const Number *x, const unsigned int *nodes, SideBySide<Number> *components)
    {
      using Many      = SideBySide<Number>;
      const auto rows = [&](const unsigned int k) -> Many {
        const Lanes<Number> first = load(x + 4 * nodes[k]);
        if constexpr (are_eight<Many>)
          return __builtin_shufflevector(first, load(x + 4 * nodes[k + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
        else
          return first;
      };
      const Many a = rows(0), b = rows(1), c = rows(2), d = rows(3);
      const Many ab = lower_pairs(a, b), cd = lower_pairs(c, d);
      components[0] = lower_halves(ab, cd);
      components[1] = upper_halves(ab, cd);
      if constexpr (dim == 3)
        components[2] = lower_halves(upper_pairs(a, b), upper_pairs(c, d));
    }


    /** r of all nodes += components; a node may come more than once. */
    template <int dim, typename Number>
    void scatter(const SideBySide<Number> *components, const unsigned int *nodes, Number *r)
    {
      using Many = SideBySide<Number>;
      const Many zero{}, third = dim == 3 ? components[(dim == 3) * 2] : zero;
      const Many low       = lower_pairs(components[0], components[1]),
                 high      = upper_pairs(components[0], components[1]),
                 third_low = lower_pairs(third, zero), third_high = upper_pairs(third, zero);
      const auto add = [&](const unsigned int node, const Lanes<Number> increment) {
        const Lanes<Number> sum = load(r + 4 * node) + increment;
        std::memcpy(r + 4 * node, &sum, sizeof(sum));
      };
      const auto add_rows = [&](const unsigned int k, const Many rows) {
        if constexpr (are_eight<Many>)
          {
            add(nodes[k], __builtin_shufflevector(rows, rows, 0, 1, 2, 3));
            add(nodes[k + 4], __builtin_shufflevector(rows, rows, 4, 5, 6, 7));
          }
        else
          add(nodes[k], rows);
      };
      add_rows(0, lower_halves(low, third_low));
      add_rows(1, upper_halves(low, third_low));
      add_rows(2, lower_halves(high, third_high));
      add_rows(3, upper_halves(high, third_high));
    }
  } // namespace


  template <int dim, typename Number>
  LevelMatrix<dim, Number>::LevelMatrix(const ElasticMatrices<dim> &matrices,
                                        const std::vector<char>    &smoothed,
                                        const MatrixSum            &sum,
                                        const double                scale)
    : nodes(nodes_of<dim>(matrices.pattern))
    , ghosts(nodes, matrices.pattern.partitioner->get_mpi_communicator())
  {
    const NodePattern      &pattern     = matrices.pattern;
    const std::vector<char> with_ghosts = ghosts.with_ghosts(smoothed);
    reserve(pattern, with_ghosts);
    group_start.assign(1, 0);
    diagonal_mass.assign(nodes.n_owned, Number(0));
    diagonal_blocks.assign(nodes.n_owned, Block::Zero());
    for (unsigned int row = 0; row < nodes.n_owned; ++row)
      {
        if (!pattern.is_empty(row))
          {
            add_row(matrices, with_ghosts, matrices.at_node(row, sum), scale, row);
            if (smoothed[row])
              to_smooth.push_back(row);
          }
        group_start.push_back(groups.size());
      }
    find_supports(matrices, sum, scale);
  }


  template <int dim, typename Number>
  void LevelMatrix<dim, Number>::reserve(const NodePattern       &pattern,
                                         const std::vector<char> &smoothed)
  {
    std::size_t n_groups = 0, n_ghost_entries = 0;
    for (unsigned int row = 0; row < nodes.n_owned; ++row)
      {
        std::size_t n_columns = 0;
        for (unsigned int k = pattern.row_start[row] + 1; k < pattern.row_start[row + 1]; ++k)
          if (smoothed[row] || smoothed[pattern.columns[k]])
            ++(pattern.columns[k] < nodes.n_owned ? n_columns : n_ghost_entries);
        n_groups += (n_columns + n_side_by_side - 1) / n_side_by_side;
      }
    groups.reserve(n_groups);
    ghost_entries.reserve(n_ghost_entries);
  }


  template <int dim, typename Number>
  void LevelMatrix<dim, Number>::find_supports(const ElasticMatrices<dim> &matrices,
                                               const MatrixSum            &sum,
                                               const double                scale)
  {
    const NodePattern &pattern = matrices.pattern;
    std::vector<Block> sums(nodes.n_owned, Block::Zero());
    for (unsigned int row = 0; row < nodes.n_owned; ++row)
      for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
        {
          const Eigen::Map<const Block> block(matrices.stiffness[k].data());
          sums[row] += block;
          if (pattern.columns[k] != row && pattern.columns[k] < nodes.n_owned)
            sums[pattern.columns[k]] += block.transpose();
        }
    for (const unsigned int node : to_smooth)
      {
        const Eigen::Map<const Block> own(matrices.stiffness[pattern.row_start[node]].data());
        if (sums[node].norm() <= round_off * own.norm())
          continue;
        const double factor = scale * matrices.at_node(node, sum).stiffness;
        supports.push_back({{}, node});
        for (unsigned int i = 0; i < dim * dim; ++i)
          supports.back().stiffness[i] = factor * sums[node].data()[i];
      }
  }


  template <int dim, typename Number>
  void LevelMatrix<dim, Number>::add_row(const ElasticMatrices<dim> &matrices,
                                         const std::vector<char>    &smoothed,
                                         const MatrixSum            &sum,
                                         const double                scale,
                                         const unsigned int          row)
  {
    const NodePattern &pattern = matrices.pattern;
    unsigned int       k       = pattern.row_start[row];
    diagonal_mass[row]         = smoothed[row] ? scale * sum.mass * matrices.mass[k] : 0.;
    diagonal_blocks[row] =
      scale * sum.stiffness * Eigen::Map<const Block>(matrices.stiffness[k].data())
      + scale * sum.mass * matrices.mass[k] * Block::Identity();
    unsigned int place = n_side_by_side;
    for (++k; k < pattern.row_start[row + 1]; ++k)
      {
        const unsigned int column = pattern.columns[k];
        const auto        &block  = matrices.stiffness[k];
        if (!smoothed[row] && !smoothed[column])
          continue;
        if (column >= nodes.n_owned)
          {
            ghost_entries.push_back({{}, Number(0), row, column});
            for (unsigned int i = 0; i < dim * dim; ++i)
              ghost_entries.back().stiffness[i] = scale * sum.stiffness * block[i];
            ghost_entries.back().mass = scale * sum.mass * matrices.mass[k];
            continue;
          }
        if (place == n_side_by_side)
          {
            groups.emplace_back();
            std::fill_n(groups.back().column, n_side_by_side, row);
            place = 0;
          }
        Group &group = groups.back();
        for (unsigned int i = 0; i < dim * dim; ++i)
          group.stiffness[i][place] = scale * sum.stiffness * block[i];
        group.mass[place]     = scale * sum.mass * matrices.mass[k];
        group.column[place++] = column;
      }
  }


  template <int dim, typename Number>
  void LevelMatrix<dim, Number>::subtract_product(const LevelVector<Number> &x,
                                                  LevelVector<Number>       &r) const
  {
    ghosts.fetch(x);
    for (unsigned int row = 0; row < nodes.n_owned; ++row)
      {
        const Number      *x_row = x.data() + 4 * row;
        SideBySide<Number> sums[3]{};
        for (unsigned int g = group_start[row]; g < group_start[row + 1]; ++g)
          {
            const Group &group = groups[g];
            prefetch<sizeof(Group)>(&group);
            SideBySide<Number> x_column[3], forces[3];
            gather<dim, Number>(x.data(), group.column, x_column);
            const SideBySide<Number> mass = load_side_by_side(group.mass);
            for_each_component<dim>([&](const auto c) {
              sums[c] += mass * x_column[c];
              forces[c] = -mass * x_row[c];
              x_column[c] -= x_row[c];
            });
            for_each_component<dim>([&](const auto j) {
              for_each_component<dim>([&](const auto i) {
                const SideBySide<Number> entry = load_side_by_side(group.stiffness[dim * j + i]);
                sums[i] += entry * x_column[j];
                forces[j] += entry * x_column[i];
              });
            });
            scatter<dim, Number>(forces, group.column, r.data());
          }
        const Lanes<Number> sum{sum_of(sums[0]), sum_of(sums[1]), sum_of(sums[2]), Number(0)};
        set_value(r, row, value(r, row) - diagonal_mass[row] * load(x_row) - sum);
      }
    for (const Support &support : supports)
      set_value(r,
                support.node,
                value(r, support.node)
                  - block_product<dim, Number>(support.stiffness, value(x, support.node)));
    for (const GhostEntry &entry : ghost_entries)
      {
        const Lanes<Number> x_column = ghosts.value(x, entry.column);
        set_value(r,
                  entry.row,
                  value(r, entry.row)
                    - block_product<dim, Number>(entry.stiffness, x_column - value(x, entry.row))
                    - entry.mass * x_column);
      }
  }


  template class LevelMatrix<2, float>;
  template class LevelMatrix<2, double>;
  template class LevelMatrix<3, float>;
  template class LevelMatrix<3, double>;
} // namespace signorini
