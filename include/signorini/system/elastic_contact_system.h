// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_elastic_contact_system_h
#define signorini_system_elastic_contact_system_h

#include <signorini/discretization/loads.h>
#include <signorini/system/first_guess.h>
#include <signorini/system/mass_problems.h>
#include <signorini/system/massless_equilibrium.h>
#include <signorini/system/motion_energies.h>
#include <signorini/system/static_equilibrium.h>
#include <signorini/system/step_contact.h>
#include <signorini/system/step_friction.h>
#include <signorini/system/step_matrices.h>
#include <signorini/variational_inequality/constrained_solver.h>

#include <deal.II/base/timer.h>

#include <functional>

namespace signorini
{
  /** What a system is told besides mesh, contact and loads. */
  struct SystemParameters
  {
    SolverParameters solver;
    MassParameters   mass;
    unsigned int     mesh_life_time = 1; ///< see PreconditionerChoice
  };

  /**
   * Elastic bodies, their contact and the solver, as a time scheme sees them. The only place where
   * discretisation, contact, inequalities and time meet.
   */
  template <int dim>
  class ElasticContactSystem : public DynamicalSystem,
                               private MassProjections,
                               private NodalImpulses,
                               private MasslessNodes,
                               private MovingDirichletConditions,
                               private ViscousDamping,
                               private StaticProblems
  {
  public:
    ElasticContactSystem(const Discretization<dim>     &discretization,
                         const ContactSurface<dim>     &surface,
                         const ContactCoordinates<dim> &coordinates,
                         Loads<dim>                    &loads,
                         const SystemParameters        &parameters,
                         dealii::TimerOutput           &timer);

    Vector    make_vector() const override { return discretization.make_vector(); }
    void      apply_mass(Vector &destination, const Vector &source) const override;
    void      apply_stiffness(Vector &destination, const Vector &source) const override;
    void      add_load(Vector &destination, double factor, double time) override;
    NormalGap normal_gap(const Vector &displacement) const override
    {
      return surface.normal_gap(displacement);
    }
    NormalGap relative_normal(const Vector &motion) const override
    {
      return surface.relative_normal(motion);
    }
    NormalGap    own_normal_forces(const Vector &nodal_forces) const override;
    double       length() const override { return discretization.mesh().body_size(); }
    void         solve(const IncrementProblem &problem, IncrementSolution &solution) override;
    Vector       solve_mass(const Vector &force) override { return mass_problems.solve(force); }
    Capabilities capabilities() override
    {
      return {this,
              this,
              has_massless_nodes ? this : nullptr,
              has_dirichlet ? this : nullptr,
              is_damped ? this : nullptr,
              this,
              step_contact.get()};
    }

    /**
     * Contact is that of the motion of each step from now on. The surface and the coordinates are
     * those of the constructor, and turn.
     */
    void let_contact_follow(const DirichletConditions<dim> &dirichlet,
                            ContactSurface<dim>            &moving_surface,
                            ContactCoordinates<dim>        &moving_coordinates);

    /** To be told each problem that solve() has solved, in the contact coordinates of then. */
    using Listener = std::function<void(const IncrementProblem &, const IncrementSolution &)>;
    void show_problems_to(Listener new_listener) { listener = std::move(new_listener); }

    /** Tell the energies of the motion; the largest so far are the scale of accepted errors. */
    void see(const MotionEnergies &energies) { largest_energies.add(energies); }

    /** Contact is where the state has it; the next problem begins with that. */
    void expect_contact_as_in(const State &state) { first_guess.status(state, active); }

    /** The largest energies of the motion so far. */
    const MotionEnergies &energies() const { return largest_energies; }

    /** Matrix-vector products so far in words. */
    std::string cost_summary() const;

  private:
    const Discretization<dim>     &discretization;
    const ContactSurface<dim>     &surface;
    const ContactCoordinates<dim> &coordinates;
    const bool                     has_massless_nodes, has_dirichlet, is_damped; ///< on any process
    Loads<dim>                    &loads;
    const SystemParameters         parameters;
    dealii::TimerOutput
      &timer; ///< one section per part of a step, so that work that was skipped can be seen

    MotionEnergies                            largest_energies;
    const FirstGuess<dim>                     first_guess;
    const StepFriction<dim>                   friction;
    StepMatrices<dim>                         step_matrices;
    std::unique_ptr<MasslessEquilibrium<dim>> massless_equilibrium;
    std::unique_ptr<StaticEquilibrium<dim>>   static_equilibrium;
    unsigned int                              turns_of_statics = 0; ///< of the coordinates, then
    MassProblems<dim>                         mass_problems;
    std::unique_ptr<ConstrainedSolver>        solver;
    ActiveSet                                 active;
    std::unique_ptr<StepContact<dim>>         step_contact; ///< null: contact is linearised
    Listener                                  listener;

    Vector      normal_forces(const std::vector<double> &forces) const override;
    SolveReport project(const Vector    &free_increment,
                        const NormalGap &bounds,
                        double           step_size,
                        Vector          &correction,
                        Vector          &mass_correction) override
    {
      return mass_problems.project({free_increment,
                                    bounds,
                                    step_size,
                                    largest_energies.motion,
                                    step_contact && step_contact->repeats(),
                                    step_contact && step_contact->steps_are_trials()},
                                   correction,
                                   mass_correction);
    }
    SolveReport stop_relative_motion(const Vector    &velocity,
                                     const ActiveSet &held,
                                     Vector          &correction,
                                     Vector          &mass_correction) override
    {
      return mass_problems.stop_relative_motion(
        velocity, held, largest_energies.motion, correction, mass_correction);
    }

    std::vector<unsigned int> massless_entries() const override;

    SolveReport
    equilibrate_massless(Vector &displacement, const Vector &load, Vector &contact_force) override;

    void equilibrate(const LoadStep &step, IncrementSolution &solution) override;

    /** The solver of static problems, in the contact coordinates of now. */
    StaticEquilibrium<dim> &statics();
    Friction                laws_of_load_step(const NormalGap &bounds) const;

    void   stop_at_dirichlet(Vector &velocity) const override;
    Vector dirichlet_part(const Vector &forces) const override;
    void   apply_damping(Vector &destination, const Vector &velocity) const override;

    /**
     * The first guess of an increment in contact coordinates, and where it is active.
     * @param residual b - K increment, if it is known without a product
     * @return whether it is: the step is made again
     */
    bool guess(const IncrementProblem &problem,
               StepMatrix<dim>        &matrix,
               const Vector           &right_hand_side,
               Vector                 &increment,
               Vector                 &residual);

    /** What is left to go to the prescribed displacements, per prescribed entry. */
    std::vector<double> prescribed_increments(const State &start, double step_size) const;

    /**
     * The reactions of a problem whose statuses are `active`, and the increment, in Cartesian
     * components.
     * @param drag     what the increment is to get besides slip; empty: nothing
     * @param solution with the increment in contact coordinates
     */
    void extract(const Friction       &friction_of_nodes,
                 const Vector         &residual,
                 const LinearOperator &matrix,
                 bool                  pressed_from_elsewhere,
                 const Vector         &drag,
                 IncrementSolution    &solution) const;

    /**
     * Accepted error in the norm of K: its energy, seen as one of velocity, is tolerance^2 times
     * MotionEnergies::scale().
     */
    double solver_tolerance(const StepMatrix<dim>     &matrix,
                            double                     step_size,
                            const Vector              &right_hand_side,
                            const std::vector<double> &prescribed) const;
  };
} // namespace signorini

#endif
