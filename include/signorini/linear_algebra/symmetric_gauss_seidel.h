// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_symmetric_gauss_seidel_h
#define signorini_linear_algebra_symmetric_gauss_seidel_h

#include <signorini/linear_algebra/lanes.h>
#include <signorini/linear_algebra/node_masks.h>
#include <signorini/linear_algebra/rough_solver.h>
#include <signorini/linear_algebra/sweep_exchange.h>
#include <signorini/linear_algebra/unit_diagonal_matrix.h>


namespace signorini
{
  /**
   * Symmetric block Gauss-Seidel, P = (D + L) D^-1 (D + L'), of a matrix K = L + D + L' with a
   * block per pair of nodes, and conjugate gradients with it in the form of Eisenstat (SIAM J. Sci.
   * Stat. Comput. 2, 1981): with t = (D + L')^-1 p, which a sweep back gives, one sweep forward
   * gives (D + L)^-1 K t = t + (D + L)^-1 (p - D t). So an iteration reads K once, where product
   * and preconditioner apart would read it twice; and as nothing but K is needed, there is no
   * factor to compute or to keep.
   *
   * Everything is in single precision and in coordinates of the nodes in which D is the identity
   * (x_p = C_p^-T of the new coordinates, D_p = C_p C_p'). Held directions are projected out within
   * the sweeps, so that P is that of the masked matrix, whatever is held. With several processes it
   * is the same method in another order, see SweepOrder.
   *
   * @tparam block_size dim, or 1 for the mass, a number per pair of nodes
   */
  template <int dim, int block_size>
  class SymmetricGaussSeidel : public RoughSolver
  {
  public:
    /** @param sum the matrix; the mass alone if block_size = 1. Collective */
    SymmetricGaussSeidel(const ElasticMatrices<dim> &matrices, const MatrixSum &sum);

    /** Collective. */
    void set_held_nodes(const HeldNodes<dim> &held);

    /** P^-1 on the free directions, in Cartesian components. */
    void vmult(Vector &destination, const Vector &source) const;

    double start(const Vector &residual) const override;
    Report
    solve(Vector &correction, double reduction, unsigned int maximum_iterations) const override;

  private:
    using Matrix    = UnitDiagonalMatrix<dim, block_size>;
    using GhostRows = typename Matrix::GhostRows;

    /** Projector onto the free directions of a position that is (partly) held. */
    struct FreePart
    {
      unsigned int                                position;
      std::array<float, dim * dim>                projector;
      [[maybe_unused]] std::array<float, 4 - dim> spare; ///< see Lanes
    };
    /** Over the nodes of a sweep: p'q, r'q, q'q and r'r. */
    using Sums = std::array<double, 4>;

    const Matrix          matrix;
    std::vector<char>     is_held;    ///< of positions: whether some direction is
    std::vector<FreePart> free_parts; ///< by position

    mutable SweepExchange exchange;
    /**
     * Four numbers per position: the iterates of conjugate gradients, what the sweep back gives
     * (t), and what the sweep forth gives, which collects the sums of the sweep back before.
     */
    mutable std::vector<float> solution, residual, direction, back, forth;
    mutable double             scale = 1.; ///< the right-hand side is that much larger

    /** C^-1 source into `direction`, scaled to the range of single precision. */
    void set_direction(const Vector &source) const;
    /** destination = C^-T source, with the scale. */
    void read(Vector &destination, const std::vector<float> &source) const;

    Lanes<float> free_part(unsigned int position, Lanes<float> lanes) const;
    /** forth += sign K ghosts. */
    void add_ghosts(const GhostRows &rows, const std::vector<float> &ghosts, float sign) const;

    void sweep_back() const;
    void sweep_back(unsigned int begin, unsigned int end) const;
    Sums sweep_forth() const;
    void sweep_forth(unsigned int begin, unsigned int end, Sums &sums) const;
    /** The new iterates: x += step t, r -= step (t + y), p = r + kept p. */
    void advance(float step, float kept) const;
  };
} // namespace signorini

#endif
