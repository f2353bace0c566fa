// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/aitken_relaxation.h>
#include <signorini/preconditioners/preconditioner_choice.h>
#include <signorini/system/motion_in_words.h>
#include <signorini/system/scales.h>
#include <signorini/system/static_equilibrium.h>
#include <signorini/system/take_out_motion.h>
#include <signorini/variational_inequality/make_solver.h>
#include <signorini/variational_inequality/slip_system.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr unsigned int maximum_steps = 60;

    /**
     * Of springs where contact holds: weaker than the bending of a body a thousand times as long as
     * thick. Friction needs springs that are not weak, or its solver looks for the point where a
     * body stops that slides without end; slender bodies then take more solutions.
     */
    constexpr double weak = 1e-6, not_weak = 1.;

    /**
     * Resultants of contact are wanted to ten digits; an error in the norm of A may be one of them.
     */
    constexpr double of_forces = 0.1;

    /** Of solutions whose anchors are still moving: in parts of this motion. */
    constexpr double rough = 1e-3;

    /** Tolerances that the last solution, accepted by its solver, may leave for the next one. */
    constexpr double of_last_solution = 10.;

    /** Of the energy norm of nodes pushed in one by one: less than if a compact body is pressed. */
    constexpr double pushed_freely = 1e-3;

    /** Mass that makes the matrix of the preconditioner definite, for bodies with free motions. */
    template <int dim>
    std::vector<double> mass_factors(const Discretization<dim> &discretization,
                                     const RigidModes<dim>     &rigid,
                                     const Eigen::MatrixXd     &loose,
                                     const double               factor)
    {
      constexpr Eigen::Index n_motions = RigidModes<dim>::n_motions;
      std::vector<double>    factors(discretization.mesh().bodies().size(), 0.);
      for (std::size_t k = 0; k < rigid.bodies().size(); ++k)
        if (loose.middleRows(k * n_motions, n_motions).cwiseAbs().sum() > 0.)
          factors[rigid.bodies()[k]] = factor;
      return factors;
    }


    /** The largest extent of a body over about its thickness: 1 for a cube. Collective. */
    template <int dim>
    double largest_slenderness(const Mesh<dim> &mesh)
    {
      const std::vector<double> volumes = mesh.volumes_of_bodies();
      double                    largest = 1.;
      for (std::size_t body = 0; body < volumes.size(); ++body)
        largest = std::max(largest, std::pow(mesh.body_size(body), dim) / volumes[body]);
      return largest;
    }


    /**
     * Whether motions with next to no energy have to be told from none, for which single precision
     * is not enough: bodies that may move freely, or bend slowly. A body that is held on one side
     * does so more slowly than a free one.
     */
    template <int dim>
    bool has_slow_motions(const Discretization<dim> &discretization, const Eigen::MatrixXd &loose)
    {
      constexpr double as_free = 3.;
      const Mesh<dim> &mesh    = discretization.mesh();
      return loose.cols() > 0
             || needs_double_precision(
               discretization, 2. * as_free * largest_slenderness(mesh) / mesh.lowest_frequency());
    }
  } // namespace


  template <int dim>
  StaticEquilibrium<dim>::StaticEquilibrium(const Discretization<dim>     &discretization,
                                            const ContactCoordinates<dim> &coordinates,
                                            const SolverParameters        &parameters,
                                            const bool                     with_friction)
    : discretization(discretization)
    , coordinates(coordinates)
    , parameters(parameters)
    , rigid(discretization, coordinates)
    , loose(rigid.free_amplitudes(coordinates.dirichlet_entries()))
    , stiffness_of_springs(std::pow(0.1 * discretization.mesh().lowest_frequency(), 2))
    , stiffness(discretization.matrices(), coordinates, {0., 1.})
    , matrix(stiffness, rigid)
    , preconditioner(
        make_static_preconditioner(parameters.preconditioner,
                                   discretization,
                                   coordinates,
                                   mass_factors(discretization, rigid, loose, stiffness_of_springs),
                                   has_slow_motions(discretization, loose)))
    , with_friction(with_friction)
    , weakness(with_friction ? not_weak : weak)
    , solver(make_solver(with_friction, parameters.inequality, parameters.limits))
    , diagonal(discretization.make_vector())
  {
    stiffness.diagonal(diagonal);
  }


  template <int dim>
  StaticSolution
  StaticEquilibrium<dim>::solve(const StaticProblem &problem, ActiveSet status, const Vector *start)
  {
    StaticSolution solution;
    solution.residual     = discretization.make_vector();
    solution.increment    = start != nullptr ? *start : solution.residual;
    solution.status       = std::move(status);
    solution.acceleration = Eigen::VectorXd::Zero(rigid.size());

    const double     response  = response_to(problem);
    const double     accepted  = of_forces * parameters.tolerance * response;
    double           moved     = loose.cols() > 0 ? response : 0.; // anchors, in the norm of K
    double           tolerance = std::max(accepted, rough * std::min(moved, response));
    Eigen::VectorXd  last = matrix.amplitudes(solution.increment); // rigid part of d, its anchor
    Eigen::MatrixXd  S    = springs(problem.near_contact_only ? loose : loose.leftCols(0));
    AitkenRelaxation relaxation;
    Eigen::Index     n_free = loose.cols();
    while (solution.n_steps++ < maximum_steps)
      {
        solve_anchored(problem, S, last, tolerance, solution);
        const Eigen::VectorXd now     = matrix.amplitudes(solution.increment);
        const Eigen::VectorXd step    = now - last;
        const Eigen::VectorXd borne   = S * step;
        const Eigen::VectorXd drive   = solution.acceleration + borne;
        const bool            creeps  = goes_on_creeping(problem, solution, drive);
        const Eigen::MatrixXd free    = free_motions(problem, solution, drive);
        const auto            project = [&](const Eigen::VectorXd &motion) {
          return Eigen::VectorXd(free * (free.transpose() * motion));
        };
        moved                 = std::sqrt(borne.dot(step));
        solution.acceleration = project(drive);
        if (creeps || (moved <= accepted && tolerance == accepted))
          {
            solution.is_held = creeps || !is_driven(problem, solution, accepted);
            take_out_motion(rigid,
                            solution.is_held ? motions_without_slip(problem, solution) : free,
                            now,
                            coordinates,
                            solution.status,
                            problem.bounds,
                            tolerance_of_bounds(),
                            solution.increment);
            return solution;
          }
        // What is free goes on in its direction, as slip does, but no further than with springs
        // that are not weak.
        if (free.cols() != n_free)
          relaxation.forget();
        n_free                     = free.cols();
        const Eigen::VectorXd held = step - project(step);
        last += project(borne) / stiffness_of_springs + relaxation.factor(held) * held;
        rigid.add_in_contact(last - now, solution.increment);
        S         = springs(free);
        tolerance = std::max(accepted, rough * std::min(moved, response));
      }
    throw StepError("no static equilibrium was found: what contact holds of the bodies did not "
                    "settle in "
                    + std::to_string(maximum_steps) + " solutions.");
  }


  template <int dim>
  StaticSolution StaticEquilibrium<dim>::find_held(StaticProblem problem, const ActiveSet &status)
  {
    if (std::optional<StaticSolution> rest = try_rest(problem))
      return *rest;
    problem.near_contact_only = true;
    StaticSolution near       = solve(problem, status);
    unsigned int   n_open     = 0;
    for (std::size_t k = 0; k < status.size(); ++k)
      n_open += near.status[k] == contact_status::open && std::isfinite(problem.bounds[k]);
    n_open = dealii::Utilities::MPI::sum(n_open, discretization.communicator());
    if (near.is_held || n_open == 0)
      return near;
    try
      {
        problem.near_contact_only = false;
        return with_friction ? land(problem, status) : solve(problem, status);
      }
    catch (const StepError &)
      {
        return near; // what is not held has fallen without end
      }
  }


  template <int dim>
  StaticSolution StaticEquilibrium<dim>::land(const StaticProblem &problem, const ActiveSet &status)
  {
    if (!smooth)
      smooth =
        std::make_unique<StaticEquilibrium<dim>>(discretization, coordinates, parameters, false);
    const Friction       none;
    const StaticSolution landed = smooth->solve(
      {problem.force, problem.bounds, problem.prescribed, none, problem.energy}, status);
    StaticSolution found = solve(problem, landed.status, &landed.increment);
    found.effort.add(landed.effort);
    return found;
  }


  template <int dim>
  std::optional<StaticSolution> StaticEquilibrium<dim>::try_rest(const StaticProblem &problem)
  {
    const std::vector<unsigned int> &normals = coordinates.normal_entries();
    const double   accepted = of_last_solution * parameters.tolerance * response_to(problem);
    StaticSolution rest;
    rest.increment = rest.residual = discretization.make_vector();
    rest.acceleration              = Eigen::VectorXd::Zero(rigid.size());
    rest.is_held                   = true;
    rest.residual                  = problem.force;
    coordinates.force_to_contact(rest.residual);

    unsigned int n_moving = std::count_if(problem.prescribed.begin(),
                                          problem.prescribed.end(),
                                          [](const double value) { return value != 0.; });
    for (std::size_t k = 0; k < normals.size(); ++k)
      {
        const double normal = rest.residual.local_element(normals[k]);
        const bool   closed = normal > 0. && problem.bounds[k] <= tolerance_of_bounds();
        n_moving += problem.bounds[k] < -tolerance_of_bounds();
        rest.status.push_back(closed ? contact_status::slip : contact_status::open);
        if (problem.friction.empty() || problem.friction[k].entries.empty())
          continue;
        // Errors of forces as the solver counts them.
        const FrictionNode &node = problem.friction[k];
        const double        force =
          node_forces(node, normals[k], closed, rest.increment, rest.residual).tangential.norm();
        const double error = accepted * std::sqrt(diagonal.local_element(node.entries[0]));
        if (closed && force <= node.law.bound(normal) + error)
          rest.status[k] = contact_status::stick;
      }
    n_moving = dealii::Utilities::MPI::sum(n_moving, discretization.communicator());
    if (n_moving > 0)
      return std::nullopt;
    const std::vector<unsigned int> held       = coordinates.held_entries(rest.status);
    const double                    unbalanced = response_size(
      stiffness, *preconditioner, rest.residual, held, std::vector<double>(held.size()));
    return unbalanced <= accepted ? std::optional(rest) : std::nullopt;
  }


  template <int dim>
  void StaticEquilibrium<dim>::solve_anchored(const StaticProblem   &problem,
                                              const Eigen::MatrixXd &S,
                                              const Eigen::VectorXd &anchor,
                                              const double           tolerance,
                                              StaticSolution        &solution)
  {
    Vector b = problem.force;
    coordinates.force_to_contact(b);
    matrix.set(S);
    matrix.add_forces(S * anchor - solution.acceleration, b);
    solution.effort.add(solver->solve({matrix,
                                       *preconditioner,
                                       b,
                                       coordinates.normal_entries(),
                                       problem.bounds,
                                       coordinates.dirichlet_entries(),
                                       problem.prescribed,
                                       tolerance,
                                       tolerance_of_bounds(),
                                       problem.friction},
                                      solution.status,
                                      solution.increment,
                                      solution.residual));
  }


  template <int dim>
  double StaticEquilibrium<dim>::tolerance_of_bounds() const
  {
    return 1e-12 * discretization.mesh().body_size();
  }


  template <int dim>
  double StaticEquilibrium<dim>::response_to(const StaticProblem &problem)
  {
    Vector force = problem.force;
    coordinates.force_to_contact(force);
    std::vector<unsigned int> entries = coordinates.dirichlet_entries();
    std::vector<double>       values  = problem.prescribed;
    const double to_loads = response_size(stiffness, *preconditioner, force, entries, values);

    // Obstacles may be all that presses: nodes that touch stay where they are put.
    for (std::size_t k = 0; k < problem.bounds.size(); ++k)
      if (problem.bounds[k] <= tolerance_of_bounds())
        {
          entries.push_back(coordinates.normal_entries()[k]);
          values.push_back(std::min(problem.bounds[k], 0.));
        }
    force                    = 0.;
    const double to_contact  = response_size(stiffness, *preconditioner, force, entries, values);
    const double of_surfaces = rough_response_size(stiffness, force, entries, values);
    return std::max(
      {to_loads, to_contact, pushed_freely * of_surfaces, std::sqrt(2. * problem.energy)});
  }


  template class StaticEquilibrium<2>;
  template class StaticEquilibrium<3>;
} // namespace signorini
