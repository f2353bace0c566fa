// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/flush_denormals.h>
#include <signorini/linear_algebra/small_blocks.h>
#include <signorini/linear_algebra/symmetric_gauss_seidel.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    using dealii::Tensor;

    /** A block, or its transpose, times lanes; or a number times lanes. */
    template <int dim, typename Entry>
    inline Lanes<float> times(const Entry &block, const Lanes<float> x)
    {
      if constexpr (std::tuple_size<Entry>() == 1)
        return block[0] * x;
      else
        return block_product<dim, float>(block.data(), x);
    }
    template <int dim, typename Entry>
    inline Lanes<float> transposed_times(const Entry &block, const Lanes<float> x)
    {
      if constexpr (std::tuple_size<Entry>() == 1)
        return block[0] * x;
      else
        return block_transposed_product<dim, float>(block.data(), x);
    }

    inline void store(float *numbers, const Lanes<float> lanes)
    {
      std::memcpy(numbers, &lanes, sizeof(lanes));
    }

    double sum_of(const Lanes<double> lanes)
    {
      return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    }
  } // namespace


  template <int dim, int block_size>
  SymmetricGaussSeidel<dim, block_size>::SymmetricGaussSeidel(const ElasticMatrices<dim> &matrices,
                                                              const MatrixSum            &sum)
    : matrix(matrices, sum)
    , is_held(matrix.n_positions(), 0)
    , exchange(matrix.order, matrix.position_of, matrix.communicator)
    , solution(4 * matrix.n_positions() + 4)
    , residual(solution)
    , direction(solution)
    , back(solution)
    , forth(solution)
  {
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::set_held_nodes(const HeldNodes<dim> &held)
  {
    for (const FreePart &part : free_parts)
      is_held[part.position] = 0;
    free_parts.clear();
    for (const HeldNode<dim> &node : held)
      {
        if (node.node >= matrix.n_positions())
          continue; // a ghost
        const unsigned int position = matrix.position_of[node.node];
        // What is held along n in the displacement C^-T x is held along C^-1 n in x.
        Tensor<2, dim> root;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            root[i][j] = block_size == 1 ? (i == j) * matrix.inverse_roots[position][0]
                                         : matrix.inverse_roots[position][block_size * j + i];
        Tensor<2, dim>                      projector = dealii::unit_symmetric_tensor<dim>();
        std::vector<dealii::Tensor<1, dim>> basis;
        for (unsigned int k = 0; k < dim; ++k)
          if (node.held[k])
            {
              Tensor<1, dim> normal;
              for (unsigned int c = 0; c < dim; ++c)
                normal[c] = node.frame[dim * k + c];
              normal = root * normal;
              for (const auto &other : basis)
                normal -= (other * normal) * other;
              normal /= normal.norm();
              basis.push_back(normal);
              projector -= outer_product(normal, normal);
            }
        if (basis.size() == dim)
          projector = 0.; // without what is left by rounding
        is_held[position] = 1;
        free_parts.push_back({position, to_float(projector), {}});
      }
    std::sort(free_parts.begin(), free_parts.end(), [](const FreePart &a, const FreePart &b) {
      return a.position < b.position;
    });
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::set_direction(const Vector &source) const
  {
    const auto component = [&](const unsigned int p, const unsigned int i) {
      const unsigned int first = dim * matrix.order.nodes[p];
      const auto        &root  = matrix.inverse_roots[p];
      double             sum   = 0.;
      if constexpr (block_size == 1)
        sum = root[0] * source.local_element(first + i);
      else
        for (unsigned int j = 0; j <= i; ++j) // the inverse of a lower triangle is one
          sum += root[dim * j + i] * source.local_element(first + j);
      return sum;
    };
    double size = 0.;
    for (unsigned int p = 0; p < matrix.n_positions(); ++p)
      for (unsigned int i = 0; i < dim; ++i)
        size = std::max(size, std::abs(component(p, i)));
    scale = dealii::Utilities::MPI::max(matrix.root_scale * size, matrix.communicator);
    const double factor = scale > 0. ? matrix.root_scale / scale : 0.;
    for (unsigned int p = 0; p < matrix.n_positions(); ++p)
      for (unsigned int i = 0; i < dim; ++i)
        direction[4 * p + i] = static_cast<float>(factor * component(p, i));
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::read(Vector                   &destination,
                                                   const std::vector<float> &source) const
  {
    destination.zero_out_ghost_values();
    for (unsigned int p = 0; p < matrix.n_positions(); ++p)
      for (unsigned int i = 0; i < dim; ++i)
        {
          double sum = 0.;
          if constexpr (block_size == 1)
            sum = static_cast<double>(matrix.inverse_roots[p][0]) * source[4 * p + i];
          else
            for (unsigned int j = i; j < dim; ++j)
              sum += static_cast<double>(matrix.inverse_roots[p][dim * i + j]) * source[4 * p + j];
          destination.local_element(dim * matrix.order.nodes[p] + i) =
            scale * matrix.root_scale * sum;
        }
  }


  template <int dim, int block_size>
  Lanes<float> SymmetricGaussSeidel<dim, block_size>::free_part(const unsigned int position,
                                                                const Lanes<float> lanes) const
  {
    const auto part = std::lower_bound(
      free_parts.begin(), free_parts.end(), position, [](const auto &entry, const unsigned int p) {
        return entry.position < p;
      });
    return without_spare_lanes<dim, float>(
      block_product<dim, float>(part->projector.data(), lanes));
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::add_ghosts(const GhostRows          &rows,
                                                         const std::vector<float> &ghosts,
                                                         const float               sign) const
  {
    for (unsigned int row = 0; row + 1 < rows.row_start.size(); ++row)
      {
        float       *target = forth.data() + 4 * (matrix.order.interface_begin + row);
        Lanes<float> sum    = load(target);
        for (unsigned int k = rows.row_start[row]; k < rows.row_start[row + 1]; ++k)
          sum += sign * times<dim>(rows.blocks[k], load(ghosts.data() + 4 * rows.ghosts[k]));
        store(target, without_spare_lanes<dim, float>(sum));
      }
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::sweep_back(const unsigned int begin,
                                                         const unsigned int end) const
  {
    // (I + L') t = p: what is known of t goes to the sums of the rows before. What has been read
    // last is still in the cache, so L is read backwards.
    float *sums = forth.data();
    for (unsigned int i = end; i-- > begin;)
      {
        Lanes<float> t = load(direction.data() + 4 * i) - load(sums + 4 * i);
        if (is_held[i])
          t = free_part(i, t);
        store(back.data() + 4 * i, t);
        store(sums + 4 * i, Lanes<float>{});
        for (unsigned int a = matrix.row_start[i + 1]; a-- > matrix.row_start[i];)
          {
            if constexpr (block_size > 1)
              prefetch_backwards(matrix.lower[a].data());
            float *target = sums + 4 * matrix.columns[a];
            store(target, load(target) + transposed_times<dim>(matrix.lower[a], t));
          }
      }
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::sweep_forth(const unsigned int begin,
                                                          const unsigned int end,
                                                          Sums              &sums) const
  {
    // (I + L) y = p - t, and q = t + y
    Lanes<double> pq{}, rq{}, qq{}, rr{};
    float        *y = forth.data();
    for (unsigned int i = begin; i < end; ++i)
      {
        const Lanes<float> p = load(direction.data() + 4 * i), t = load(back.data() + 4 * i),
                           r = load(residual.data() + 4 * i);
        Lanes<float> sum     = p - t + load(y + 4 * i);
        for (unsigned int a = matrix.row_start[i]; a < matrix.row_start[i + 1]; ++a)
          {
            if constexpr (block_size > 1)
              prefetch(matrix.lower[a].data());
            sum -= times<dim>(matrix.lower[a], load(y + 4 * matrix.columns[a]));
          }
        sum = is_held[i] ? free_part(i, sum) : without_spare_lanes<dim, float>(sum);
        store(y + 4 * i, sum);
        const Lanes<double> q        = __builtin_convertvector(t + sum, Lanes<double>),
                            p_double = __builtin_convertvector(p, Lanes<double>),
                            r_double = __builtin_convertvector(r, Lanes<double>);
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
  void SymmetricGaussSeidel<dim, block_size>::sweep_back() const
  {
    exchange.expect(false);
    sweep_back(matrix.order.interface_end, matrix.n_positions());
    add_ghosts(matrix.later, exchange.receive(), 1.f);
    sweep_back(matrix.order.interface_begin, matrix.order.interface_end);
    exchange.send(back, false);
    sweep_back(0, matrix.order.interface_begin);
    exchange.finish();
  }


  template <int dim, int block_size>
  typename SymmetricGaussSeidel<dim, block_size>::Sums
  SymmetricGaussSeidel<dim, block_size>::sweep_forth() const
  {
    Sums sums{};
    exchange.expect(true);
    sweep_forth(0, matrix.order.interface_begin, sums);
    add_ghosts(matrix.earlier, exchange.receive(), -1.f);
    sweep_forth(matrix.order.interface_begin, matrix.order.interface_end, sums);
    exchange.send(forth, true);
    sweep_forth(matrix.order.interface_end, matrix.n_positions(), sums);
    exchange.finish();
    Sums all;
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(sums.data(), sums.size()),
                                matrix.communicator,
                                dealii::ArrayView<double>(all.data(), all.size()));
    return all;
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::advance(const float step, const float kept) const
  {
    float *__restrict x = solution.data(), *__restrict r = residual.data(),
                      *__restrict p = direction.data(), *__restrict y = forth.data();
    const float *__restrict t = back.data();
    const std::size_t n       = 4 * matrix.n_positions();
    for (std::size_t i = 0; i < n; ++i)
      {
        x[i] += step * t[i];
        r[i] -= step * (t[i] + y[i]);
        p[i] = r[i] + kept * p[i];
        y[i] = 0.f;
      }
  }


  template <int dim, int block_size>
  void SymmetricGaussSeidel<dim, block_size>::vmult(Vector &destination, const Vector &source) const
  {
    const FlushDenormals flush;
    set_direction(source);
    std::fill(back.begin(), back.end(), 0.f);
    sweep_forth();
    std::swap(direction, forth);
    std::fill(forth.begin(), forth.end(), 0.f);
    sweep_back();
    read(destination, back);
  }


  template <int dim, int block_size>
  double SymmetricGaussSeidel<dim, block_size>::start(const Vector &right_hand_side) const
  {
    const FlushDenormals flush;
    set_direction(right_hand_side);
    std::fill(back.begin(), back.end(), 0.f);
    const double square = sweep_forth()[2];
    direction           = forth;
    residual            = forth;
    std::fill(forth.begin(), forth.end(), 0.f);
    std::fill(solution.begin(), solution.end(), 0.f);
    return scale * std::sqrt(square);
  }


  template <int dim, int block_size>
  RoughSolver::Report
  SymmetricGaussSeidel<dim, block_size>::solve(Vector            &correction,
                                               const double       reduction,
                                               const unsigned int maximum_iterations) const
  {
    const FlushDenormals flush;
    Report               report;
    LanczosMatrix        lanczos;
    double               goal = -1.;
    while (report.iterations < maximum_iterations)
      {
        sweep_back();
        const auto [pq, rq, qq, rr] = sweep_forth();
        ++report.iterations;
        if (goal < 0.)
          goal = reduction * reduction * rr;
        if (!(pq > 0.))
          {
            std::fill(forth.begin(), forth.end(), 0.f);
            break; // round-off: the caller judges what there is
          }
        const double step       = rr / pq;
        const double new_square = std::max(0., rr - 2. * step * rq + step * step * qq);
        const double kept       = new_square / rr;
        advance(static_cast<float>(step), static_cast<float>(kept));
        lanczos.add(step, kept);
        if (new_square <= goal)
          break;
      }
    report.smallest_eigenvalue = lanczos.smallest_eigenvalue();
    read(correction, solution);
    return report;
  }


  template class SymmetricGaussSeidel<2, 1>;
  template class SymmetricGaussSeidel<2, 2>;
  template class SymmetricGaussSeidel<3, 1>;
  template class SymmetricGaussSeidel<3, 3>;
} // namespace signorini
