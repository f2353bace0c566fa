// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_slip_system_h
#define signorini_variational_inequality_slip_system_h

#include <signorini/linear_algebra/gmres.h>
#include <signorini/variational_inequality/constrained_problem.h>

namespace signorini
{
  /**
   * The linear system of a Newton step in which some nodes slip: below the rows of K x + forces =
   * b, the tangential rows of these nodes contain their linearised law (SlipCondition),
   *
   *   (K x)_t + t + Q dx_t + q dn = b_t,    dn = -(K dx)_n.
   *
   * The matrix K is not modified; these rows get their terms behind each product. The
   * preconditioner is that of K; directions that slip makes stiff (a small slip that is about to
   * turn) are scaled down in it. Solved by GMRES, in single precision and refined where the
   * preconditioner can do that, or without q by conjugate gradients.
   */
  class SlipSystem
  {
  public:
    void clear() { slipping.clear(); }

    /**
     * @param normal    bounded entry of the node
     * @param node      must outlive the system
     * @param stiffness of the node in K, for the scaling
     */
    void add(unsigned int         normal,
             const FrictionNode  &node,
             const SlipCondition &condition,
             double               stiffness);

    /** Agree with the other processes; to be called after the last add(). Collective. */
    void finish(MPI_Comm communicator);

    /**
     * Whether a node slips with friction, and whether the direction of a slip may turn, on any
     * process.
     */
    bool any() const { return any_slip; }
    bool any_turning() const { return may_turn; }

    /**
     * Solve for the correction dx, in the free entries of the problem's preconditioner.
     * @param residual   b - K x on entry, b - K (x + dx) on exit
     * @param limits_for given the norm of what is unbalanced at the start
     */
    LinearReport solve(const ConstrainedProblem &problem,
                       Vector                   &residual,
                       Vector                   &correction,
                       const LimitsFor          &limits_for);

    /**
     * The same where no law depends on the normal force (q = 0) and Q is symmetric and has no
     * negative curvature. @param tolerance, reduction see ConjugateGradients
     */
    LinearReport solve_symmetric(const ConstrainedProblem &problem,
                                 Vector                   &residual,
                                 Vector                   &correction,
                                 double                    tolerance,
                                 double                    reduction,
                                 unsigned int              maximum_iterations);

    /**
     * The forces that the linearised laws gave in the last solve, in the order of add(). They are
     * better than the residual in these rows, which also holds the error of a rough solve.
     */
    const std::vector<TangentVector> &forces() const { return law_forces; }

    /** Norm of what was unbalanced at the start of the last solve(). */
    double initial_norm() const { return norm_at_start; }

    /** What round-off of the last solve has left in the residual, as a norm; 0: nothing slips. */
    double round_off() const { return any_slip ? lost : 0.; }

  private:
    struct Node
    {
      unsigned int        normal;
      const FrictionNode *friction;
      SlipCondition       condition;
      double              stiffness; ///< of the node
      TangentMatrix       scaling;   ///< of the preconditioner
    };
    std::vector<Node>          slipping;
    std::vector<TangentVector> law_forces;
    bool                       any_slip = false, may_turn = false, is_stiff = false;
    double                     norm_at_start = 0., lost = 0.;
    Gmres                      gmres;
    Refinement                 refinement;
    ConjugateGradients         conjugate_gradients;
    Vector                     unbalanced;

    class Jacobian;
    class Preconditioner;

    std::vector<SlipRows> rows() const;
    /** What K dx with the terms of the slipping nodes has to be. */
    void unbalance(const Vector &residual);
    /** The forces of the laws after a solve, and the residual with them. */
    void balance(const Vector &correction, Vector &residual);
    /**
     * What the round-off of Q dx is, as a norm. A slip that is next to nothing is next to
     * infinitely stiff across: Q dx is the small difference of large numbers.
     */
    double round_off_of_slip(const Vector &correction) const;
  };

  /** The tangential entries of a node. */
  TangentVector tangential_entries(const FrictionNode &node, const Vector &vector);
  void
  add_to_tangential_entries(const FrictionNode &node, const TangentVector &values, Vector &vector);
} // namespace signorini

#endif
