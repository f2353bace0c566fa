// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/lanczos.h>
#include <signorini/multigrid/level_smoother.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr unsigned int degree             = 2;
    constexpr double       smoothing_range    = 10.; ///< of the eigenvalues that are smoothed
    constexpr unsigned int n_lanczos_steps    = 8;   ///< for the largest one
    constexpr unsigned int n_steps_at_changed = 4;   ///< for the largest one at a few nodes
    constexpr double       safety             = 1.1; ///< of the estimate of the largest one

    /** Modes may be shared with nodes that have not changed. */
    constexpr unsigned int most_weakenings = 3;

    /** Directions of a node in which less than this of its stiffness is left count as held. */
    constexpr double least_stiffness = 1e-2;

    /**
     * The inverse of a block and its change by held entries, on the directions that are not held
     * altogether: where a level is as fine as the finest, nothing is left of those that are.
     */
    template <typename Block>
    Block inverse_of_change(const Block &block, const Block &change)
    {
      const Eigen::SelfAdjointEigenSolver<Block> eigen(block + change);
      const double                               least   = least_stiffness * block.trace();
      auto                                       inverse = eigen.eigenvalues();
      for (double &value : inverse)
        value = value > least ? 1. / value : 0.;
      return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
    }
  } // namespace


  template <int dim, typename Number>
  LevelSmoother<dim, Number>::LevelSmoother(const LevelMatrix<dim, Number> &matrix,
                                            const FreeSpace<dim, Number>   *free)
    : matrix(matrix)
    , free(free)
    , inverse(matrix.n_owned() + 1, Inverse{})
    , direction(4 * matrix.n_owned())
  {
    for (const unsigned int node : matrix.smoothed_nodes())
      set_inverse(node, matrix.diagonal(node).inverse());
    largest = safety * largest_eigenvalue(matrix.smoothed_nodes(), n_lanczos_steps);
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::set_inverse(const unsigned int node, const Block &block)
  {
    for (unsigned int j = 0; j < dim; ++j)
      for (unsigned int i = 0; i < dim; ++i)
        inverse[node][dim * j + i] = block(i, j);
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::reset_changed()
  {
    for (const unsigned int node : changed)
      if (!matrix.diagonal(node).isZero(0.))
        set_inverse(node, matrix.diagonal(node).inverse());
    changed.clear();
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::update_free_space()
  {
    reset_changed();
    for (const auto &[node, block] : free->changed_inverses(matrix))
      {
        set_inverse(node, block);
        changed.push_back(node);
      }
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::set_correction(const HeldCorrection<dim, Number> &new_correction,
                                                  const unsigned int                 of_level)
  {
    correction = &new_correction;
    level      = of_level;
    reset_changed();
    for (const auto &[node, change] : correction->diagonal_changes(level))
      {
        set_inverse(node, inverse_of_change(matrix.diagonal(node), change));
        changed.push_back(node);
      }
    if (correction->has_partners())
      weaken_changed();
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::weaken_changed()
  {
    // Nodes that carry a much stiffer body are coupled to each other by it. Their blocks do not
    // show that, and where the smoother amplifies, the preconditioner is indefinite.
    for (unsigned int n = 0; n < most_weakenings; ++n)
      {
        const double here = safety * largest_eigenvalue(changed, n_steps_at_changed);
        if (here <= largest)
          return;
        for (const unsigned int node : changed)
          for (Number &value : inverse[node])
            value *= largest / here;
      }
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::subtract_product(const LevelVector<Number> &displacement,
                                                    LevelVector<Number>       &residual) const
  {
    matrix.subtract_product(displacement, residual);
    if (correction != nullptr)
      correction->subtract_product(level, displacement, residual);
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::step(const double         factor,
                                        const double         kept,
                                        LevelVector<Number> &residual) const
  {
    if (free != nullptr)
      free->project_force(residual);
    const Number now = factor, before = kept;
    for (const unsigned int node : matrix.smoothed_nodes())
      set_value(direction,
                node,
                without_spare_lanes<dim, Number>(
                  now * block_product<dim, Number>(inverse[node].data(), value(residual, node))
                  + before * value(direction, node)));
    if (free != nullptr)
      free->project(direction);
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::iterate(LevelVector<Number> &residual,
                                           LevelVector<Number> &solution,
                                           const bool           leave_residual) const
  {
    const double middle = 0.5 * largest * (1. + 1. / smoothing_range),
                 half = 0.5 * largest * (1. - 1. / smoothing_range), ratio = middle / half;
    double last = 1. / ratio;
    for (unsigned int n = 0; n < degree; ++n)
      {
        const double now = n == 0 ? 0. : 1. / (2. * ratio - last);
        step(n == 0 ? 1. / middle : 2. * now / half, now * last, residual);
        last = n == 0 ? last : now;
        for (const unsigned int node : matrix.smoothed_nodes())
          set_value(solution, node, value(solution, node) + value(direction, node));
        if (n + 1 < degree || leave_residual)
          subtract_product(direction, residual);
      }
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::start(LevelVector<Number> &residual,
                                         LevelVector<Number> &solution) const
  {
    solution.fill(Number(0));
    iterate(residual, solution, true);
  }


  template <int dim, typename Number>
  void LevelSmoother<dim, Number>::finish(LevelVector<Number> &residual,
                                          LevelVector<Number> &solution) const
  {
    iterate(residual, solution, false);
  }


  template <int dim, typename Number>
  double LevelSmoother<dim, Number>::largest_eigenvalue(const std::vector<unsigned int> &start,
                                                        const unsigned int n_steps) const
  {
    const auto &nodes = matrix.smoothed_nodes();
    const auto  dot   = [&](const LevelVector<Number> &a, const LevelVector<Number> &b) {
      double sum = 0.;
      for (const unsigned int node : nodes)
        for (unsigned int c = 0; c < dim; ++c)
          sum += static_cast<double>(a[4 * node + c]) * b[4 * node + c];
      return dealii::Utilities::MPI::sum(sum, matrix.communicator());
    };
    const auto add =
      [&](const double factor, const LevelVector<Number> &from, LevelVector<Number> &to) {
        for (const unsigned int node : nodes)
          set_value(to, node, value(to, node) + static_cast<Number>(factor) * value(from, node));
      };
    // Conjugate gradients from a force of all frequencies.
    LevelVector<Number> residual(direction.size()), product(direction.size()),
      next(direction.size());
    for (const unsigned int node : start)
      for (unsigned int c = 0; c < dim; ++c)
        residual[4 * node + c] =
          std::cos(1. + 37. * ((dim * (matrix.first_owned() + node) + c) % 1009));
    LanczosMatrix lanczos;
    direction.fill(Number(0));
    double last = 0., alpha = 0.;
    for (unsigned int n = 0; n <= n_steps; ++n)
      {
        for (const unsigned int node : nodes)
          set_value(next,
                    node,
                    without_spare_lanes<dim, Number>(
                      block_product<dim, Number>(inverse[node].data(), value(residual, node))));
        const double square = dot(residual, next), beta = n == 0 ? 0. : square / last;
        if (n > 0)
          lanczos.add(alpha, beta);
        last = square;
        add(beta, direction, next);
        std::swap(direction, next);
        product.fill(Number(0));
        subtract_product(direction, product);
        const double curvature = -dot(direction, product);
        if (!(curvature > 0.))
          break; // converged: there are few nodes
        alpha = square / curvature;
        add(alpha, product, residual);
      }
    direction.fill(Number(0));
    return lanczos.largest_eigenvalue();
  }


  template class LevelSmoother<2, float>;
  template class LevelSmoother<2, double>;
  template class LevelSmoother<3, float>;
  template class LevelSmoother<3, double>;
} // namespace signorini
