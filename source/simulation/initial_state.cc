// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/simulation/initial_state.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>

namespace signorini
{
  double perturbation_of_velocities()
  {
    const char *const text = std::getenv("SIGNORINI_PERTURB");
    return text == nullptr ? 0. : dealii::Utilities::string_to_double(text);
  }


  template <int dim>
  State initial_state(const Discretization<dim> &discretization)
  {
    std::vector<std::array<std::string, dim>> displacements, velocities;
    for (const auto &body : discretization.mesh().bodies())
      {
        displacements.push_back(body.initial_displacement);
        velocities.push_back(body.initial_velocity);
      }
    State state;
    state.displacement = discretization.interpolate(displacements);
    state.velocity     = discretization.interpolate(velocities);
    state.velocity *= 1. + perturbation_of_velocities();
    state.contact_force = state.momentum = state.internal_force = discretization.make_vector();
    return state;
  }


  template <int dim>
  Remarks start_with_conditions(const Discretization<dim>     &discretization,
                                const ContactCoordinates<dim> &coordinates,
                                const double                   step_size,
                                State                         &state)
  {
    // One-sided difference of third order: exact for the motions that people write, and before time
    // 0 a condition need not exist.
    const double                     h        = 1e-2 * step_size;
    constexpr std::array<double, 4>  factor   = {{-11. / 6., 3., -1.5, 1. / 3.}};
    const std::vector<unsigned int> &entries  = coordinates.dirichlet_entries();
    const std::vector<double>        position = coordinates.dirichlet_values(0.);
    std::vector<double>              rate(entries.size(), 0.);
    for (unsigned int k = 0; k < factor.size(); ++k)
      {
        const std::vector<double> value = coordinates.dirichlet_values(k * h);
        for (std::size_t j = 0; j < rate.size(); ++j)
          rate[j] += factor[k] * (value[j] - position[j]) / h;
      }

    Vector displacement = state.displacement;
    coordinates.displacement_to_contact(displacement);
    coordinates.displacement_to_contact(state.velocity);
    double jump = 0., change = 0.;
    for (std::size_t j = 0; j < entries.size(); ++j)
      {
        double &velocity = state.velocity.local_element(entries[j]);
        jump     = std::max(jump, std::abs(displacement.local_element(entries[j]) - position[j]));
        change   = std::max(change, std::abs(velocity - rate[j]));
        velocity = rate[j];
      }
    coordinates.displacement_to_cartesian(state.velocity);

    const MPI_Comm communicator = discretization.communicator();
    jump                        = dealii::Utilities::MPI::max(jump, communicator);
    change                      = dealii::Utilities::MPI::max(change, communicator);
    Remarks    remarks;
    const auto up_to = [](const double value) {
      std::ostringstream text;
      text << " by up to " << std::setprecision(3) << value << ".";
      return text.str();
    };
    // The difference has a round-off of 1e-14 of the positions.
    if (change * step_size > 1e-11 * discretization.mesh().body_size())
      remarks.notes.push_back("prescribed nodes start with the velocity of their condition, which "
                              "differs from the initial velocity of their body"
                              + up_to(change));
    if (jump > 1e-9 * discretization.mesh().body_size())
      remarks.warnings.push_back("The first step moves prescribed nodes suddenly to where their "
                                 "conditions want them. With `Start = equilibrium` they begin "
                                 "there, at rest. They move"
                                 + up_to(jump));
    return remarks;
  }


  template State initial_state(const Discretization<2> &);
  template State initial_state(const Discretization<3> &);
  template Remarks
  start_with_conditions(const Discretization<2> &, const ContactCoordinates<2> &, double, State &);
  template Remarks
  start_with_conditions(const Discretization<3> &, const ContactCoordinates<3> &, double, State &);
} // namespace signorini
