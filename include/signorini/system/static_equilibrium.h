// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_static_equilibrium_h
#define signorini_system_static_equilibrium_h

#include <signorini/model/run_parameters.h>
#include <signorini/preconditioners/preconditioners.h>
#include <signorini/system/rigid_springs.h>
#include <signorini/time/dynamical_system.h>
#include <signorini/variational_inequality/constrained_solver.h>

#include <optional>

namespace signorini
{
  /** What an increment d of the displacement has to bring into equilibrium, and how it is bound. */
  struct StaticProblem
  {
    const Vector              &force;      ///< b: loads without A u; Cartesian
    const NormalGap           &bounds;     ///< of the normal increments
    const std::vector<double> &prescribed; ///< increments of the prescribed entries
    const Friction            &friction;   ///< with forces as multipliers; empty: none
    double energy = 0.; ///< of the deformations so far, a scale for errors; zero: unknown
    /**
     * Loose bodies follow their loads to contact as far as springs let them that would vibrate with
     * a tenth of the lowest frequency of a compact body; else from any distance.
     */
    bool near_contact_only = false;
  };

  /** In contact coordinates. */
  struct StaticSolution
  {
    Vector          increment;       ///< d
    Vector          residual;        ///< b - M a - A d: the forces that hold constraints, negative
    ActiveSet       status;          ///< of the contact nodes
    Eigen::VectorXd acceleration;    ///< a: amplitudes of the rigid motions, see RigidModes
    bool            is_held = false; ///< a is zero but for round-off
    unsigned int    n_steps = 0;     ///< of the proximal point iteration
    SolveReport     effort;
  };

  /**
   * Static equilibria of all bodies under loads and contact,
   *
   *   A d + M a = b + r,   d.nu <= bounds, r and friction as ever,
   *
   * where a is the acceleration of the rigid motions that nothing holds (neither prescribed nodes
   * nor closed nor sticking ones), and d has no part in them. If loads do not drive these motions,
   * a is zero, and d the least of 1/2 d'A d - b'd. (Free motion stays in d as far as open nodes
   * would else be beyond their bounds, see take_out_motion.)
   *
   * The matrix is A itself, and there is one inequality to solve if Dirichlet conditions hold the
   * bodies. Where they do not, A is singular, and contact may hold what is left. This is a proximal
   * point iteration in the three (2d) or six (3d) amplitudes of each such body: springs anchor its
   * rigid motions where they were,
   *
   *   A d + M Z S Z'M (d - d_last) = b - M a + r,
   *
   * far weaker than contact where there is no friction (so that two or three solutions do), but for
   * the motions that nothing holds: what their springs bear is their inertia. Each solution starts
   * from the last one, so that all of them cost little more than one.
   */
  template <int dim>
  class StaticEquilibrium
  {
  public:
    /** Builds the preconditioner. Collective. @param with_friction any node has friction */
    StaticEquilibrium(const Discretization<dim>     &discretization,
                      const ContactCoordinates<dim> &coordinates,
                      const SolverParameters        &parameters,
                      bool                           with_friction);

    /**
     * Collective.
     * @param status a guess
     * @param start  an increment to begin with; null: none
     * @throws StepError if no equilibrium is found
     */
    StaticSolution
    solve(const StaticProblem &problem, ActiveSet status, const Vector *start = nullptr);

    /**
     * The same near contact and, if nothing holds what is loaded there, farther away. Collective.
     */
    StaticSolution find_held(StaticProblem problem, const ActiveSet &status);

    /** A. */
    const LinearOperator &stiffness_matrix() const { return stiffness; }

    /** What is not held in a solution: bodies and their motions, in words. */
    std::string unheld_motion(const StaticSolution &solution) const;

  private:
    /** Solutions after which a body is taken to slide without end whatever its slip does. */
    static constexpr unsigned int patience_with_slip = 40;

    const Discretization<dim>            &discretization;
    const ContactCoordinates<dim>        &coordinates;
    const SolverParameters                parameters;
    const RigidModes<dim>                 rigid;
    const Eigen::MatrixXd                 loose; ///< motions that no Dirichlet condition holds
    const double                          stiffness_of_springs;
    const StepOperator<dim>               stiffness;
    RigidSprings<dim>                     matrix;
    std::unique_ptr<MaskedPreconditioner> preconditioner;
    const bool                            with_friction; ///< on any process
    const double                          weakness;      ///< of springs where contact holds
    std::unique_ptr<ConstrainedSolver>    solver;
    Vector                                diagonal; ///< of A
    std::unique_ptr<StaticEquilibrium>    smooth;   ///< without friction, once bodies have to land

    /**
     * A basis of the rigid motions that nothing holds: neither conditions nor closed or sticking
     * nodes, nor nodes that slip in directions of their own, as where weight presses a block wider.
     * A side step turns their slip, and friction turns with it; a step backwards stops them.
     * @param drive what would move the bodies
     */
    Eigen::MatrixXd free_motions(const StaticProblem   &problem,
                                 const StaticSolution  &solution,
                                 const Eigen::VectorXd &drive) const;
    /** Those that leave all slip with friction as it is. */
    Eigen::MatrixXd motions_without_slip(const StaticProblem  &problem,
                                         const StaticSolution &solution) const;
    /** Of the springs: weak where contact holds. @param free motions that nothing holds */
    Eigen::MatrixXd springs(const Eigen::MatrixXd &free) const;
    double          tolerance_of_bounds() const;
    /**
     * d = 0, if that is the equilibrium, as where a load is held. With friction the solvers find it
     * with pains: all nodes that have slipped are at the edge between sticking and slipping.
     */
    std::optional<StaticSolution> try_rest(const StaticProblem &problem);
    /**
     * With friction, for bodies that have far to fall: as if there were none first, since the
     * springs that friction needs hold them back.
     */
    StaticSolution land(const StaticProblem &problem, const ActiveSet &status);
    /** Go on from a solution. @param S springs, @param anchor amplitudes where they are at rest */
    void solve_anchored(const StaticProblem   &problem,
                        const Eigen::MatrixXd &S,
                        const Eigen::VectorXd &anchor,
                        double                 tolerance,
                        StaticSolution        &solution);
    /** Norm of the solution, about, in that of K; or that of the deformations so far. */
    double response_to(const StaticProblem &problem);
    /** The largest part that forces on the motions of a body are of all that acts on it. */
    double unbalanced_part(const StaticProblem   &problem,
                           const StaticSolution  &solution,
                           const Eigen::VectorXd &forces) const;
    /** Whether anchors still move after many solutions because of forces that are next to none. */
    bool goes_on_creeping(const StaticProblem   &problem,
                          const StaticSolution  &solution,
                          const Eigen::VectorXd &drive) const;
    /** Whether accelerations are more than round-off and the error of the solution. */
    bool
    is_driven(const StaticProblem &problem, const StaticSolution &solution, double error) const;
  };
} // namespace signorini

#endif
