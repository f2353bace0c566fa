// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/complete_rows.h>
#include <signorini/discretization/mass_change.h>
#include <signorini/multigrid/galerkin_product.h>

#include <numeric>

namespace signorini
{
  namespace
  {
    /** Compressed lists, one for each node. */
    template <typename T>
    struct Lists
    {
      std::vector<unsigned int> starts;
      std::vector<T>            items;

      /** @param visit calls what it is given with list and item, each time the same */
      template <typename Visit>
      Lists(const unsigned int n, const Visit &visit)
        : starts(n + 1, 0)
      {
        visit([&](const unsigned int list, const T &) { ++starts[list + 1]; });
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        items.resize(starts.back());
        std::vector<unsigned int> next(starts.begin(), starts.end() - 1);
        visit([&](const unsigned int list, const T &item) { items[next[list]++] = item; });
      }

      dealii::ArrayView<const T> operator[](const unsigned int list) const
      {
        return {items.data() + starts[list], starts[list + 1] - starts[list]};
      }
    };


    /** A block of a full row of the fine matrix. */
    struct Neighbour
    {
      unsigned int node, position;
      bool         transposed;
      double       share; ///< of this process: couplings with ghosts are known to both
    };

    struct Child
    {
      unsigned int node;
      double       weight;
    };


    Lists<Neighbour> full_rows(const NodePattern &pattern)
    {
      return {pattern.n_local, [&](const auto &add) {
                for (unsigned int row = 0; row < pattern.n_owned; ++row)
                  for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
                    {
                      const unsigned int column = pattern.columns[k];
                      const double       share  = column < pattern.n_owned ? 1. : 0.5;
                      add(row, {column, k, false, share});
                      if (column != row)
                        add(column, {row, k, true, share});
                    }
              }};
    }


    Lists<Child> children(const Interpolation &interpolation)
    {
      return {interpolation.coarse().size(), [&](const auto &add) {
                for (unsigned int node = 0; node < interpolation.n_fine(); ++node)
                  for (const auto &part : interpolation.parts(node))
                    add(part.node, {node, part.weight});
              }};
    }


    /** A row of the coarse matrices while it is summed. */
    template <int dim>
    class RowSum
    {
    public:
      RowSum(const ElasticMatrices<dim> &fine, const unsigned int n_columns)
        : fine(fine)
        , place(n_columns, dealii::numbers::invalid_unsigned_int)
      {
      }

      void add(const unsigned int column, const double weight, const Neighbour &neighbour)
      {
        if (place[column] == dealii::numbers::invalid_unsigned_int)
          {
            place[column] = columns.size();
            columns.push_back(column);
            mass.push_back(0.);
            stiffness.push_back({});
          }
        mass[place[column]] += weight * fine.mass[neighbour.position];
        const auto &block = fine.stiffness[neighbour.position];
        auto       &sum   = stiffness[place[column]];
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            sum[dim * d + c] += weight * block[neighbour.transposed ? dim * c + d : dim * d + c];
      }

      /** Append the row to the matrices and begin another one. */
      void finish(ElasticMatrices<dim> &matrices)
      {
        std::sort(columns.begin(), columns.end());
        for (const unsigned int column : columns)
          {
            matrices.pattern.columns.push_back(column);
            matrices.mass.push_back(mass[place[column]]);
            matrices.stiffness.push_back(stiffness[place[column]]);
          }
        for (const unsigned int column : columns)
          place[column] = dealii::numbers::invalid_unsigned_int;
        matrices.pattern.row_start.push_back(matrices.pattern.columns.size());
        columns.clear();
        mass.clear();
        stiffness.clear();
      }

    private:
      const ElasticMatrices<dim>                       &fine;
      std::vector<unsigned int>                         place, columns;
      std::vector<double>                               mass;
      std::vector<typename ElasticMatrices<dim>::Block> stiffness;
    };


    /** Parents and children, and nodes that are coupled, belong to the same body. */
    template <int dim>
    void hand_down_damping(const ElasticMatrices<dim> &fine,
                           const Lists<Child>         &children_of,
                           ElasticMatrices<dim>       &coarse)
    {
      const NodePattern &pattern = coarse.pattern;
      coarse.damping.resize(pattern.n_local);
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        {
          coarse.damping[node] = fine.damping[children_of[node][0].node];
          for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
            coarse.damping[pattern.columns[k]] = coarse.damping[node];
        }
    }
  } // namespace


  template <int dim>
  ElasticMatrices<dim> galerkin_product(const ElasticMatrices<dim> &fine,
                                        const Interpolation        &interpolation,
                                        const MPI_Comm              communicator)
  {
    AssertDimension(interpolation.n_fine(), fine.pattern.n_local);
    const Lists<Neighbour> rows        = full_rows(fine.pattern);
    const Lists<Child>     children_of = children(interpolation);
    const LocalNodes      &coarse      = interpolation.coarse();
    ElasticMatrices<dim>   contributions;
    contributions.pattern.n_owned   = coarse.n_owned;
    contributions.pattern.n_local   = coarse.size();
    contributions.pattern.row_start = {0};
    RowSum<dim> sum(fine, coarse.size());
    for (unsigned int row = 0; row < coarse.size(); ++row)
      {
        for (const Child &child : children_of[row])
          for (const Neighbour &neighbour : rows[child.node])
            for (const auto &part : interpolation.parts(neighbour.node))
              if (part.node >= row)
                sum.add(part.node, child.weight * neighbour.share * part.weight, neighbour);
        sum.finish(contributions);
      }
    contributions.stiffness.emplace_back(); // a spare block, see Lanes
    ElasticMatrices<dim> result;
    complete_rows<dim>(contributions, coarse, {}, false, communicator, result);
    if (!fine.damping.empty())
      hand_down_damping(fine, children_of, result);
    return result;
  }


  template ElasticMatrices<2>
  galerkin_product(const ElasticMatrices<2> &, const Interpolation &, MPI_Comm);
  template ElasticMatrices<3>
  galerkin_product(const ElasticMatrices<3> &, const Interpolation &, MPI_Comm);
} // namespace signorini
