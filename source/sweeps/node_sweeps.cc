// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/small_blocks.h>
#include <signorini/sweeps/node_sweeps.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace signorini
{
  namespace
  {
    using dealii::Tensor;

    double sum_of(const Lanes<double> lanes)
    {
      return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    }
  } // namespace


  template <int dim, int block_size>
  NodeSweeps<dim, block_size>::NodeSweeps(const ElasticMatrices<dim> &matrices,
                                          const MatrixSum            &sum,
                                          SweepOrder                  order)
    : matrix(matrices, sum, std::move(order))
    , special(matrix)
    , exchange(matrix.order, matrix.position_of, matrix.communicator)
  {
    p.resize(4 * matrix.n_positions() + 4);
    t = y = p;
    active.assign(n_parts(), 1);
    sums_of_parts.resize(n_parts());
    for (unsigned int part = 0; part < n_parts(); ++part)
      {
        double n_nodes = 0.;
        for_each_range(part, [&](const auto begin, const auto end) { n_nodes += end - begin; });
        shares.push_back(n_nodes);
      }
    dealii::Utilities::MPI::sum(shares, matrix.communicator, shares);
    const double all = std::accumulate(shares.begin(), shares.end(), 0.);
    for (double &share : shares)
      share /= std::max(all, 1.);
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::deactivate(const unsigned int part)
  {
    active[part] = 0;
    for_each_range(part, [&](const auto begin, const auto end) {
      std::fill(t.begin() + 4 * begin, t.begin() + 4 * end, 0.f);
      std::fill(y.begin() + 4 * begin, y.begin() + 4 * end, 0.f);
    });
  }


  template <int dim, int block_size>
  double NodeSweeps<dim, block_size>::set_direction(const Vector &source)
  {
    const auto component = [&](const unsigned int position, const unsigned int i) {
      const unsigned int first = dim * matrix.order.nodes[position];
      const auto        &root  = matrix.inverse_roots[position];
      double             sum   = 0.;
      if constexpr (block_size == 1)
        sum = root[0] * source.local_element(first + i);
      else
        for (unsigned int j = 0; j <= i; ++j) // the inverse of a lower triangle is one
          sum += root[dim * j + i] * source.local_element(first + j);
      return sum;
    };
    double size = 0.;
    for (unsigned int n = 0; n < matrix.n_positions(); ++n)
      for (unsigned int i = 0; i < dim; ++i)
        size = std::max(size, std::abs(component(n, i)));
    const double scale = dealii::Utilities::MPI::max(matrix.root_scale * size, matrix.communicator);
    const double factor = scale > 0. ? matrix.root_scale / scale : 0.;
    for (unsigned int n = 0; n < matrix.n_positions(); ++n)
      for (unsigned int i = 0; i < dim; ++i)
        p[4 * n + i] = static_cast<float>(factor * component(n, i));
    special.scale(p);
    return scale;
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::read(Vector                   &destination,
                                         const std::vector<float> &x,
                                         const double              scale) const
  {
    destination.zero_out_ghost_values();
    if (!matrix.has_all_nodes())
      destination = 0.;
    for (unsigned int n = 0; n < matrix.n_positions(); ++n)
      for (unsigned int i = 0; i < dim; ++i)
        {
          double sum = 0.;
          if constexpr (block_size == 1)
            sum = static_cast<double>(matrix.inverse_roots[n][0]) * x[4 * n + i];
          else
            for (unsigned int j = i; j < dim; ++j)
              sum += static_cast<double>(matrix.inverse_roots[n][dim * i + j]) * x[4 * n + j];
          destination.local_element(dim * matrix.order.nodes[n] + i) =
            scale * matrix.root_scale * sum;
        }
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::add_ghosts(const GhostRows          &rows,
                                               const std::vector<float> &ghosts,
                                               const float               sign)
  {
    for (unsigned int row = 0; row + 1 < rows.row_start.size(); ++row)
      {
        float       *target = y.data() + 4 * (matrix.order.interface_begin + row);
        Lanes<float> sum    = load(target);
        for (unsigned int k = rows.row_start[row]; k < rows.row_start[row + 1]; ++k)
          sum += sign * times<dim>(rows.blocks[k], ghosts.data() + 4 * rows.ghosts[k]);
        store(target, without_spare_lanes<dim, float>(sum));
      }
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::sweep_back(const unsigned int begin, const unsigned int end)
  {
    // (I + L') t = p: what is known of t goes to the sums of the rows before. What has been read
    // last is still in the cache, so L is read backwards.
    float      *sums      = y.data();
    const auto *lower     = matrix.lower.data(); // the compiler cannot know that they stay
    const auto *columns   = matrix.columns.data();
    const auto *row_start = matrix.row_start.data();
    for (unsigned int i = end; i-- > begin;)
      {
        const Lanes<float> of_p = load(p.data() + 4 * i),
                           sum  = without_spare_lanes<dim, float>(load(sums + 4 * i));
        const Lanes<float> of_t = special.contain(i) ? special.back(i, of_p, sum) : of_p - sum;
        store(t.data() + 4 * i, of_t);
        store(sums + 4 * i, Lanes<float>{});
        const unsigned int first = row_start[i];
        for (unsigned int a = row_start[i + 1]; a-- > first;)
          {
            if constexpr (block_size > 1)
              prefetch_backwards(lower[a].data());
            float *target = sums + 4 * columns[a];
            store(target, load(target) + transposed_times<dim>(lower[a], of_t));
          }
      }
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::sweep_forth(const unsigned int        begin,
                                                const unsigned int        end,
                                                const std::vector<float> &r,
                                                Sums                     &sums)
  {
    // (I + L) y = p - t + E t, and q = t + y
    Lanes<double> pq{}, rq{}, qq{}, rr{};
    const auto   *lower     = matrix.lower.data();
    const auto   *columns   = matrix.columns.data();
    const auto   *row_start = matrix.row_start.data();
    float        *of_rows   = y.data();
    for (unsigned int i = begin; i < end; ++i)
      {
        const Lanes<float> of_p = load(p.data() + 4 * i);
        Lanes<float>       of_t = load(t.data() + 4 * i), sum = load(of_rows + 4 * i);
        const unsigned int last = row_start[i + 1];
        for (unsigned int a = row_start[i]; a < last; ++a)
          {
            if constexpr (block_size > 1)
              prefetch(lower[a].data());
            sum -= times<dim>(lower[a], of_rows + 4 * columns[a]);
          }
        Lanes<float> of_y = without_spare_lanes<dim, float>(of_p - of_t + sum);
        store(of_rows + 4 * i,
              special.contain(i) ? special.forth(i, of_p, sum, t, of_t, of_y) : of_y);
        const Lanes<double> q        = in_double_precision(of_t + of_y),
                            p_double = in_double_precision(of_p),
                            r_double = in_double_precision(load(r.data() + 4 * i));
        pq += p_double * q;
        rq += r_double * q;
        qq += q * q;
        rr += r_double * r_double;
      }
    sums[0] += sum_of(pq);
    sums[1] += sum_of(rq);
    sums[2] += sum_of(qq);
    sums[3] += sum_of(rr);
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::clear_t()
  {
    std::fill(t.begin(), t.end(), 0.f);
    special.clear();
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::sweep_back()
  {
    exchange.expect(false);
    sweep_back_over(2);
    add_ghosts(matrix.later, exchange.receive(), 1.f);
    sweep_back_over(1);
    exchange.send(t, false);
    sweep_back_over(0);
    exchange.finish();
    if (special.any_slip())
      special.fetch(exchange, t);
  }


  template <int dim, int block_size>
  const std::vector<typename NodeSweeps<dim, block_size>::Sums> &
  NodeSweeps<dim, block_size>::sweep_forth(const std::vector<float> &r)
  {
    std::fill(sums_of_parts.begin(), sums_of_parts.end(), Sums{});
    exchange.expect(true);
    sweep_forth_over(0, r);
    add_ghosts(matrix.earlier, exchange.receive(), -1.f);
    sweep_forth_over(1, r);
    exchange.send(y, true);
    sweep_forth_over(2, r);
    exchange.finish();
    special.finish(t, y);
    static_assert(sizeof(Sums) == 4 * sizeof(double), "sums follow each other");
    double *numbers = sums_of_parts.front().data();
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(numbers, 4 * sums_of_parts.size()),
                                matrix.communicator,
                                dealii::ArrayView<double>(numbers, 4 * sums_of_parts.size()));
    return sums_of_parts;
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::sweep_back_over(const unsigned int segment)
  {
    const auto &begin = matrix.order.part_begin[segment];
    for (unsigned int part = n_parts(); part-- > 0;)
      if (active[part])
        sweep_back(begin[part], begin[part + 1]);
  }


  template <int dim, int block_size>
  void NodeSweeps<dim, block_size>::sweep_forth_over(const unsigned int        segment,
                                                     const std::vector<float> &r)
  {
    const auto &begin = matrix.order.part_begin[segment];
    for (unsigned int part = 0; part < n_parts(); ++part)
      if (active[part])
        sweep_forth(begin[part], begin[part + 1], r, sums_of_parts[part]);
  }


  template class NodeSweeps<2, 1>;
  template class NodeSweeps<2, 2>;
  template class NodeSweeps<3, 1>;
  template class NodeSweeps<3, 3>;
} // namespace signorini
