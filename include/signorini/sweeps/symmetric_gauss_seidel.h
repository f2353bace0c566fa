// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_sweeps_symmetric_gauss_seidel_h
#define signorini_sweeps_symmetric_gauss_seidel_h

#include <signorini/linear_algebra/rough_solver.h>
#include <signorini/sweeps/node_sweeps.h>
#include <signorini/sweeps/rough_gmres.h>

namespace signorini
{
  /**
   * Symmetric block Gauss-Seidel, P = (D + L) D^-1 (D + L'), of a matrix K = L + D + L' with a
   * block per pair of nodes, and Krylov methods with it in the form of Eisenstat (NodeSweeps): an
   * iteration reads K once, where product and preconditioner apart would read it twice; and as
   * nothing but K is needed, there is no factor to compute or to keep. Conjugate gradients, or
   * GMRES where nodes slip.
   *
   * Conjugate gradients solve for parts of K that nothing couples as for matrices of their own, all
   * in the same sweeps, and leave a part out as soon as it is solved: bodies that move freely or
   * rest cost the look whether they do.
   *
   * @tparam block_size dim, or 1 for the mass, a number per pair of nodes
   */
  template <int dim, int block_size>
  class SymmetricGaussSeidel : public RoughSolver
  {
  public:
    /** @param sum the matrix; the mass alone if block_size = 1. Collective */
    SymmetricGaussSeidel(const ElasticMatrices<dim> &matrices, const MatrixSum &sum);
    /** Of the block of the nodes of an order. Collective. */
    SymmetricGaussSeidel(const ElasticMatrices<dim> &matrices,
                         const MatrixSum            &sum,
                         SweepOrder                  order);

    /** Nothing slips from now on. Collective. */
    void set_held_nodes(const HeldNodes<dim> &held) { sweeps.set_held_nodes(held); }
    /** From now on start() and solve() are those of K with these terms. Collective. */
    void set_slip(const std::vector<NodeSlip<dim>> &slipping) { sweeps.set_slip(slipping); }

    /** P^-1 on the free directions, in Cartesian components. */
    void vmult(Vector &destination, const Vector &source) const;

    double start(const Vector &residual) const override;
    Report
    solve(Vector &correction, double reduction, unsigned int maximum_iterations) const override;

  private:
    mutable NodeSweeps<dim, block_size> sweeps;
    mutable RoughGmres                  gmres;
    mutable std::vector<float>          solution, residual; ///< iterates, besides the direction p
    mutable double                      scale = 1.; ///< the right-hand side is that much larger
    mutable std::vector<double>         squares;    ///< r'r of each part

    Report conjugate_gradients(double reduction, unsigned int maximum_iterations) const;
    /** The new iterates of a part: x += step t, r -= step (t + y), p = r + kept p. */
    void advance(unsigned int part, float step, float kept) const;
    /** Leave out parts with squares that are not larger. */
    void leave_out(double accepted) const;
  };
} // namespace signorini

#endif
