// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_condensation_condensed_contact_h
#define signorini_condensation_condensed_contact_h

#include <signorini/condensation/dense_operators.h>
#include <signorini/condensation/nodal_factor.h>
#include <signorini/contact/contact_coordinates.h>
#include <signorini/variational_inequality/constrained_solver.h>

#include <optional>

namespace signorini
{
  /**
   * Solves the inequality of a step for the nodes that may be in contact, with everything else
   * eliminated by a Cholesky factor: a small full problem, solved as any other one, between half a
   * solution with the factor before and another half after. The norm of the small matrix is that of
   * the large one, so that tolerances mean the same.
   *
   * Where the time step is long, round-off of the factor is more than is accepted. Then the same is
   * done once more for the residual, which products tell more accurately: they know that rigid
   * translations have no stress.
   *
   * The factor stays as long as the matrix does. It has those nodes at its end that are closed,
   * some that are next to the other side, and what moves it there (partners). If others turn out to
   * be beyond their bounds it is made anew, with these as well. On one process.
   */
  template <int dim>
  class CondensedContact : public ConstrainedSolver
  {
  public:
    /**
     * All must outlive the object.
     * @param sum   of matrices: K in Cartesian components
     * @param small solves the small problems
     */
    CondensedContact(const ElasticMatrices<dim>        &matrices,
                     const ContactCoordinates<dim>     &coordinates,
                     const MatrixSum                   &sum,
                     std::unique_ptr<ConstrainedSolver> small);

    SolveReport solve(const ConstrainedProblem &problem,
                      ActiveSet                &active,
                      Vector                   &solution,
                      Vector                   &residual) override;

    /** How many factors were made so far. */
    unsigned int n_factors() const { return factors_made; }

  private:
    const ElasticMatrices<dim>              &matrices;
    const ContactCoordinates<dim>           &coordinates;
    const MatrixSum                          sum;
    const std::unique_ptr<ConstrainedSolver> small;
    std::vector<char>                        prescribed;           ///< Cartesian components
    const double                             diagonal_over_matrix; ///< see error_bound()
    std::vector<unsigned int>                nodes; ///< at the end of the factor, ascending
    std::vector<unsigned int>                place; ///< of a node among them, or none
    std::unique_ptr<NodalFactor<dim>>        factor;
    unsigned int                             factors_made = 0;

    /** Of the small problem. */
    struct SmallMatrix
    {
      explicit SmallMatrix(Eigen::MatrixXd matrix)
        : entries(std::move(matrix))
        , product(entries)
        , inverse(entries)
      {
      }

      const Eigen::MatrixXd entries;
      DenseOperator         product;
      DenseInverse          inverse;
    };

    /** Contact coordinates of these nodes to Cartesian ones, and when that was so. */
    Eigen::SparseMatrix<double> to_cartesian;
    unsigned int                known_turns = 0;
    std::optional<SmallMatrix>  matrix;
    Vector                      work, diagonal;

    /** Closed nodes, those beyond their bounds, and those that may stick without being closed. */
    std::vector<unsigned int> nodes_at_bounds(const ConstrainedProblem &problem,
                                              const ActiveSet          &active,
                                              const Vector             &solution) const;
    std::vector<unsigned int> with_partners(std::vector<unsigned int> needed) const;
    bool                      has(const std::vector<unsigned int> &needed) const;
    /** A factor with these contact nodes, and some that are nearest to their bounds. */
    void                        choose_nodes(const ConstrainedProblem        &problem,
                                             const std::vector<unsigned int> &needed,
                                             const Vector                    &solution);
    Eigen::SparseMatrix<double> contact_to_cartesian();
    /** The small matrix in contact coordinates as they are now. */
    void turn();

    /** Of the error in the norm of K that free entries of the residual stand for. */
    double
    error_bound(const ConstrainedProblem &problem, const ActiveSet &active, const Vector &residual);

    /** By entries of the small problem, for a step from a start. */
    struct SmallProblem
    {
      std::vector<std::size_t>  numbers; ///< of the bounded entries in the problem
      std::vector<unsigned int> bounded, fixed;
      std::vector<double>       bounds;
      Friction                  friction;
      ActiveSet                 statuses;
    };
    SmallProblem
    small_problem(const ConstrainedProblem &problem, const Vector &start, ActiveSet &active) const;
    FrictionNode small_friction(FrictionNode node, const Vector &start) const;

    /** @param residual of the start */
    SolveReport solve_small(const ConstrainedProblem &problem,
                            const Vector             &start,
                            const Vector             &residual,
                            ActiveSet                &active,
                            Vector                   &solution);

    unsigned int small_entry(const unsigned int entry) const
    {
      return dim * place[entry / dim] + entry % dim;
    }
  };
} // namespace signorini

#endif
