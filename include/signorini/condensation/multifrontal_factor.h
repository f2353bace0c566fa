// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_condensation_multifrontal_factor_h
#define signorini_condensation_multifrontal_factor_h

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace signorini
{
  /**
   * The Cholesky factor of the first rows and columns of a sparse matrix, and the Schur complement
   * of the others (Duff, Reid, ACM Trans. Math. Softw. 9 (1983) 302). Rows come in nodes, one after
   * another. Nodes whose columns of the factor have the same rows are a panel: they are eliminated
   * together in a full matrix, the front, which adds up what earlier panels leave for its rows.
   */
  class MultifrontalFactor
  {
  public:
    /** Of no matrix. */
    MultifrontalFactor() = default;

    /**
     * @param lower        lower triangle of a symmetric matrix, in the order of elimination
     * @param node_starts  first row of each node, and the number of rows
     * @param n_eliminated number of nodes that are eliminated
     * @throws StepError if their part of the matrix is not definite
     */
    MultifrontalFactor(const Eigen::SparseMatrix<double> &lower,
                       const std::vector<int>            &node_starts,
                       int                                n_eliminated);

    /** Of the rows that are not eliminated, in both triangles. */
    const Eigen::MatrixXd &schur_complement() const { return of_others; }

    /** L^-1 of the eliminated rows; the others lose what is coupled to these. */
    void eliminate(double *values) const;

    /** L^-T of the eliminated rows, with the others known. */
    void substitute(double *values) const;

  private:
    /** Columns of the factor that have their rows in common, each from its diagonal on. */
    struct Panel
    {
      int         n_columns, n_rows;
      std::size_t first_row;    ///< in `rows`
      std::size_t first_number; ///< in `numbers`

      /** Place in `numbers` of the diagonal of a column. */
      std::size_t diagonal(const std::size_t column) const
      {
        return first_number + column * n_rows - column * (column - 1) / 2;
      }
    };
    std::vector<Panel>  panels;
    std::vector<int>    rows;    ///< of panels, one after another; first those of its own columns
    std::vector<double> numbers; ///< column by column, in the order in which they are read
    Eigen::MatrixXd     of_others;

    /** At most `most_columns` columns of a panel: what they read is used for all of them. */
    struct Group
    {
      int         n_columns, n_rows; ///< rows from the first diagonal on
      std::size_t first_row, first_number;
    };
    std::vector<Group> groups;

    static constexpr int most_columns = 4;

    void find_panels(const Eigen::SparseMatrix<double> &lower,
                     const std::vector<int>            &node_starts,
                     int                                n_eliminated);
    void factorise(const Eigen::SparseMatrix<double> &lower, int n_eliminated_rows);

    void find_groups();

    template <int n_columns>
    void eliminate(const Group &group, double *values) const;
    template <int n_columns>
    void substitute(const Group &group, double *values) const;
  };
} // namespace signorini

#endif
