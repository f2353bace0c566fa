// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/system/start_equilibrium.h>
#include <signorini/system/step_friction.h>

namespace signorini
{
  namespace
  {
    /** The law of each contact node; its past slip points along the velocity of sliding. */
    template <int dim>
    Friction friction_of_nodes(const StepFriction<dim>       &friction,
                               const ContactCoordinates<dim> &coordinates,
                               const NormalGap               &gap,
                               const Vector                  &velocity,
                               const double                   speed,
                               const double                   body_size)
    {
      if (!friction.any())
        return {};
      Friction laws     = friction.of_step(1., gap, touching_distance(body_size), nullptr);
      Vector   relative = velocity;
      coordinates.displacement_to_contact(relative);
      for (FrictionNode &node : laws)
        {
          for (unsigned int j = 0; j < node.entries.size(); ++j)
            node.past[j] = relative.local_element(node.entries[j]);
          node.slides = node.past.norm() > 1e-10 * speed;
          // So far that the displacements of the equilibrium do not turn it.
          node.past *= node.slides ? 1e8 * body_size / node.past.norm() : 0.;
        }
      return laws;
    }


    template <int dim>
    void set_forces(const StepFriction<dim>       &friction,
                    const ContactCoordinates<dim> &coordinates,
                    const Friction                &laws,
                    const StaticSolution          &equilibrium,
                    const LinearOperator          &matrix,
                    State                         &state)
    {
      const ActiveSet &status = equilibrium.status;
      state.contact_force     = coordinates.normal_reaction(status, equilibrium.residual);
      coordinates.force_to_cartesian(state.contact_force);
      if (!friction.any())
        return;
      IncrementSolution solution;
      friction.extract(laws,
                       status,
                       equilibrium.increment,
                       equilibrium.residual,
                       matrix,
                       false,
                       solution,
                       StepFriction<dim>::SlipForces::of_residual);
      coordinates.force_to_cartesian(solution.friction_reaction);
      state.contact_force += solution.friction_reaction;
      state.friction.force = solution.friction_reaction;
      for (Vector *slip : {&state.friction.slip, &state.friction.accumulated_slip})
        slip->reinit(state.displacement); // zero: slip counts from here
      state.friction.slip_path.assign(status.size(), 0.);
      state.friction.status = solution.status;
    }
  } // namespace


  template <int dim>
  StartReport start_in_equilibrium(const Discretization<dim>     &discretization,
                                   const ContactSurface<dim>     &surface,
                                   const ContactCoordinates<dim> &coordinates,
                                   const SolverParameters        &parameters,
                                   const Vector                  *load,
                                   const Vector                  *of_obstacles,
                                   State                         &state)
  {
    const ProductCount      before = discretization.matrices().products();
    const StepFriction<dim> friction(
      coordinates, surface.friction_may_come(), discretization.communicator());
    const Vector              nothing    = discretization.make_vector();
    const NormalGap           gap        = surface.normal_gap(nothing);
    const std::vector<double> prescribed = coordinates.dirichlet_values(0.);
    Vector                    velocity   = state.velocity;
    double                    speed      = velocity.linfty_norm();
    if (of_obstacles != nullptr)
      {
        velocity -= *of_obstacles;
        speed = std::max(speed, of_obstacles->linfty_norm());
      }
    const Friction laws = friction_of_nodes(
      friction, coordinates, gap, velocity, speed, discretization.mesh().body_size());

    StaticProblem problem{load != nullptr ? *load : nothing, gap, prescribed, laws};
    problem.near_contact_only = true;
    StaticEquilibrium<dim> equilibrium(discretization, coordinates, parameters, friction.any());
    StaticSolution         solution;
    try
      {
        solution = equilibrium.solve(problem, ActiveSet(gap.size(), contact_status::open));
      }
    catch (const StepError &error)
      {
        throw RunError("Time/Start = equilibrium: " + std::string(error.what())
                       + " Set `Start = given` to begin with undeformed bodies.");
      }
    state.displacement = solution.increment;
    coordinates.displacement_to_cartesian(state.displacement);
    set_forces(friction, coordinates, laws, solution, equilibrium.stiffness_matrix(), state);
    const unsigned int n_products =
      discretization.matrices().products().stiffness - before.stiffness;
    return {n_products, solution.is_held ? "" : equilibrium.unheld_motion(solution)};
  }


#define INSTANTIATE(dim)                                                                           \
  template StartReport start_in_equilibrium(const Discretization<dim> &,                           \
                                            const ContactSurface<dim> &,                           \
                                            const ContactCoordinates<dim> &,                       \
                                            const SolverParameters &,                              \
                                            const Vector *,                                        \
                                            const Vector *,                                        \
                                            State &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
