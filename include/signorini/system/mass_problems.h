// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_mass_problems_h
#define signorini_system_mass_problems_h

#include <signorini/model/mass_parameters.h>
#include <signorini/preconditioners/mass_near_contact.h>
#include <signorini/time/dynamical_system.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>

#include <deal.II/base/timer.h>

namespace signorini
{
  /** What MassProjections::project() is given, and what the system knows about it. */
  struct ProjectionProblem
  {
    const Vector    &free_increment;
    const NormalGap &bounds;
    double           step_size;
    double
         energy_scale; ///< of the motion: the kinetic energy of an error is small compared with it
    bool repeats;      ///< the latest projection once more, with other normals
    bool is_trial;     ///< see MovingContact::let_steps_be_trials()
  };

  /**
   * Everything that is solved with the mass matrix alone: projections of increments and velocities,
   * and accelerations. Operator and preconditioner are made when they are first needed, and live as
   * long as the mesh. The functions are those of MassProjections, and
   * DynamicalSystem::solve_mass().
   */
  template <int dim>
  class MassProblems
  {
  public:
    MassProblems(const Discretization<dim>     &discretization,
                 const ContactSurface<dim>     &surface,
                 const ContactCoordinates<dim> &coordinates,
                 const SolverParameters        &parameters,
                 const MassParameters          &mass_parameters,
                 dealii::TimerOutput           &timer);

    SolveReport
    project(const ProjectionProblem &problem, Vector &correction, Vector &mass_correction);

    /** @param energy_scale of the motion: the kinetic energy of an error is small compared with it
     */
    SolveReport stop_relative_motion(const Vector    &velocity,
                                     const ActiveSet &held,
                                     double           energy_scale,
                                     Vector          &correction,
                                     Vector          &mass_correction);

    Vector solve(const Vector &force);

    /** Per contact node whether the latest projection holds it. */
    std::vector<bool> held_by_projection() const;

  private:
    const Discretization<dim>     &discretization;
    const ContactSurface<dim>     &surface;
    const ContactCoordinates<dim> &coordinates;
    const double                   tolerance; ///< see SolverParameters
    const MassParameters           mass_parameters;
    dealii::TimerOutput           &timer;

    std::unique_ptr<StepOperator<dim>>    mass;
    std::unique_ptr<MaskedPreconditioner> preconditioner; ///< of all nodes
    MassNearContact<dim>                  near_contact;
    PrimalDualActiveSet                   solver;
    ActiveSet    projected;          ///< nodes that the last projection held that was no identity
    bool         is_identity = true; ///< the latest one
    Vector       last_correction, last_residual; ///< c and -M c of the latest that was no identity
    unsigned int last_neighbourhood = 0; ///< where they were found: MassNearContact::number()

    void prepare();

    /** Entries of contact nodes in contact coordinates, and about what a correction is there. */
    using Corrections = std::vector<std::pair<unsigned int, double>>;
    /** Norm in the mass matrix, about. Collective. */
    double size_of(const Corrections &corrections) const;
    /** Where they are solved for. @param size see size_of() */
    void surround(const Corrections &corrections, double size, double accepted);

    /** A ConstrainedProblem with the mass, without forces, near contact. */
    struct NearContact
    {
      const std::vector<unsigned int> &bounded;
      const std::vector<double>       &bounds;
      const std::vector<unsigned int> &fixed;
      const std::vector<double>       &values;
      double                           accepted;
      double                           bound_tolerance = 0.;
      bool                             continues       = false;
      bool                             is_trial        = false;
      bool                             knows_residual  = false;
    };
    /** The neighbourhood becomes larger until nothing outside of it is missed. */
    SolveReport solve_near_contact(const NearContact &problem,
                                   ActiveSet         &active,
                                   Vector            &correction,
                                   Vector            &residual);


    /**
     * The projection. @param left bounds of the correction @param continues whether the latest one
     * is nearly this one
     */
    SolveReport project_at_once(const ProjectionProblem &problem,
                                const NormalGap         &left,
                                bool                     continues,
                                Vector                  &correction,
                                Vector                  &mass_correction);
    /** The projection node by node with the lumped mass: obstacles only. */
    SolveReport
    project_node_by_node(const NormalGap &left, Vector &correction, Vector &mass_correction);
    /**
     * The entries `fixed` of `vector`; zero elsewhere. All others hold the error of the solver
     * only.
     */
    void keep_only(const std::vector<unsigned int> &fixed, Vector &vector) const;
  };
} // namespace signorini

#endif
