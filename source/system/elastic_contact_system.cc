// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/preconditioners/factor_coordinates.h>
#include <signorini/system/elastic_contact_system.h>
#include <signorini/system/scales.h>
#include <signorini/variational_inequality/make_solver.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Motion that is smaller than this part of what a step brings counts as rest. */
    constexpr double at_rest = 1e-6;
  } // namespace


  template <int dim>
  ElasticContactSystem<dim>::ElasticContactSystem(const Discretization<dim>     &discretization,
                                                  const ContactSurface<dim>     &surface,
                                                  const ContactCoordinates<dim> &coordinates,
                                                  Loads<dim>                    &loads,
                                                  const SystemParameters        &parameters,
                                                  dealii::TimerOutput           &timer)
    : discretization(discretization)
    , surface(surface)
    , coordinates(coordinates)
    , has_massless_nodes(parameters.mass.has_massless_contact_nodes())
    , has_dirichlet(dealii::Utilities::MPI::max(
                      static_cast<unsigned int>(coordinates.dirichlet_entries().size()),
                      discretization.communicator())
                    > 0)
    , is_damped(discretization.mesh().is_damped())
    , loads(loads)
    , parameters(parameters)
    , timer(timer)
    , first_guess(coordinates, touching_distance(discretization.mesh().body_size()))
    , friction(coordinates, surface.friction_may_come(), discretization.communicator())
    , step_matrices(
        discretization,
        coordinates,
        {parameters.solver.preconditioner,
         parameters.mesh_life_time,
         (friction.any() || parameters.solver.inequality == InequalityMethod::active_set)
           && sweeps_know_all(coordinates),
         friction.any(),
         parameters.solver.condensation,
         parameters.solver.inequality,
         parameters.solver.limits},
        timer)
    , mass_problems(discretization, surface, coordinates, parameters.solver, parameters.mass, timer)
    , solver(make_solver(friction.any(), parameters.solver.inequality, parameters.solver.limits))
    , active(surface.nodes().size(), contact_status::open)
  {
  }


  template <int dim>
  void ElasticContactSystem<dim>::let_contact_follow(const DirichletConditions<dim> &dirichlet,
                                                     ContactSurface<dim>            &moving_surface,
                                                     ContactCoordinates<dim> &moving_coordinates)
  {
    step_contact = std::make_unique<StepContact<dim>>(
      discretization, dirichlet, moving_surface, moving_coordinates, [this] {
        std::vector<bool> held = mass_problems.held_by_projection();
        for (std::size_t k = 0; k < active.size(); ++k)
          held[k] = held[k] || contact_status::is_closed(active[k]);
        return held;
      });
  }


  template <int dim>
  void ElasticContactSystem<dim>::apply_mass(Vector &destination, const Vector &source) const
  {
    dealii::TimerOutput::Scope scope(timer, "step: products M v and A u");
    discretization.matrices().apply_mass(destination, source);
  }


  template <int dim>
  void ElasticContactSystem<dim>::apply_stiffness(Vector &destination, const Vector &source) const
  {
    dealii::TimerOutput::Scope scope(timer, "step: products M v and A u");
    discretization.matrices().apply_stiffness(destination, source);
  }


  template <int dim>
  void ElasticContactSystem<dim>::apply_damping(Vector &destination, const Vector &velocity) const
  {
    dealii::TimerOutput::Scope scope(timer, "step: products M v and A u");
    discretization.matrices().apply_damping(destination, velocity);
  }


  template <int dim>
  void
  ElasticContactSystem<dim>::add_load(Vector &destination, const double factor, const double time)
  {
    if (loads.any())
      destination.add(factor, loads.at(time));
  }


  template <int dim>
  NormalGap ElasticContactSystem<dim>::own_normal_forces(const Vector &nodal_forces) const
  {
    Vector entries = nodal_forces;
    coordinates.force_to_contact(entries);
    NormalGap result;
    for (const unsigned int i : coordinates.normal_entries())
      result.push_back(entries.local_element(i));
    return result;
  }


  template <int dim>
  double ElasticContactSystem<dim>::solver_tolerance(const StepMatrix<dim>     &matrix,
                                                     const double               step_size,
                                                     const Vector              &right_hand_side,
                                                     const std::vector<double> &prescribed) const
  {
    // An error e of the increment is an error 2/tau e of the velocity, of kinetic energy at most
    // 2/tau^2 e'K e.
    const double of_motion = step_size * std::sqrt(largest_energies.scale() / 2.);
    const auto  &entries   = coordinates.dirichlet_entries();
    // At rest, or where all motion so far is round-off: what this step is going to bring.
    if (of_motion
        <= at_rest * rough_response_size(*matrix.product, right_hand_side, entries, prescribed))
      return parameters.solver.tolerance
             * response_size(
               *matrix.product, *matrix.preconditioner, right_hand_side, entries, prescribed);
    return parameters.solver.tolerance * of_motion;
  }


  template <int dim>
  std::vector<double> ElasticContactSystem<dim>::prescribed_increments(const State &start,
                                                                       const double step_size) const
  {
    std::vector<double> prescribed = coordinates.dirichlet_values(start.time + step_size);
    if (prescribed.empty())
      return prescribed;
    Vector displacement = start.displacement;
    coordinates.rotate_to_frames(displacement); // prescribed entries are not relative
    for (unsigned int j = 0; j < prescribed.size(); ++j)
      prescribed[j] -= displacement.local_element(coordinates.dirichlet_entries()[j]);
    return prescribed;
  }


  template <int dim>
  bool ElasticContactSystem<dim>::guess(const IncrementProblem &problem,
                                        StepMatrix<dim>        &matrix,
                                        const Vector           &right_hand_side,
                                        Vector                 &increment,
                                        Vector                 &residual)
  {
    const bool continues = step_contact && step_contact->repeats()
                           && matrix.forecast.repeat(problem.right_hand_side, increment, residual);
    // Trials that went too far are no reason to move: round-off of their forces would be left.
    const bool rests = largest_energies.scale() == 0. && right_hand_side.linfty_norm() == 0.;
    if (continues || (!rests && matrix.forecast.guess(problem.right_hand_side, increment)))
      coordinates.displacement_to_contact(increment);
    else
      first_guess.from_start(problem, *matrix.product, right_hand_side, increment, active);
    if (continues)
      coordinates.force_to_contact(residual);
    first_guess.expect_contact(increment, problem.bounds, active);
    return continues;
  }


  template <int dim>
  void ElasticContactSystem<dim>::solve(const IncrementProblem &problem,
                                        IncrementSolution      &solution)
  {
    StepMatrix<dim> &matrix =
      step_matrices.get(problem.stiffness_factor, problem.damping_factor, problem.step_size);
    dealii::TimerOutput::Scope scope(timer, "step: inequality");

    Vector right_hand_side = problem.right_hand_side;
    coordinates.force_to_contact(right_hand_side);
    Vector &increment = solution.increment, residual = discretization.make_vector();
    increment            = residual;
    const bool continues = guess(problem, matrix, right_hand_side, increment, residual);

    Friction friction_of_nodes;
    Vector   drag;
    if (friction.any())
      {
        friction_of_nodes = friction.of_step(problem.force_factor,
                                             gaps_at_start(*this, problem.bounds),
                                             touching_distance(discretization.mesh().body_size()),
                                             problem.further_reaction);
        if (step_contact)
          drag = step_contact->drag();
      }
    if (drag.size() > 0) // from now on tangential entries are slip
      {
        increment -= drag;
        Vector product = drag;
        matrix.product->vmult(product, drag);
        right_hand_side -= product;
      }

    const std::vector<double> prescribed = prescribed_increments(problem.start, problem.step_size);
    const ConstrainedProblem  constrained{
      *matrix.product,
      *matrix.preconditioner,
      right_hand_side,
      coordinates.normal_entries(),
      problem.bounds,
      coordinates.dirichlet_entries(),
      prescribed,
      solver_tolerance(matrix, problem.step_size, right_hand_side, prescribed),
      bound_tolerance(increment, discretization.mesh().body_size()),
      friction_of_nodes,
      continues,
      step_contact && step_contact->steps_are_trials()};
    ConstrainedSolver &of_step = matrix.condensed ? *matrix.condensed : *solver;
    solution.effort            = of_step.solve(constrained, active, increment, residual);
    if (solution.effort.n_fallbacks == 0) // else it says more about friction than about the matrix
      matrix.effort.add(solution.effort);

    const bool pressed_from_elsewhere = problem.further_reaction != nullptr;
    extract(friction_of_nodes, residual, *matrix.product, pressed_from_elsewhere, drag, solution);
    coordinates.force_to_cartesian(residual);
    matrix.forecast.remember(problem.right_hand_side, increment, residual);
    if (listener)
      listener(problem, solution);
  }


  template <int dim>
  void ElasticContactSystem<dim>::extract(const Friction       &friction_of_nodes,
                                          const Vector         &residual,
                                          const LinearOperator &matrix,
                                          const bool            pressed_from_elsewhere,
                                          const Vector         &drag,
                                          IncrementSolution    &solution) const
  {
    solution.contact_reaction = coordinates.normal_reaction(active, residual);
    solution.normal_reaction.clear();
    for (const unsigned int i : coordinates.normal_entries())
      solution.normal_reaction.push_back(solution.contact_reaction.local_element(i));
    solution.dirichlet_reaction = discretization.make_vector();
    for (const unsigned int i : coordinates.dirichlet_entries())
      solution.dirichlet_reaction.local_element(i) = -residual.local_element(i);
    if (friction.any())
      {
        friction.extract(friction_of_nodes,
                         active,
                         solution.increment,
                         residual,
                         matrix,
                         pressed_from_elsewhere,
                         solution);
        coordinates.force_to_cartesian(solution.friction_reaction);
      }
    if (drag.size() > 0)
      solution.increment += drag;

    coordinates.displacement_to_cartesian(solution.increment);
    coordinates.force_to_cartesian(solution.contact_reaction);
    coordinates.force_to_cartesian(solution.dirichlet_reaction);
  }


  template <int dim>
  std::vector<unsigned int> ElasticContactSystem<dim>::massless_entries() const
  {
    std::vector<unsigned int> entries;
    for (const unsigned int node : discretization.matrices().massless_nodes)
      for (unsigned int c = 0; c < dim; ++c)
        entries.push_back(dim * node + c);
    return entries;
  }


  template <int dim>
  SolveReport ElasticContactSystem<dim>::equilibrate_massless(Vector       &displacement,
                                                              const Vector &load,
                                                              Vector       &contact_force)
  {
    dealii::TimerOutput::Scope scope(timer, "step: equilibrium of massless nodes");
    if (!massless_equilibrium)
      massless_equilibrium = std::make_unique<MasslessEquilibrium<dim>>(
        discretization, surface, coordinates, parameters.solver);
    return massless_equilibrium->solve(displacement, load, largest_energies.motion, contact_force);
  }


  template <int dim>
  Vector ElasticContactSystem<dim>::normal_forces(const std::vector<double> &forces) const
  {
    Vector result = discretization.make_vector();
    for (unsigned int k = 0; k < forces.size(); ++k)
      result.local_element(coordinates.normal_entries()[k]) = forces[k];
    coordinates.force_to_cartesian(result);
    return result;
  }


  template <int dim>
  void ElasticContactSystem<dim>::stop_at_dirichlet(Vector &velocity) const
  {
    coordinates.rotate_to_frames(velocity); // prescribed entries are not relative
    for (const unsigned int i : coordinates.dirichlet_entries())
      velocity.local_element(i) = 0.;
    coordinates.rotate_from_frames(velocity);
  }


  template <int dim>
  Vector ElasticContactSystem<dim>::dirichlet_part(const Vector &forces) const
  {
    Vector part = discretization.make_vector(), local = forces;
    coordinates.force_to_contact(
      local); // collective: also where this process owns no prescribed node
    for (const unsigned int i : coordinates.dirichlet_entries())
      part.local_element(i) = local.local_element(i);
    coordinates.rotate_from_frames(part); // prescribed entries are not relative
    return part;
  }


  template <int dim>
  std::string ElasticContactSystem<dim>::cost_summary() const
  {
    const ProductCount &products = discretization.matrices().products();
    std::ostringstream  text;
    text << "  products          " << products.combined << " with M + s A, " << products.stiffness
         << " with A, " << products.mass << " with M";
    const unsigned int n_factors = step_matrices.n_factors();
    if (n_factors == 0 && !step_matrices.preconditioner_name().empty())
      text << "; preconditioner " << step_matrices.preconditioner_name();
    text << "\n";
    if (n_factors > 0)
      text << "  condensation      steps were solved for contact nodes, with "
           << (n_factors == 1 ? "a direct factor" : std::to_string(n_factors) + " direct factors")
           << " of the rest of the last mesh\n";
    if (step_matrices.n_built() > 1)
      text << "  step matrices     " << step_matrices.n_built() << " preconditioners built\n";
    return text.str();
  }


  template class ElasticContactSystem<2>;
  template class ElasticContactSystem<3>;
} // namespace signorini
