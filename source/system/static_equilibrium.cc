// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/preconditioners/preconditioners.h>
#include <signorini/system/scales.h>
#include <signorini/system/static_equilibrium.h>
#include <signorini/variational_inequality/frictional_newton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    constexpr unsigned int maximum_steps = 200;

    /** The definite problem of every proximal step, (A + sigma M) u = b with contact. */
    template <int dim>
    class ProximalProblem
    {
    public:
      ProximalProblem(const Discretization<dim>     &discretization,
                      const ContactCoordinates<dim> &coordinates,
                      const SolverParameters        &parameters,
                      const double                   sigma)
        : parameters(parameters)
        , coordinates(coordinates)
        , matrix(discretization.matrices(), coordinates, {sigma, 1.})
        , solver(parameters.limits)
        , prescribed(coordinates.dirichlet_values(0.))
        , bound_tolerance(1e-12 * discretization.mesh().body_size())
      {
        PreconditionerKind kind = parameters.preconditioner;
        if (kind == PreconditionerKind::automatic)
          kind = choose_preconditioner(discretization.mesh().courant_number(1. / std::sqrt(sigma)),
                                       maximum_steps);
        preconditioner =
          make_preconditioner(kind, discretization.matrices(), coordinates, {sigma, 1.});
      }

      /**
       * @param force              b, Cartesian
       * @param solution, residual in contact coordinates, the former also a guess
       */
      void solve(Vector           force,
                 const NormalGap &gap,
                 const Friction  &laws,
                 ActiveSet       &status,
                 Vector          &solution,
                 Vector          &residual)
      {
        coordinates.force_to_contact(force);
        if (tolerance < 0.)
          tolerance =
            1e-2 * parameters.tolerance
            * response_size(
              matrix, *preconditioner, force, coordinates.dirichlet_entries(), prescribed);
        solver.solve({matrix,
                      *preconditioner,
                      force,
                      coordinates.normal_entries(),
                      gap,
                      coordinates.dirichlet_entries(),
                      prescribed,
                      tolerance,
                      bound_tolerance,
                      laws},
                     status,
                     solution,
                     residual);
      }

    private:
      const SolverParameters               &parameters;
      const ContactCoordinates<dim>        &coordinates;
      const StepOperator<dim>               matrix;
      std::unique_ptr<MaskedPreconditioner> preconditioner;
      FrictionalNewton                      solver;
      const std::vector<double>             prescribed;
      const double                          bound_tolerance;
      double                                tolerance = -1.; ///< known with the first force
    };


    /**
     * Take free motions out of a change of the displacement. @return the largest of their
     * amplitudes
     */
    double
    take_out(const std::vector<Motion> &free, const double sigma, Motion &change, Vector &balance)
    {
      double largest = 0.;
      for (const Motion &mode : free)
        {
          const double amplitude = dot(change.momentum, mode.displacement);
          largest                = std::max(largest, std::abs(amplitude));
          change.displacement.add(-amplitude, mode.displacement);
          change.momentum.add(-amplitude, mode.momentum);
          balance.add(-sigma * amplitude, mode.momentum);
        }
      return largest;
    }


    /** In the norm of M. */
    double size_of(const Motion &motion)
    {
      return std::sqrt(std::max(0., dot(motion.momentum, motion.displacement)));
    }
  } // namespace


  template <int dim>
  StaticEquilibrium<dim>::StaticEquilibrium(const Discretization<dim>     &discretization,
                                            const ContactSurface<dim>     &surface,
                                            const ContactCoordinates<dim> &coordinates,
                                            const SolverParameters        &parameters)
    : discretization(discretization)
    , surface(surface)
    , coordinates(coordinates)
    , parameters(parameters)
    , friction(coordinates, discretization.communicator())
  {
  }


  template <int dim>
  unsigned int StaticEquilibrium<dim>::find(State &state, const Vector *load)
  {
    // Small compared with the lowest frequency of compact bodies.
    const double          sigma = std::pow(0.1 * discretization.mesh().lowest_frequency(), 2);
    ProximalProblem<dim>  problem(discretization, coordinates, parameters, sigma);
    const RigidModes<dim> rigid(discretization, coordinates);

    const Vector    zero = discretization.make_vector();
    const NormalGap gap  = surface.normal_gap(zero);
    const Friction  laws = friction_of_nodes(gap, state.velocity);
    ActiveSet       status(gap.size(), contact_status::open);
    Vector          balance  = load != nullptr ? *load : zero; // f - M a
    Vector          solution = zero, residual = zero;
    Motion          now{zero, zero};
    for (unsigned int step = 1; step <= maximum_steps; ++step)
      {
        Vector force = balance;
        force.add(sigma, now.momentum);
        problem.solve(std::move(force), gap, laws, status, solution, residual);

        Motion change    = now;
        now.displacement = solution;
        coordinates.displacement_to_cartesian(now.displacement);
        discretization.matrices().apply_mass(now.momentum, now.displacement);
        change.displacement.sadd(-1., 1., now.displacement);
        change.momentum.sadd(-1., 1., now.momentum);

        // What drives a free motion becomes its acceleration; the rest of the change tells how far
        // the equilibrium is.
        const std::vector<Motion> free       = rigid.free_of(coordinates.held_entries(status));
        const double              driven     = take_out(free, sigma, change, balance);
        const double              unbalanced = std::hypot(size_of(change), driven);
        if (unbalanced <= 1e-12 * size_of(now))
          {
            for (const Motion &mode : free)
              now.displacement.add(-dot(now.momentum, mode.displacement), mode.displacement);
            state.displacement = now.displacement;
            set_forces(state, laws, status, solution, residual);
            return step;
          }
      }
    throw RunError("Time/Start = equilibrium: no static equilibrium was found in "
                   + std::to_string(maximum_steps)
                   + " iterations. Loads may tip a body over, or roll it. Set `Start = given` to "
                     "begin with undeformed bodies.");
  }


  template <int dim>
  Friction StaticEquilibrium<dim>::friction_of_nodes(const NormalGap &gap,
                                                     const Vector    &velocity) const
  {
    if (!friction.any())
      return Friction(gap.size());
    Friction laws =
      friction.of_step(1., gap, touching_distance(discretization.mesh().body_size()), nullptr);
    Vector relative = velocity;
    coordinates.displacement_to_contact(relative);
    const double speed = relative.linfty_norm();
    for (FrictionNode &node : laws)
      {
        for (unsigned int j = 0; j < node.entries.size(); ++j)
          node.past[j] = relative.local_element(node.entries[j]);
        // So far that the displacements of the equilibrium do not turn it.
        node.past *=
          node.past.norm() > 1e-10 * speed ? 1e8 * discretization.mesh().body_size() / speed : 0.;
      }
    return laws;
  }


  template <int dim>
  void StaticEquilibrium<dim>::set_forces(State           &state,
                                          const Friction  &laws,
                                          const ActiveSet &status,
                                          const Vector    &increment,
                                          const Vector    &residual) const
  {
    state.contact_force = coordinates.normal_reaction(status, residual);
    coordinates.force_to_cartesian(state.contact_force);
    if (!friction.any())
      return;
    IncrementSolution solution;
    friction.extract(laws, status, increment, residual, false, solution);
    coordinates.force_to_cartesian(solution.friction_reaction);
    state.contact_force += solution.friction_reaction;
    state.friction.force = solution.friction_reaction;
    state.friction.slip  = state.friction.accumulated_slip =
      discretization.make_vector(); // slip counts from here
    state.friction.slip_path.assign(status.size(), 0.);
    state.friction.status = solution.status;
  }


  template class StaticEquilibrium<2>;
  template class StaticEquilibrium<3>;
} // namespace signorini
