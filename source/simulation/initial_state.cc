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
  namespace
  {
    std::string up_to(const double value)
    {
      std::ostringstream text;
      text << " by up to " << std::setprecision(3) << value << ".";
      return text.str();
    }


    /** The largest difference between prescribed entries and what they shall be. Collective. */
    template <int dim>
    double differ_by(const ContactCoordinates<dim> &coordinates,
                     Vector                         entries,
                     const std::vector<double>     &prescribed)
    {
      coordinates.rotate_to_frames(entries); // prescribed entries are not relative
      double largest = 0.;
      for (std::size_t j = 0; j < prescribed.size(); ++j)
        largest = std::max(
          largest,
          std::abs(entries.local_element(coordinates.dirichlet_entries()[j]) - prescribed[j]));
      return dealii::Utilities::MPI::max(largest, entries.get_mpi_communicator());
    }
  } // namespace


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
                                Vector                        &velocity)
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
    const double change = differ_by(coordinates, velocity, rate);
    coordinates.rotate_to_frames(velocity);
    for (std::size_t j = 0; j < entries.size(); ++j)
      velocity.local_element(entries[j]) = rate[j];
    coordinates.rotate_from_frames(velocity);

    Remarks remarks;
    // The difference has a round-off of 1e-14 of the positions.
    if (change * step_size > 1e-11 * discretization.mesh().body_size())
      remarks.notes.push_back("prescribed nodes start with the velocity of their condition, which "
                              "differs from the initial velocity of their body"
                              + up_to(change));
    return remarks;
  }


  template <int dim>
  Remarks jump_to_conditions(const Discretization<dim>     &discretization,
                             const ContactCoordinates<dim> &coordinates,
                             const Vector                  &displacement)
  {
    const double jump = differ_by(coordinates, displacement, coordinates.dirichlet_values(0.));
    Remarks      remarks;
    if (jump > 1e-9 * discretization.mesh().body_size())
      remarks.warnings.push_back("The first step moves prescribed nodes suddenly to where their "
                                 "conditions want them. With `Start = equilibrium` they begin "
                                 "there, at rest. They move"
                                 + up_to(jump));
    return remarks;
  }


#define INSTANTIATE(dim)                                                                           \
  template State   initial_state(const Discretization<dim> &);                                     \
  template Remarks start_with_conditions(                                                          \
    const Discretization<dim> &, const ContactCoordinates<dim> &, double, Vector &);               \
  template Remarks jump_to_conditions(                                                             \
    const Discretization<dim> &, const ContactCoordinates<dim> &, const Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
