// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_sweeps_node_sweeps_h
#define signorini_sweeps_node_sweeps_h

#include <signorini/sweeps/special_positions.h>

#include <algorithm>

namespace signorini
{
  /**
   * The two sweeps of Gauss and Seidel over a matrix J = K + E in single precision, K = L + I + L'
   * in coordinates of the nodes in which its diagonal is the identity (x_p = C_p^-T of the new
   * coordinates, D_p = C_p C_p'), after Eisenstat (SIAM J. Sci. Stat. Comput. 2, 1981): t = (I +
   * L')^-1 p, which the sweep back gives, and then (I + L)^-1 J t = t + y, y = (I + L)^-1 (p - t +
   * E t), by the sweep forth. So J is applied and preconditioned from both sides while K is read
   * once.
   *
   * Held directions are projected out within the sweeps, so that the preconditioner is that of the
   * masked matrix, whatever is held. E is what slipping nodes add to their rows, whose coordinates
   * are scaled besides (SpecialPositions). With several processes it is the same method in another
   * order, see SweepOrder.
   *
   * Arrays have four numbers per position of the sweep, and four zeros behind them: what nodes
   * without a position are for other processes.
   * @tparam block_size dim, or 1 for the mass, a number per pair of nodes
   */
  template <int dim, int block_size>
  class NodeSweeps
  {
  public:
    /** @param sum the matrix; the mass alone if block_size = 1. Collective */
    NodeSweeps(const ElasticMatrices<dim> &matrices, const MatrixSum &sum, SweepOrder order);

    /** Nothing slips from now on. Collective. */
    void set_held_nodes(const HeldNodes<dim> &held) { special.set_held_nodes(held); }
    /** After set_held_nodes(). Collective. */
    void set_slip(const std::vector<NodeSlip<dim>> &slipping) { special.set_slip(slipping); }
    /** On any process. */
    bool any_slip() const { return special.any_slip(); }

    MPI_Comm communicator() const { return matrix.communicator; }

    /** Parts that nothing couples, see SweepOrder; the same number on all processes. */
    unsigned int n_parts() const { return matrix.order.n_parts(); }
    /** Of all nodes of all processes. */
    double share(const unsigned int part) const { return shares[part]; }
    /** Sweeps go over these parts. */
    bool is_active(const unsigned int part) const { return active[part]; }
    void activate_all() { std::fill(active.begin(), active.end(), 1); }
    /** Sweeps leave the part out, with t = y = 0 there. */
    void deactivate(unsigned int part);

    /** Call action(begin, end) for the positions of a part. */
    template <typename Action>
    void for_each_range(const unsigned int part, const Action &action) const
    {
      for (const auto &begin : matrix.order.part_begin)
        action(begin[part], begin[part + 1]);
    }

    /** C^-1 source into p, scaled to the range of single precision. @return the scale */
    double set_direction(const Vector &source);
    /** destination = scale C^-T x, zero at nodes without a position. */
    void read(Vector &destination, const std::vector<float> &x, double scale) const;

    /** t = 0: then a sweep forth is that of the preconditioner alone. */
    void clear_t();
    /** t from p; expects y = 0, and leaves it so. For slipping nodes t is in the scale of K. */
    void sweep_back();

    /** Over the nodes of a sweep: p'q, r'q, q'q and r'r, q = t + y. */
    using Sums = std::array<double, 4>;
    /** y from p and t. @param r for the sums @return sums of each part, zero of idle ones */
    const std::vector<Sums> &sweep_forth(const std::vector<float> &r);

    std::vector<float> p, t, y;

  private:
    using Matrix    = UnitDiagonalMatrix<dim, block_size>;
    using GhostRows = typename Matrix::GhostRows;

    const Matrix                      matrix;
    SpecialPositions<dim, block_size> special;
    SweepExchange                     exchange;
    std::vector<double>               shares;
    std::vector<char>                 active; ///< by part
    std::vector<Sums>                 sums_of_parts;

    /** y += sign K ghosts. */
    void add_ghosts(const GhostRows &rows, const std::vector<float> &ghosts, float sign);
    /** Of a segment of the order, see SweepOrder::part_begin. */
    void sweep_back_over(unsigned int segment);
    void sweep_forth_over(unsigned int segment, const std::vector<float> &r);
    void sweep_back(unsigned int begin, unsigned int end);
    void sweep_forth(unsigned int begin, unsigned int end, const std::vector<float> &r, Sums &sums);
  };
} // namespace signorini

#endif
