// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/slip_scaling.h>
#include <signorini/linear_algebra/small_blocks.h>
#include <signorini/sweeps/special_positions.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    using dealii::Tensor;

    template <int dim>
    float product_of(const Lanes<float> a, const Lanes<float> b)
    {
      float sum = 0.f;
      for (int c = 0; c < dim; ++c)
        sum += a[c] * b[c];
      return sum;
    }

    template <int dim>
    Lanes<float> to_lanes(const Tensor<1, dim> &vector)
    {
      Lanes<float> result{};
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = static_cast<float>(vector[c]);
      return result;
    }

    /** S */
    template <int dim>
    Tensor<2, dim> scaling_of(const Tensor<2, dim> &stiffness)
    {
      Eigen::Matrix<double, dim, dim> Q;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          Q(i, j) = stiffness[i][j];
      const auto     S = slip_scaling<dim>(Q);
      Tensor<2, dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          result[i][j] = S(i, j);
      return result;
    }
  } // namespace


  template <int dim, int block_size>
  SpecialPositions<dim, block_size>::SpecialPositions(
    const UnitDiagonalMatrix<dim, block_size> &matrix)
    : matrix(matrix)
    , is_special(matrix.n_positions(), 0)
  {
  }


  template <int dim, int block_size>
  Tensor<2, dim> SpecialPositions<dim, block_size>::inverse_root(const unsigned int position) const
  {
    Tensor<2, dim> root;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        root[i][j] = block_size == 1 ? (i == j) * matrix.inverse_roots[position][0]
                                     : matrix.inverse_roots[position][block_size * j + i];
    return matrix.root_scale * root;
  }


  template <int dim, int block_size>
  void SpecialPositions<dim, block_size>::set_held_nodes(const HeldNodes<dim> &held)
  {
    for (const Special &node : specials)
      is_special[node.position] = 0;
    specials.clear();
    slipping.clear();
    slips = false;
    for (const HeldNode<dim> &node : held)
      {
        if (node.node >= matrix.position_of.size())
          continue; // a ghost
        const unsigned int position = matrix.position_of[node.node];
        if (position == matrix.n_positions())
          continue; // no part of the sweeps
        // What is held along n in the displacement C^-T x is held along C^-1 n in x.
        const Tensor<2, dim>        root      = inverse_root(position);
        Tensor<2, dim>              projector = dealii::unit_symmetric_tensor<dim>();
        std::vector<Tensor<1, dim>> basis;
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
        is_special[position] = 1;
        specials.push_back({position, -1, to_float(projector), {}});
      }
    std::sort(specials.begin(), specials.end(), [](const Special &a, const Special &b) {
      return a.position < b.position;
    });
  }


  template <int dim, int block_size>
  void SpecialPositions<dim, block_size>::set_slip(const std::vector<NodeSlip<dim>> &nodes)
  {
    const auto by_position = [](const Special &a, const Special &b) {
      return a.position < b.position;
    };
    for (const NodeSlip<dim> &node : nodes)
      {
        const unsigned int position = matrix.position_of[node.node];
        if (!is_special[position])
          {
            is_special[position] = 1;
            const Special free{
              position, -1, to_float(Tensor<2, dim>(dealii::unit_symmetric_tensor<dim>())), {}};
            specials.insert(std::upper_bound(specials.begin(), specials.end(), free, by_position),
                            free);
          }
      }
    for (const NodeSlip<dim> &node : nodes)
      {
        const unsigned int   position  = matrix.position_of[node.node];
        const Tensor<2, dim> root      = inverse_root(position),
                             free      = to_tensor<dim>(special(position).projector),
                             stiffness = free * root * node.stiffness * transpose(root) * free,
                             scaling   = scaling_of<dim>(stiffness);
        const Tensor<2, dim> turning =
          stiffness + dealii::unit_symmetric_tensor<dim>() - invert(scaling * scaling);
        special(position).slip = slipping.size();
        Slip slip{};
        slip.position = position;
        slip.scaling  = to_float(scaling);
        slip.turning  = to_float(scaling * turning);
        // Only their product counts; without the common scale each is within single precision.
        const Tensor<2, dim> scaled_root = root / matrix.root_scale;
        slip.coupling = to_lanes<dim>(scaling * free * scaled_root * node.coupling);
        slip.normal   = to_lanes<dim>(transpose(invert(scaled_root)) * node.normal);
        slipping.push_back(slip);
      }
    slips =
      dealii::Utilities::MPI::max(static_cast<unsigned int>(slipping.size()), matrix.communicator)
      > 0;
  }


  template <int dim, int block_size>
  typename SpecialPositions<dim, block_size>::Special &
  SpecialPositions<dim, block_size>::special(const unsigned int position)
  {
    return *std::lower_bound(
      specials.begin(), specials.end(), position, [](const auto &node, const unsigned int p) {
        return node.position < p;
      });
  }


  template <int dim, int block_size>
  Lanes<float> SpecialPositions<dim, block_size>::back(const unsigned int position,
                                                       const Lanes<float> of_p,
                                                       const Lanes<float> sum)
  {
    const Special &node = special(position);
    if (node.slip < 0)
      return node.free_part(of_p - sum);
    Slip &slip = slipping[node.slip];
    slip.upper = sum;
    slip.t     = node.free_part(of_p - block_product<dim, float>(slip.scaling.data(), sum));
    return without_spare_lanes<dim, float>(block_product<dim, float>(slip.scaling.data(), slip.t));
  }


  template <int dim, int block_size>
  Lanes<float> SpecialPositions<dim, block_size>::forth(const unsigned int        position,
                                                        const Lanes<float>        of_p,
                                                        const Lanes<float>        sum,
                                                        const std::vector<float> &t,
                                                        Lanes<float>             &of_t,
                                                        Lanes<float>             &of_y)
  {
    const Special &node = special(position);
    if (node.slip < 0)
      return of_y = node.free_part(of_p - of_t + sum);
    Slip        &slip = slipping[node.slip];
    Lanes<float> row  = of_t + slip.upper + slip.lower_ghosts; // of K t
    for (unsigned int a = matrix.row_start[position]; a < matrix.row_start[position + 1]; ++a)
      row += times<dim>(matrix.lower[a], t.data() + 4 * matrix.columns[a]);
    const Lanes<float> of_slip = block_product<dim, float>(slip.turning.data(), of_t)
                                 - slip.coupling * product_of<dim>(slip.normal, row);
    of_t = slip.t;
    of_y = slip.y =
      node.free_part(of_p - of_t + of_slip + block_product<dim, float>(slip.scaling.data(), sum));
    return without_spare_lanes<dim, float>(block_product<dim, float>(slip.scaling.data(), of_y));
  }


  template <int dim, int block_size>
  void SpecialPositions<dim, block_size>::fetch(SweepExchange            &exchange,
                                                const std::vector<float> &t)
  {
    exchange.expect(true);
    exchange.send(t, true);
    const std::vector<float> &ghosts = exchange.receive();
    exchange.finish();
    const auto &rows = matrix.earlier;
    for (Slip &slip : slipping)
      {
        slip.lower_ghosts = Lanes<float>{};
        if (slip.position < matrix.order.interface_begin
            || slip.position >= matrix.order.interface_end)
          continue;
        const unsigned int row = slip.position - matrix.order.interface_begin;
        for (unsigned int k = rows.row_start[row]; k < rows.row_start[row + 1]; ++k)
          slip.lower_ghosts += times<dim>(rows.blocks[k], ghosts.data() + 4 * rows.ghosts[k]);
      }
  }


  template <int dim, int block_size>
  void SpecialPositions<dim, block_size>::clear()
  {
    for (Slip &slip : slipping)
      slip.t = slip.upper = slip.lower_ghosts = Lanes<float>{};
  }


  template <int dim, int block_size>
  void SpecialPositions<dim, block_size>::scale(std::vector<float> &p) const
  {
    for (const Slip &slip : slipping)
      {
        float *of_p = p.data() + 4 * slip.position;
        store(of_p,
              without_spare_lanes<dim, float>(
                block_product<dim, float>(slip.scaling.data(), load(of_p))));
      }
  }


  template <int dim, int block_size>
  void SpecialPositions<dim, block_size>::finish(std::vector<float> &t, std::vector<float> &y) const
  {
    for (const Slip &slip : slipping)
      {
        store(t.data() + 4 * slip.position, slip.t);
        store(y.data() + 4 * slip.position, slip.y);
      }
  }


  template class SpecialPositions<2, 1>;
  template class SpecialPositions<2, 2>;
  template class SpecialPositions<3, 1>;
  template class SpecialPositions<3, 3>;
} // namespace signorini
