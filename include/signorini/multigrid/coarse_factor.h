// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_coarse_factor_h
#define signorini_multigrid_coarse_factor_h

#include <signorini/multigrid/held_correction.h>

#include <Eigen/SparseCholesky>

namespace signorini
{
  /** The factor of a M + b A on the coarsest level: all of it on each process. */
  template <int dim>
  class CoarseFactor
  {
  public:
    /** Collective. @param scale see LevelMatrix */
    CoarseFactor(const ElasticMatrices<dim> &matrices, const MatrixSum &sum, double scale);

    /** Factor anew with what held entries change. Collective. */
    template <typename Number>
    void set_correction(const HeldCorrection<dim, Number> &correction);

    /** Collective. */
    template <typename Number>
    void solve(const LevelVector<Number> &right_hand_side, LevelVector<Number> &solution) const;

  private:
    /** Numbers only, so that they travel byte by byte. */
    struct Entry
    {
      double       value;
      unsigned int row, column;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &value &row &column;
      }
    };
    using Entries = std::vector<Entry>;

    const MPI_Comm                                     communicator;
    unsigned int                                       first_owned; ///< entry
    Eigen::SparseMatrix<double>                        matrix;      ///< lower triangle
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;

    /** The matrix of the entries of all processes, which may come more than once. */
    Eigen::SparseMatrix<double> gather(const Entries &own) const;
  };
} // namespace signorini

#endif
