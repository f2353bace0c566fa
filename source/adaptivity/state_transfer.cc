// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/energy_of_vibration.h>
#include <signorini/adaptivity/nodal_values.h>
#include <signorini/adaptivity/state_transfer.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/energy_projection.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /** All but the fields. */
    State clock_of(const State &state)
    {
      State result;
      result.step           = state.step;
      result.time           = state.time;
      result.last_step.size = state.last_step.size;
      return result;
    }


    /** Of energies. */
    constexpr double round_off = 1e-14;
    /**
     * Of a displacement, each with the normals of what the last one changed. These changes are
     * small: in the tests of changing meshes the first one has its own normals already. What the
     * last one misses is left as a gap or a depth to the next step, which sees the true ones.
     */
    constexpr unsigned int most_projections = 6;


    /** With the potential of the load. @param load null: none */
    double energy_of(const State &state, const Vector *load)
    {
      const double motion = 0.5 * dot(state.velocity, state.momentum)
                            + 0.5 * dot(state.displacement, state.internal_force);
      return load == nullptr ? motion : motion - dot(*load, state.displacement);
    }


    /** The fields of a state in the order in which they travel. */
    template <int dim>
    std::vector<typename FieldTransfer<dim>::Source>
    sources(const ContactSurface<dim>     &surface,
            const ContactCoordinates<dim> &coordinates,
            const State                   &state)
    {
      std::vector<typename FieldTransfer<dim>::Source> result = {
        {state.displacement, {&stiffness_moments<dim>, &mass_moments<dim>}, true},
        {state.velocity, {&mass_moments<dim>}},
        {stress_at_nodes(surface, coordinates, state.contact_force), {}}};
      if (state.acceleration.size() > 0)
        result.push_back({state.acceleration, {&mass_moments<dim>}});
      if (const FrictionState &friction = state.friction; friction.any())
        {
          result.push_back({stress_at_nodes(surface, coordinates, friction.force), {}});
          result.push_back({friction.slip, {}});
          result.push_back({friction.accumulated_slip, {}});
          result.push_back({path_and_status(surface, friction), {}});
        }
      if (state.last_step.any())
        result.push_back({state.last_step.velocity_change, {&mass_moments<dim>}});
      return result;
    }
  } // namespace


  template <int dim>
  StateTransfer<dim>::StateTransfer(Mesh<dim>                     &mesh,
                                    const Discretization<dim>     &discretization,
                                    const ContactSurface<dim>     &surface,
                                    const ContactCoordinates<dim> &coordinates,
                                    const State                   &state,
                                    const Vector                  *load)
    : clock(clock_of(state))
    , has_acceleration(state.acceleration.size() > 0)
    , has_friction(state.friction.any())
    , has_last_step(state.last_step.any())
    , elastic_size(std::sqrt(std::max(0., dot(state.internal_force, state.displacement))))
    , has_load(load != nullptr)
    , energy(energy_of(state, load))
    , fields(mesh, discretization, sources(surface, coordinates, state))
  {
  }


  template <int dim>
  State StateTransfer<dim>::finish(const Discretization<dim>     &discretization,
                                   ContactSurface<dim>           &surface,
                                   const ContactCoordinates<dim> &coordinates,
                                   DynamicalSystem               &system,
                                   const ActiveSetLimits         &limits)
  {
    auto       results = fields.unpack(discretization);
    auto       next    = results.begin();
    State      state   = clock;
    const auto in_mass = [&](typename FieldTransfer<dim>::Result &result) {
      if (!result.lost_moments.empty())
        result.field += system.solve_mass(result.lost_moments[0]);
      return std::move(result.field);
    };

    state.displacement = displacement_after(
      *next++, discretization, surface, coordinates, system.capabilities().moving_contact, limits);
    state.velocity      = in_mass(*next++);
    state.contact_force = forces_of_nodes(surface, coordinates, (next++)->field);
    if (has_acceleration)
      state.acceleration = in_mass(*next++);
    if (has_friction)
      {
        FrictionState &friction   = state.friction;
        friction.force            = forces_of_nodes(surface, coordinates, (next++)->field);
        friction.slip             = std::move((next++)->field);
        friction.accumulated_slip = std::move((next++)->field);
        set_path_and_status(surface, (next++)->field, friction);
      }
    if (has_last_step)
      {
        state.last_step.velocity_change = in_mass(*next++);
        state.last_step.momentum_change = discretization.make_vector();
        system.apply_mass(state.last_step.momentum_change, state.last_step.velocity_change);
      }
    state.momentum = state.internal_force = discretization.make_vector();
    system.apply_mass(state.momentum, state.velocity);
    system.apply_stiffness(state.internal_force, state.displacement);
    keep_energy(discretization, coordinates, system, state);
    return state;
  }


  template <int dim>
  Vector StateTransfer<dim>::displacement_after(const typename FieldTransfer<dim>::Result &result,
                                                const Discretization<dim>     &discretization,
                                                ContactSurface<dim>           &surface,
                                                const ContactCoordinates<dim> &coordinates,
                                                MovingContact                 *contact,
                                                const ActiveSetLimits         &limits) const
  {
    if (contact != nullptr)
      contact->arrive(result.field, clock.time);
    surface.admit(result.field);
    if (result.lost_moments.empty())
      return result.field;
    Vector correction;
    for (unsigned int repetition = 0; repetition < most_projections; ++repetition)
      {
        correction = project_in_energy(discretization,
                                       coordinates,
                                       result.lost_moments[0],
                                       result.lost_moments[1],
                                       surface.normal_gap(result.field),
                                       elastic_size,
                                       limits);
        if (contact == nullptr || contact->mismatch(correction) <= 1.)
          break;
        contact->follow(correction);
      }
    correction += result.field;
    if (contact != nullptr)
      contact->arrive(correction, clock.time);
    return correction;
  }


  template <int dim>
  void StateTransfer<dim>::keep_energy(const Discretization<dim>     &discretization,
                                       const ContactCoordinates<dim> &coordinates,
                                       DynamicalSystem               &system,
                                       State                         &state) const
  {
    Vector load;
    if (has_load)
      {
        load = system.make_vector();
        system.add_load(load, 1., state.time);
      }
    const double gain = energy_of(state, has_load ? &load : nullptr) - energy;
    const double size =
      dot(state.velocity, state.momentum) + dot(state.displacement, state.internal_force);
    if (gain > round_off * size)
      take_from_vibration(discretization, coordinates, gain, state);
  }


  template class StateTransfer<2>;
  template class StateTransfer<3>;
} // namespace signorini
