// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_frictional_newton_h
#define signorini_variational_inequality_frictional_newton_h

#include <signorini/variational_inequality/constrained_solver.h>
#include <signorini/variational_inequality/slip_system.h>
#include <signorini/variational_inequality/status_record.h>
#include <signorini/variational_inequality/tresca_fixed_point.h>

namespace signorini
{
  /**
   * Semismooth Newton method for contact with Coulomb friction: the primal-dual active set method,
   * in which closed nodes also stick or slip. Open nodes are free; sticking ones are held in all
   * entries; slipping ones are held along the normal, and along the tangents they obey their
   * linearised law, which makes these rows of the matrix unsymmetric (SlipSystem). Nothing is
   * penalised or regularised. Without slip the linear systems are symmetric and solved by conjugate
   * gradients.
   *
   * A node that slips against its force stops first, and slips the other way from the next step on;
   * or its force is turned round at once, if not many are. The second is faster where single nodes
   * go to and fro, and never comes to an end where a body does: at first it is tried, until
   * statuses come back.
   *
   * If they come back again or the iterations are used up, a few problems of TrescaFixedPoint lead
   * closer to the solution, where the method begins anew; at last TrescaFixedPoint finishes the
   * work.
   */
  class FrictionalNewton : public ConstrainedSolver
  {
  public:
    explicit FrictionalNewton(const ActiveSetLimits &limits)
      : limits(limits)
    {
    }

    SolveReport solve(const ConstrainedProblem &problem,
                      ActiveSet                &status,
                      Vector                   &solution,
                      Vector                   &residual) override;

  private:
    /** Of the error in a linear solve, while statuses still change. */
    static constexpr double rough_reduction = 5e-2;
    /** The same if the problem is rough: what is left of the guess takes another solution. */
    static constexpr double reduction_of_trial = 1e-2;

    const ActiveSetLimits    limits;
    ConjugateGradients       conjugate_gradients;
    SlipSystem               slip;
    std::vector<std::size_t> slipping; ///< the nodes of `slip`, ascending
    TrescaFixedPoint         fallback;
    Vector                   correction, product;
    double                   tolerance = 0.; ///< that of the problem, or what is attainable
    std::vector<double>      stiffness; ///< of each node: the mean of the diagonal over its entries

    enum class Outcome
    {
      solved,
      undecided, ///< statuses came back, or there were too many iterations
      no_linear_solution
    };
    Outcome outcome = Outcome::undecided; ///< of the latest iterate()
    /** Whether forces turn round at once; until statuses come back. */
    bool turns_at_once = true;

    /** Newton's method. @param continues see ConstrainedProblem */
    SolveReport iterate(const ConstrainedProblem &problem,
                        ActiveSet                &status,
                        Vector                   &solution,
                        Vector                   &residual,
                        bool                      continues);

    /**
     * Put the fixed and held entries to their values, compute the residual, look at statuses.
     * @param continues see ConstrainedProblem: the residual is there, and so are the statuses
     */
    void start(const ConstrainedProblem &problem,
               ActiveSet                &status,
               Vector                   &solution,
               Vector                   &residual,
               bool                      continues);
    /** Whether the nodes that may turn round bear little of all friction. Collective. */
    bool few_turn_round(const ConstrainedProblem &problem,
                        const ActiveSet          &status,
                        const Vector             &solution,
                        const Vector             &residual) const;
    /** The semismooth Newton update of the statuses. @return number of changes on all processes */
    unsigned int update(const ConstrainedProblem &problem,
                        ActiveSet                &status,
                        const Vector             &solution,
                        const Vector             &residual) const;
    /** Move entries that are held from now on to their values and update the residual. */
    void hold(const ConstrainedProblem &problem,
              const ActiveSet          &status,
              Vector                   &solution,
              Vector                   &residual);
    void set_mask(const ConstrainedProblem &problem, const ActiveSet &status);
    void linearise(const ConstrainedProblem &problem,
                   const ActiveSet          &status,
                   const Vector             &solution,
                   const Vector             &residual);
    /**
     * How accurately to solve a linear system: roughly while statuses change; when they have
     * settled, as far as the linearised laws are worth it; fully, if statuses came back.
     */
    enum class Precision
    {
      rough,
      settled,
      full
    };
    /** @return whether rough solutions may be the cause of what went wrong; from now on none are */
    static bool may_be_for_want_of_accuracy(StatusRecord &record, Precision &precision);
    /** Statuses have changed: how accurate to be from now on. @return whether they go in a circle
     */
    bool is_cycle(StatusRecord &record, const ActiveSet &status, Precision &precision);
    /**
     * Solve the linear system.
     * @param last_norm what was unbalanced at the start of the last one
     * @param is_guess  see ConjugateGradients; of no importance where nodes slip
     * @return iterations; zero if all was balanced
     */
    LinearReport step(const ConstrainedProblem &problem,
                      Vector                   &solution,
                      Vector                   &residual,
                      Precision                 precision,
                      double                    last_norm,
                      bool                      is_guess);
  };
} // namespace signorini

#endif
