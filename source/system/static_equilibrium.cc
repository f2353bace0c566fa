// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/preconditioners.h>
#include <signorini/system/response_size.h>
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

    /** Small compared with the square of the lowest frequency of compact bodies. */
    template <int dim>
    double proximal_factor(const Discretization<dim> &discretization)
    {
      double speed = std::numeric_limits<double>::infinity();
      for (const auto &body : discretization.scene.bodies)
        speed = std::min(speed, body.material.pressure_wave_speed());
      return std::pow(0.1 * speed / discretization.body_size(), 2);
    }
  } // namespace


  template <int dim>
  StaticEquilibrium<dim>::StaticEquilibrium(const Discretization<dim>     &discretization,
                                            const ContactSurface<dim>     &surface,
                                            const ContactCoordinates<dim> &coordinates)
    : discretization(discretization)
    , surface(surface)
    , coordinates(coordinates)
    , friction(coordinates, discretization.communicator())
  {
  }


  template <int dim>
  unsigned int StaticEquilibrium<dim>::find(State &state, const Vector *load)
  {
    const auto             &scene = discretization.scene;
    const double            sigma = proximal_factor(discretization);
    const StepOperator<dim> matrix(discretization.matrices, coordinates, sigma, 1.);
    std::string             name = scene.solver.preconditioner;
    if (name == "automatic")
      name = choose_preconditioner(discretization.courant_number(1. / std::sqrt(sigma)), maximum_steps);
    const auto            preconditioner = make_preconditioner(name, discretization.matrices, coordinates, sigma, 1.);
    FrictionalNewton      solver({scene.solver.maximum_active_set_iterations, scene.solver.maximum_linear_iterations});
    const RigidModes<dim> rigid(discretization, coordinates);
    const std::vector<double> prescribed = coordinates.supported_values(0.);

    Vector u = discretization.make_vector(), displacement = u, change = u, product = u, residual = u, balance = u;
    const NormalGap gap  = surface.normal_gap(u);
    const Friction  laws = friction_of_nodes(gap, state.velocity);
    ActiveSet       status(gap.size(), contact_status::open);
    if (load != nullptr)
      balance = *load; // f - M a
    double tolerance = 0.;
    for (unsigned int step = 1; step <= maximum_steps; ++step)
      {
        // b = f - M a + sigma M u
        discretization.matrices.apply_mass(product, displacement);
        Vector b = balance;
        b.add(sigma, product);
        coordinates.force_to_contact(b);
        if (step == 1)
          tolerance = 1e-2 * scene.solver.tolerance
                      * response_size(matrix, *preconditioner, b, coordinates.supported_entries(), prescribed);
        solver.solve({matrix,
                      *preconditioner,
                      b,
                      coordinates.normal_entries(),
                      gap,
                      coordinates.supported_entries(),
                      prescribed,
                      tolerance,
                      1e-12 * discretization.body_size(),
                      laws},
                     status,
                     u,
                     residual);
        change       = displacement;
        displacement = u;
        coordinates.displacement_to_cartesian(displacement);
        change.sadd(-1., 1., displacement);

        // What drives a free motion becomes its acceleration; the rest of the change tells how far the equilibrium is.
        const std::vector<RigidMotion> free   = rigid.free_of(held_entries(status));
        double                         driven = 0.;
        discretization.matrices.apply_mass(product, change);
        for (const RigidMotion &mode : free)
          {
            const double motion = dot(product, mode.displacement);
            driven              = std::max(driven, std::abs(motion));
            change.add(-motion, mode.displacement);
            balance.add(-sigma * motion, mode.momentum);
          }
        discretization.matrices.apply_mass(product, change);
        const double unbalanced = sigma * std::sqrt(std::max(0., dot(product, change)) + driven * driven);
        discretization.matrices.apply_mass(product, displacement);
        const double size = sigma * std::sqrt(std::max(0., dot(product, displacement)));
        if (unbalanced <= 1e-12 * size)
          {
            discretization.matrices.apply_mass(product, displacement);
            for (const RigidMotion &mode : free)
              displacement.add(-dot(product, mode.displacement), mode.displacement);
            state.displacement = displacement;
            set_forces(state, laws, status, u, residual);
            return step;
          }
      }
    throw RunError(
      scene.file_name + ": Time/Start = equilibrium: no static equilibrium was found in "
      + std::to_string(maximum_steps)
      + " iterations. Loads may tip a body over, or roll it. Set `Start = given` to begin with undeformed bodies.");
  }


  template <int dim>
  Friction StaticEquilibrium<dim>::friction_of_nodes(const NormalGap &gap, const Vector &velocity) const
  {
    if (!friction.any())
      return Friction(gap.size());
    Friction laws     = friction.of_step(1., gap, 1e-10 * discretization.body_size(), nullptr);
    Vector   relative = velocity;
    coordinates.displacement_to_contact(relative);
    const double speed = relative.linfty_norm();
    for (FrictionNode &node : laws)
      {
        for (unsigned int j = 0; j < node.entries.size(); ++j)
          node.past[j] = relative.local_element(node.entries[j]);
        // So far that the displacements of the equilibrium do not turn it.
        node.past *= node.past.norm() > 1e-10 * speed ? 1e8 * discretization.body_size() / speed : 0.;
      }
    return laws;
  }


  template <int dim>
  std::vector<unsigned int> StaticEquilibrium<dim>::held_entries(const ActiveSet &status) const
  {
    std::vector<unsigned int> held = coordinates.supported_entries();
    for (std::size_t k = 0; k < status.size(); ++k)
      {
        const auto &tangents = coordinates.tangential_entries()[k];
        if (contact_status::is_closed(status[k]))
          held.push_back(coordinates.normal_entries()[k]);
        if (contact_status::sticks(status[k]))
          held.insert(held.end(), tangents.begin(), tangents.end());
      }
    return held;
  }


  template <int dim>
  void StaticEquilibrium<dim>::set_forces(State           &state,
                                          const Friction  &laws,
                                          const ActiveSet &status,
                                          const Vector    &increment,
                                          const Vector    &residual) const
  {
    state.contact_force = discretization.make_vector();
    for (std::size_t k = 0; k < status.size(); ++k)
      if (const unsigned int i = coordinates.normal_entries()[k]; contact_status::is_closed(status[k]))
        state.contact_force.local_element(i) = -residual.local_element(i);
    coordinates.force_to_cartesian(state.contact_force);
    if (!friction.any())
      return;
    IncrementSolution solution;
    friction.extract(laws, status, increment, residual, false, solution);
    coordinates.force_to_cartesian(solution.friction_reaction);
    state.contact_force += solution.friction_reaction;
    state.friction.force = solution.friction_reaction;
    state.friction.slip = state.friction.accumulated_slip = discretization.make_vector(); // slip counts from here
    state.friction.slip_path.assign(status.size(), 0.);
    state.friction.status = solution.status;
  }


  template class StaticEquilibrium<2>;
  template class StaticEquilibrium<3>;
} // namespace signorini
