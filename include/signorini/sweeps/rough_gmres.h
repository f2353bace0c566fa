// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_sweeps_rough_gmres_h
#define signorini_sweeps_rough_gmres_h

#include <signorini/linear_algebra/rough_solver.h>

#include <mpi.h>

#include <functional>
#include <vector>

namespace signorini
{
  /**
   * GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856-869) in single precision for a
   * few digits, without a restart: what is left is for the next call. Sums are in double precision.
   */
  class RoughGmres
  {
  public:
    using Vectors = std::vector<float>;
    /** q = A p, and p as it was. */
    using Operator = std::function<void(Vectors &p, Vectors &q)>;

    /**
     * @param right_hand_side of this process, as all vectors
     * @param solution        on exit, from zero
     * @param reduction       of the residual, at which to stop. Collective
     */
    RoughSolver::Report solve(const Operator &matrix,
                              const Vectors  &right_hand_side,
                              Vectors        &solution,
                              double          reduction,
                              unsigned int    maximum_iterations,
                              MPI_Comm        communicator);

  private:
    static constexpr unsigned int most_vectors = 50;

    std::vector<Vectors> basis; ///< kept for the next solve
  };
} // namespace signorini

#endif
