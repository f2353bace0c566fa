// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/reference_integration.h>
#include <signorini/schemes/support_forces.h>

#include <deal.II/lac/la_parallel_block_vector.h>

#include <deal.II/sundials/arkode.h>

#include <arkode/arkode_arkstep.h>

namespace signorini
{
  namespace
  {
    /** u, and tau v: both lengths, so that one tolerance fits both. */
    using Motion = dealii::LinearAlgebra::distributed::BlockVector<double>;

    /** Of the accelerations in one step of the run. */
    constexpr unsigned long maximum_evaluations = 5000000;


    /** The motion as an ordinary differential equation. */
    class Equation
    {
    public:
      Equation(DynamicalSystem &system, const State &start, const double unit_of_time)
        : system(system)
        , massless_nodes(*system.capabilities().massless_nodes)
        , massless(massless_nodes.massless_entries())
        , guess(start.displacement)
        , unit_of_time(unit_of_time)
      {
      }

      void right_hand_side(const double time, const Motion &motion, Motion &derivative)
      {
        Vector load = system.make_vector(), contact_force;
        system.add_load(load, 1., time);
        effort =
          massless_nodes.equilibrate_massless(complete(motion.block(0)), load, contact_force);
        Vector force = system.make_vector();
        system.apply_stiffness(force, guess);
        force.sadd(-1., 1., load);
        force += contact_force; // it acts on nodes with mass, too: those of the other body
        derivative.block(0).equ(1. / unit_of_time, motion.block(1));
        derivative.block(1).equ(unit_of_time, system.solve_mass(force));
      }

      /** The displacement in equilibrium at a time, and the contact force. */
      Vector equilibrium(const double time, const Vector &displacement, Vector &contact_force)
      {
        Vector load = system.make_vector();
        system.add_load(load, 1., time);
        effort = massless_nodes.equilibrate_massless(complete(displacement), load, contact_force);
        return guess;
      }

      SolveReport effort; ///< of the last equilibrium

    private:
      DynamicalSystem                &system;
      MasslessNodes                  &massless_nodes;
      const std::vector<unsigned int> massless;
      Vector                          guess; ///< the last equilibrium: massless nodes begin with it
      const double                    unit_of_time;

      /** Nodes with mass as given, the others as they were last. */
      Vector &complete(const Vector &displacement)
      {
        std::vector<double> kept;
        for (const unsigned int i : massless)
          kept.push_back(guess.local_element(i));
        guess = displacement;
        for (unsigned int k = 0; k < massless.size(); ++k)
          guess.local_element(massless[k]) = kept[k];
        return guess;
      }
    };


    /** u and tau v at the start of a step; what massless nodes do is no part of the equation. */
    Motion motion_at_start(DynamicalSystem                 &system,
                           const State                     &state,
                           const double                     tau,
                           const std::vector<unsigned int> &massless)
    {
      Motion motion(2);
      motion.block(0) = state.displacement;
      motion.block(1).reinit(state.velocity);
      motion.block(1).equ(tau, state.velocity);
      if (const MovingDirichletConditions *dirichlet = system.capabilities().moving_dirichlet;
          dirichlet != nullptr)
        dirichlet->stop_at_dirichlet(motion.block(1));
      for (const unsigned int i : massless)
        motion.block(1).local_element(i) = 0.;
      motion.collect_sizes();
      return motion;
    }


    /**
     * From the start of a step to its end. @param tolerance of each step of the integrator,
     * relative
     */
    void integrate(Equation    &equation,
                   Motion      &motion,
                   const double start_time,
                   const double tau,
                   const double tolerance,
                   const double length)
    {
      using Integrator = dealii::SUNDIALS::ARKode<Motion>;
      Integrator::AdditionalData data;
      data.initial_time       = start_time;
      data.final_time         = start_time + tau;
      data.output_period      = tau;
      data.initial_step_size  = tau / 20.;
      data.minimum_step_size  = 1e-12 * tau;
      data.maximum_order      = 5;
      data.relative_tolerance = tolerance;
      data.absolute_tolerance = tolerance * std::max(motion.block(1).linfty_norm(), 1e-8 * length);
      Integrator integrator(data, motion.block(0).get_mpi_communicator());

      // Exceptions must not pass through SUNDIALS, and deal.II's wrapper looks at failures of
      // SUNDIALS by assertions only: it would go on for ever, or with a wrong result. So nothing
      // fails: after an exception nothing moves any more, until the end of the step is reached.
      std::exception_ptr failure;
      unsigned long      n_evaluations = 0;
      integrator.explicit_function =
        [&](const double time, const Motion &y, Motion &derivative) -> int {
        try
          {
            if (++n_evaluations > maximum_evaluations)
              throw StepError("Time/Scheme: the integrator ARKODE does not get to the end of the "
                              "step. Use a smaller step size, or a larger Reference tolerance.");
            if (!failure)
              equation.right_hand_side(time, y, derivative);
          }
        catch (...)
          {
            failure = std::current_exception();
          }
        if (failure)
          derivative = 0.;
        return 0;
      };
      integrator.custom_setup = [](void *memory) {
        ARKStepSetMaxNumSteps(memory, maximum_evaluations);
      };
      integrator.solve_ode(motion);
      if (failure)
        std::rethrow_exception(failure);
    }

    /** What holds the prescribed entries at an instant: M a + A u - f - r there. */
    Vector support_force(DynamicalSystem &system, const State &state)
    {
      Vector force = system.make_vector(), mass_times_acceleration = system.make_vector();
      system.add_load(force, 1., state.time);
      force += state.contact_force;
      force -= state.internal_force;
      system.apply_mass(mass_times_acceleration, system.solve_mass(force));
      mass_times_acceleration -= force;
      return dirichlet_part(system, mass_times_acceleration);
    }
  } // namespace


  ReferenceIntegration::ReferenceIntegration(const double tolerance)
    : tolerance(tolerance)
  {
  }


  TakenStep
  ReferenceIntegration::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    Equation   equation(system, start, tau);
    const auto massless = massless_entries(system);
    Motion     motion   = motion_at_start(system, start, tau, massless);
    integrate(equation, motion, start.time, tau, tolerance, system.length());

    Vector contact_force;
    Vector increment = equation.equilibrium(start.time + tau, motion.block(0), contact_force);
    increment -= start.displacement;
    Vector velocity_change = motion.block(1);
    velocity_change /= tau;
    for (const unsigned int i : massless)
      velocity_change.local_element(i) = increment.local_element(i) / tau;
    velocity_change -= start.velocity;

    StepReport report;
    report.corrector = equation.effort;
    State end =
      end_of_step(system, start, tau, increment, velocity_change, std::move(contact_force));
    if (system.capabilities().moving_dirichlet != nullptr)
      add_support_force(system, 1., support_force(system, end), report);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
