// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/mass/mass_solver.h>
#include <signorini/system/elastic_contact_system.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  namespace
  {
    SolveEffort effort_of(const SolveReport &report)
    {
      return {report.active_set_iterations, report.linear_iterations, report.n_active, report.fallback};
    }
  } // namespace


  template <int dim>
  ElasticContactSystem<dim>::ElasticContactSystem(const Discretization<dim>     &discretization,
                                                  const ContactSurface<dim>     &surface,
                                                  const ContactCoordinates<dim> &coordinates,
                                                  Loads<dim>                    &loads,
                                                  dealii::TimerOutput           &timer)
    : discretization(discretization)
    , surface(surface)
    , coordinates(coordinates)
    , loads(loads)
    , timer(timer)
    , solver({discretization.scene.solver.maximum_active_set_iterations,
              discretization.scene.solver.maximum_linear_iterations})
    , active(surface.nodes().size(), 0)
    , predictor_active(active)
    , last_correction(discretization.make_vector())
  {
  }


  template <int dim>
  void ElasticContactSystem<dim>::apply_mass(Vector &destination, const Vector &source) const
  {
    dealii::TimerOutput::Scope scope(timer, "step: products M v and A u");
    discretization.matrices.apply_mass(destination, source);
  }


  template <int dim>
  void ElasticContactSystem<dim>::apply_stiffness(Vector &destination, const Vector &source) const
  {
    dealii::TimerOutput::Scope scope(timer, "step: products M v and A u");
    discretization.matrices.apply_stiffness(destination, source);
  }


  template <int dim>
  bool ElasticContactSystem<dim>::add_mean_load(Vector      &destination,
                                                const double factor,
                                                const double start_time,
                                                const double end_time)
  {
    if (!loads.any())
      return false;
    destination.add(0.5 * factor, loads.at(start_time));
    destination.add(0.5 * factor, loads.at(end_time));
    return true;
  }


  template <int dim>
  void ElasticContactSystem<dim>::prepare(const double new_stiffness_factor, const double step_size)
  {
    if (new_stiffness_factor == stiffness_factor)
      return;
    stiffness_factor = new_stiffness_factor;
    dealii::TimerOutput::Scope scope(timer, "step: preconditioner set-up");
    forecast.clear();
    const auto &scene     = discretization.scene;
    chosen_preconditioner = scene.solver.preconditioner;
    if (chosen_preconditioner == "automatic")
      chosen_preconditioner = choose_preconditioner(discretization.courant_number(step_size), scene.time.n_steps());
    step_operator = std::make_unique<StepOperator<dim>>(discretization.matrices, coordinates, 1., stiffness_factor);
    step_preconditioner =
      make_preconditioner(chosen_preconditioner, discretization.matrices, coordinates, 1., stiffness_factor);
  }


  template <int dim>
  double ElasticContactSystem<dim>::solver_tolerance(const double                step_size,
                                                     const Vector               &right_hand_side,
                                                     const MaskedPreconditioner &preconditioner) const
  {
    // An error e of the increment is an error 2/tau e of the velocity, of kinetic energy at most 2/tau^2 e'K e.
    double scale = energy_scale * step_size * step_size / 2.;
    if (scale == 0.) // at rest: the energy that this step is going to bring
      {
        Vector increment = discretization.make_vector();
        preconditioner.vmult(increment, right_hand_side);
        scale = std::max(0., dot(increment, right_hand_side));
      }
    return discretization.scene.solver.tolerance * std::sqrt(scale);
  }


  template <int dim>
  void ElasticContactSystem<dim>::solve(const IncrementProblem &problem, IncrementSolution &solution)
  {
    prepare(problem.stiffness_factor, problem.step_size);
    dealii::TimerOutput::Scope scope(timer, "step: inequality");

    Vector right_hand_side = problem.right_hand_side;
    coordinates.force_to_contact(right_hand_side);
    Vector &increment = solution.increment;
    increment         = discretization.make_vector();
    forecast.guess(right_hand_side, increment);

    std::vector<double> prescribed = coordinates.supported_values(problem.start_time + problem.step_size);
    if (!prescribed.empty())
      {
        Vector displacement = problem.displacement;
        coordinates.rotate_to_frames(displacement); // supported entries are not relative
        for (unsigned int j = 0; j < prescribed.size(); ++j)
          prescribed[j] -= displacement.local_element(coordinates.supported_entries()[j]);
      }

    // A node that the guess drives into the obstacle is expected to touch.
    for (unsigned int k = 0; k < active.size(); ++k)
      if (increment.local_element(coordinates.normal_entries()[k]) > problem.bounds[k])
        active[k] = 1;

    Vector residual = discretization.make_vector();
    solution.effort =
      effort_of(solver.solve({*step_operator,
                              *step_preconditioner,
                              right_hand_side,
                              coordinates.normal_entries(),
                              problem.bounds,
                              coordinates.supported_entries(),
                              prescribed,
                              solver_tolerance(problem.step_size, right_hand_side, *step_preconditioner),
                              1e-12 * discretization.body_size()},
                             active,
                             increment,
                             residual));

    forecast.remember(right_hand_side, increment, residual);

    solution.contact_reaction = discretization.make_vector();
    solution.support_reaction = solution.contact_reaction;
    solution.normal_reaction.assign(active.size(), 0.);
    for (unsigned int k = 0; k < active.size(); ++k)
      if (const unsigned int i = coordinates.normal_entries()[k]; active[k])
        solution.contact_reaction.local_element(i) = solution.normal_reaction[k] = -residual.local_element(i);
    for (const unsigned int i : coordinates.supported_entries())
      solution.support_reaction.local_element(i) = -residual.local_element(i);

    coordinates.displacement_to_cartesian(increment);
    coordinates.force_to_cartesian(solution.contact_reaction);
    coordinates.force_to_cartesian(solution.support_reaction);
  }


  template <int dim>
  SolveEffort ElasticContactSystem<dim>::project(const Vector    &free_increment,
                                                 const NormalGap &bounds,
                                                 const double     step_size,
                                                 Vector          &correction,
                                                 Vector          &mass_correction)
  {
    correction      = discretization.make_vector();
    mass_correction = correction;

    // The bound of the correction is what is left of the gap after the free increment.
    NormalGap  left         = surface.relative_normal(free_increment);
    const auto bound_length = 1e-12 * discretization.body_size();
    bool       admissible   = true;
    for (unsigned int k = 0; k < left.size(); ++k)
      {
        left[k]    = bounds[k] - left[k];
        admissible = admissible && left[k] >= -bound_length;
      }
    if (dealii::Utilities::MPI::min(static_cast<unsigned int>(admissible), discretization.communicator()))
      return SolveEffort();
    dealii::TimerOutput::Scope scope(timer, "step: projection of the predictor");

    if (discretization.scene.time.predictor == "lumped")
      {
        SolveEffort effort;
        for (unsigned int k = 0; k < left.size(); ++k)
          if (left[k] < 0.)
            {
              correction.local_element(coordinates.normal_entries()[k]) = left[k];
              ++effort.n_active;
            }
        effort.n_active = dealii::Utilities::MPI::sum(effort.n_active, discretization.communicator());
        coordinates.rotate_from_frames(correction); // obstacles only
        apply_mass(mass_correction, correction);
        return effort;
      }

    prepare_mass();
    correction                     = last_correction; // in contact coordinates
    const Vector              zero = discretization.make_vector();
    const std::vector<double> held(coordinates.supported_entries().size(), 0.);
    const SolveEffort         effort =
      effort_of(solver.solve({*mass_operator,
                              *mass_preconditioner,
                              zero,
                              coordinates.normal_entries(),
                              left,
                              coordinates.supported_entries(),
                              held,
                              discretization.scene.solver.tolerance * step_size * std::sqrt(energy_scale / 2.),
                              bound_length},
                             predictor_active,
                             correction,
                             mass_correction));
    last_correction = correction;
    // The residual is 0 - M c. Only held entries have a reaction; what is left in the others is the error of the solver.
    const Vector residual = mass_correction;
    mass_correction       = 0.;
    for (unsigned int k = 0; k < predictor_active.size(); ++k)
      if (const unsigned int i = coordinates.normal_entries()[k]; predictor_active[k])
        mass_correction.local_element(i) = -residual.local_element(i);
    for (const unsigned int i : coordinates.supported_entries())
      mass_correction.local_element(i) = -residual.local_element(i);
    coordinates.displacement_to_cartesian(correction);
    coordinates.force_to_cartesian(mass_correction);
    return effort;
  }


  template <int dim>
  SolveEffort ElasticContactSystem<dim>::stop_normal_motion(const Vector            &velocity,
                                                            const std::vector<char> &held,
                                                            Vector                  &correction,
                                                            Vector                  &mass_correction)
  {
    correction      = discretization.make_vector();
    mass_correction = correction;

    const std::vector<double> normal_velocity = surface.relative_normal(velocity);
    std::vector<unsigned int> fixed           = coordinates.supported_entries();
    std::vector<double>       values(fixed.size(), 0.);
    for (unsigned int k = 0; k < held.size(); ++k)
      if (held[k])
        {
          fixed.push_back(coordinates.normal_entries()[k]);
          values.push_back(-normal_velocity[k]);
        }
    SolveEffort        effort;
    const unsigned int n_held = fixed.size() - coordinates.supported_entries().size();
    effort.n_active           = dealii::Utilities::MPI::sum(n_held, discretization.communicator());
    if (effort.n_active == 0)
      return effort;

    dealii::TimerOutput::Scope scope(timer, "step: velocity of held nodes");
    prepare_mass();
    const Vector zero = discretization.make_vector();
    Vector       residual(zero);
    ActiveSet    none;
    const double tolerance = discretization.scene.solver.tolerance * std::sqrt(energy_scale / 2.);
    const auto   report    = solver.solve(
      {*mass_operator, *mass_preconditioner, zero, {}, {}, fixed, values, tolerance, 0.}, none, correction, residual);
    effort.linear_iterations = report.linear_iterations;
    for (const unsigned int i : fixed)
      mass_correction.local_element(i) = -residual.local_element(i);
    coordinates.displacement_to_cartesian(correction);
    coordinates.force_to_cartesian(mass_correction);
    return effort;
  }


  template <int dim>
  void ElasticContactSystem<dim>::prepare_mass()
  {
    if (mass_operator)
      return;
    mass_operator       = std::make_unique<StepOperator<dim>>(discretization.matrices, coordinates, 1., 0.);
    mass_preconditioner = make_mass_preconditioner(discretization.matrices, coordinates);
  }


  template <int dim>
  std::vector<unsigned int> ElasticContactSystem<dim>::massless_entries() const
  {
    std::vector<unsigned int> entries;
    for (const unsigned int node : discretization.matrices.massless_nodes)
      for (unsigned int c = 0; c < dim; ++c)
        entries.push_back(dim * node + c);
    return entries;
  }


  template <int dim>
  SolveEffort
  ElasticContactSystem<dim>::equilibrate_massless(Vector &displacement, const Vector &load, Vector &contact_force)
  {
    dealii::TimerOutput::Scope scope(timer, "step: equilibrium of massless nodes");
    if (!massless_equilibrium)
      massless_equilibrium = std::make_unique<MasslessEquilibrium<dim>>(discretization, surface, coordinates);
    return effort_of(massless_equilibrium->solve(displacement, load, energy_scale, contact_force));
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
  Vector ElasticContactSystem<dim>::solve_mass(const Vector &force)
  {
    // Nodes with mass have no contact frames: their supported entries are components.
    if (discretization.scene.time.has_massless_contact_nodes())
      return MassSolver<dim>(discretization.matrices, coordinates.supported_entries()).solve(force);
    prepare_mass();
    dealii::TimerOutput::Scope scope(timer, "step: solution with the mass");
    Vector                     right_hand_side = force, result = discretization.make_vector(), residual = result;
    coordinates.force_to_contact(right_hand_side);
    const std::vector<double> held(coordinates.supported_entries().size(), 0.);
    ActiveSet                 none;
    // The error is one of velocity: its kinetic energy shall be small compared with that of the response.
    mass_preconditioner->set_mask(Mask(result.locally_owned_size(), 0));
    mass_preconditioner->vmult(residual, right_hand_side);
    const double size = std::sqrt(std::max(0., dot(residual, right_hand_side)));
    solver.solve({*mass_operator,
                  *mass_preconditioner,
                  right_hand_side,
                  {},
                  {},
                  coordinates.supported_entries(),
                  held,
                  1e-13 * size,
                  0.},
                 none,
                 result,
                 residual);
    coordinates.displacement_to_cartesian(result);
    return result;
  }


  template <int dim>
  bool ElasticContactSystem<dim>::supports_move(const double start_time, const double end_time) const
  {
    const std::vector<double> start = coordinates.supported_values(start_time);
    bool                      moved = false;
    for (const double time : {0.5 * (start_time + end_time), end_time})
      {
        const std::vector<double> now = coordinates.supported_values(time);
        for (unsigned int j = 0; j < now.size(); ++j)
          moved = moved || std::abs(now[j] - start[j]) > 1e-13 * discretization.body_size();
      }
    return dealii::Utilities::MPI::max(static_cast<unsigned int>(moved), discretization.communicator()) > 0;
  }


  template <int dim>
  void ElasticContactSystem<dim>::stop_at_supports(Vector &velocity) const
  {
    coordinates.rotate_to_frames(velocity); // supported entries are not relative
    for (const unsigned int i : coordinates.supported_entries())
      velocity.local_element(i) = 0.;
    coordinates.rotate_from_frames(velocity);
  }


  template <int dim>
  Vector ElasticContactSystem<dim>::support_part(const Vector &forces) const
  {
    Vector part = discretization.make_vector(), local = forces;
    coordinates.force_to_contact(local); // collective: also where this process owns no supported node
    for (const unsigned int i : coordinates.supported_entries())
      part.local_element(i) = local.local_element(i);
    coordinates.rotate_from_frames(part); // supported entries are not relative
    return part;
  }


  template <int dim>
  std::string ElasticContactSystem<dim>::cost_summary() const
  {
    const ProductCount &products = discretization.matrices.products();
    std::ostringstream  text;
    text << "  products          " << products.combined << " with M + s A, " << products.stiffness << " with A, "
         << products.mass << " with M; preconditioner " << chosen_preconditioner << "\n";
    return text.str();
  }


  template class ElasticContactSystem<2>;
  template class ElasticContactSystem<3>;
} // namespace signorini
