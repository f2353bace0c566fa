// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/mass/mass_solver.h>
#include <signorini/system/mass_problems.h>
#include <signorini/system/scales.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** Of the accepted error, what may be outside of a neighbourhood: it is so in each step. */
    constexpr double missed = 0.1;
  } // namespace


  template <int dim>
  MassProblems<dim>::MassProblems(const Discretization<dim>     &discretization,
                                  const ContactSurface<dim>     &surface,
                                  const ContactCoordinates<dim> &coordinates,
                                  const SolverParameters        &parameters,
                                  const MassParameters          &mass_parameters,
                                  dealii::TimerOutput           &timer)
    : discretization(discretization)
    , surface(surface)
    , coordinates(coordinates)
    , tolerance(parameters.tolerance)
    , mass_parameters(mass_parameters)
    , timer(timer)
    , near_contact(discretization.matrices(), coordinates)
    , solver(parameters.limits)
    , projected(surface.nodes().size(), 0)
    , last_correction(discretization.make_vector())
    , last_residual(last_correction)
  {
  }


  template <int dim>
  void MassProblems<dim>::prepare()
  {
    if (!mass)
      mass = std::make_unique<StepOperator<dim>>(
        discretization.matrices(), coordinates, MatrixSum{1., 0.});
  }


  template <int dim>
  SolveReport MassProblems<dim>::project(const ProjectionProblem &problem,
                                         Vector                  &correction,
                                         Vector                  &mass_correction)
  {
    AssertDimension(problem.bounds.size(), surface.nodes().size());
    Assert(problem.step_size > 0., dealii::ExcMessage("A step goes forward in time."));
    Assert(problem.energy_scale >= 0., dealii::ExcMessage("The scale is an energy of motion."));
    correction      = discretization.make_vector();
    mass_correction = correction;

    // The bound of the correction is what is left of the gap after the free increment.
    NormalGap  left = surface.relative_normal(problem.free_increment);
    const auto bound_length =
      bound_tolerance(problem.free_increment, discretization.mesh().body_size());
    bool admissible = true;
    for (unsigned int k = 0; k < left.size(); ++k)
      {
        left[k]    = problem.bounds[k] - left[k];
        admissible = admissible && left[k] >= -bound_length;
      }
    const bool continues = problem.repeats && !is_identity;
    is_identity          = dealii::Utilities::MPI::min(static_cast<unsigned int>(admissible),
                                              discretization.communicator());
    if (is_identity)
      return SolveReport();
    dealii::TimerOutput::Scope scope(timer, "step: projection of the predictor");
    if (mass_parameters.predictor == PredictorMass::lumped)
      return project_node_by_node(left, correction, mass_correction);
    return project_at_once(problem, left, continues, correction, mass_correction);
  }


  template <int dim>
  double MassProblems<dim>::size_of(const Corrections &corrections) const
  {
    const ElasticMatrices<dim> &matrices = discretization.matrices();
    double                      square   = 0.;
    for (const auto &[entry, value] : corrections)
      square += matrices.mass[matrices.pattern.row_start[entry / dim]] * value * value;
    return std::sqrt(dealii::Utilities::MPI::sum(square, discretization.communicator()));
  }


  template <int dim>
  void MassProblems<dim>::surround(const Corrections &corrections,
                                   const double       size,
                                   const double       accepted)
  {
    std::vector<unsigned int> nodes;
    for (const auto &correction : corrections)
      nodes.push_back(correction.first / dim);
    near_contact.surround(nodes, size > 0. ? accepted / size : 1.);
  }


  template <int dim>
  SolveReport MassProblems<dim>::solve_near_contact(const NearContact &problem,
                                                    ActiveSet         &active,
                                                    Vector            &correction,
                                                    Vector            &residual)
  {
    const Vector zero  = discretization.make_vector();
    const auto   solve = [&](const bool goes_on) {
      return solver.solve({*mass,
                           near_contact.preconditioner(),
                           zero,
                           problem.bounded,
                           problem.bounds,
                           problem.fixed,
                           problem.values,
                           problem.accepted,
                           problem.bound_tolerance,
                           ConstrainedProblem::no_friction,
                           problem.continues || goes_on,
                           problem.is_trial,
                           problem.knows_residual || goes_on},
                          active,
                          correction,
                          residual);
    };
    SolveReport report = solve(false);
    while (!problem.is_trial && near_contact.norm_outside(residual) > missed * problem.accepted)
      {
        near_contact.widen();
        report.add(solve(true));
      }
    return report;
  }


  template <int dim>
  SolveReport MassProblems<dim>::project_at_once(const ProjectionProblem &problem,
                                                 const NormalGap         &left,
                                                 const bool               continues,
                                                 Vector                  &correction,
                                                 Vector                  &mass_correction)
  {
    prepare();
    Corrections corrections;
    for (unsigned int k = 0; k < left.size(); ++k)
      if (left[k] < 0. || projected[k])
        corrections.emplace_back(coordinates.normal_entries()[k], std::min(left[k], 0.));
    // An obstacle that moves may be all that does.
    const double size      = size_of(corrections);
    const double of_motion = problem.step_size * std::sqrt(problem.energy_scale / 2.);
    const double accepted  = tolerance * std::max(of_motion, size);
    surround(corrections, size, accepted);
    const bool is_new = near_contact.number() != last_neighbourhood;
    correction        = last_correction;
    coordinates.displacement_to_contact(correction);
    if (is_new)
      near_contact.clear_outside(correction);
    else
      {
        mass_correction = last_residual;
        coordinates.force_to_contact(mass_correction);
      }
    std::vector<unsigned int> held = coordinates.dirichlet_entries();
    const std::vector<double> nothing(held.size(), 0.);
    const SolveReport         report = solve_near_contact(
      {coordinates.normal_entries(),
               left,
               coordinates.dirichlet_entries(),
               nothing,
               accepted,
               bound_tolerance(problem.free_increment, discretization.mesh().body_size()),
               continues && !is_new,
               problem.is_trial,
               !is_new},
      projected,
      correction,
      mass_correction);
    last_residual = mass_correction;
    coordinates.force_to_cartesian(last_residual);
    for (unsigned int k = 0; k < projected.size(); ++k)
      if (projected[k])
        held.push_back(coordinates.normal_entries()[k]);
    mass_correction *= -1.; // the residual is 0 - M c
    keep_only(held, mass_correction);
    coordinates.displacement_to_cartesian(correction);
    coordinates.force_to_cartesian(mass_correction);
    last_correction    = correction;
    last_neighbourhood = near_contact.number();
    return report;
  }


  template <int dim>
  SolveReport MassProblems<dim>::project_node_by_node(const NormalGap &left,
                                                      Vector          &correction,
                                                      Vector          &mass_correction)
  {
    SolveReport effort;
    for (unsigned int k = 0; k < left.size(); ++k)
      if ((projected[k] = left[k] < 0.))
        {
          correction.local_element(coordinates.normal_entries()[k]) = left[k];
          ++effort.n_active;
        }
    effort.n_active = dealii::Utilities::MPI::sum(effort.n_active, discretization.communicator());
    coordinates.rotate_from_frames(correction);
    discretization.matrices().apply_mass(mass_correction, correction);
    return effort;
  }


  template <int dim>
  SolveReport MassProblems<dim>::stop_relative_motion(const Vector    &velocity,
                                                      const ActiveSet &held,
                                                      const double     energy_scale,
                                                      Vector          &correction,
                                                      Vector          &mass_correction)
  {
    AssertDimension(held.size(), surface.nodes().size());
    Assert(energy_scale >= 0., dealii::ExcMessage("The scale is an energy of motion."));
    correction      = discretization.make_vector();
    mass_correction = correction;

    const std::vector<unsigned int> fixed = coordinates.held_entries(held);
    SolveReport                     report;
    const unsigned int              n_held = fixed.size() - coordinates.dirichlet_entries().size();
    const unsigned int              n_active =
      dealii::Utilities::MPI::sum(n_held, discretization.communicator());
    if (n_active == 0)
      return report;

    dealii::TimerOutput::Scope scope(timer, "step: velocity of held nodes");
    prepare();
    Vector relative_velocity = velocity;
    coordinates.displacement_to_contact(relative_velocity);
    std::vector<double> values(coordinates.dirichlet_entries().size(), 0.);
    Corrections         corrections;
    for (std::size_t j = values.size(); j < fixed.size(); ++j)
      {
        values.push_back(-relative_velocity.local_element(fixed[j]));
        corrections.emplace_back(fixed[j], values[j]);
      }

    ActiveSet    none;
    const double accepted = tolerance * std::sqrt(energy_scale / 2.);
    surround(corrections, size_of(corrections), accepted);
    report =
      solve_near_contact({{}, {}, fixed, values, accepted}, none, correction, mass_correction);
    report.n_active = n_active;
    mass_correction *= -1.; // the residual is 0 - M c
    keep_only(fixed, mass_correction);
    coordinates.displacement_to_cartesian(correction);
    coordinates.force_to_cartesian(mass_correction);
    return report;
  }


  template <int dim>
  std::vector<bool> MassProblems<dim>::held_by_projection() const
  {
    std::vector<bool> held(projected.size(), false);
    for (std::size_t k = 0; k < held.size(); ++k)
      held[k] = !is_identity && projected[k];
    return held;
  }


  template <int dim>
  void MassProblems<dim>::keep_only(const std::vector<unsigned int> &fixed, Vector &vector) const
  {
    const Vector all = vector;
    vector           = 0.;
    for (const unsigned int i : fixed)
      vector.local_element(i) = all.local_element(i);
  }


  template <int dim>
  Vector MassProblems<dim>::solve(const Vector &force)
  {
    // Nodes with mass have no contact frames: their prescribed entries are components.
    if (mass_parameters.has_massless_contact_nodes())
      return MassSolver<dim>(discretization.matrices(), coordinates.dirichlet_entries())
        .solve(force);
    prepare();
    if (!preconditioner)
      preconditioner = make_mass_preconditioner(discretization.matrices(), coordinates);
    dealii::TimerOutput::Scope scope(timer, "step: solution with the mass");
    Vector right_hand_side = force, result = discretization.make_vector(), residual = result;
    coordinates.force_to_contact(right_hand_side);
    const std::vector<double> held(coordinates.dirichlet_entries().size(), 0.);
    ActiveSet                 none;
    // The error is one of velocity: its kinetic energy shall be small compared with that of the
    // response.
    preconditioner->set_mask(Mask(result.locally_owned_size(), 0));
    preconditioner->vmult(residual, right_hand_side);
    const double size = std::sqrt(std::max(0., dot(residual, right_hand_side)));
    solver.solve({*mass,
                  *preconditioner,
                  right_hand_side,
                  {},
                  {},
                  coordinates.dirichlet_entries(),
                  held,
                  std::max(1e-13 * size, std::numeric_limits<double>::min()),
                  0.},
                 none,
                 result,
                 residual);
    coordinates.displacement_to_cartesian(result);
    return result;
  }


  template class MassProblems<2>;
  template class MassProblems<3>;
} // namespace signorini
