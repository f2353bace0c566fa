// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/nodal_values.h>
#include <signorini/checkpoint/packed_state.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  namespace
  {
    /** Entries that are not zero, on the first process those of all. Collective. */
    std::vector<std::pair<std::uint64_t, double>> nonzero_entries(const Vector &vector)
    {
      std::vector<std::pair<std::uint64_t, double>> entries;
      for (const auto i : vector.locally_owned_elements())
        if (const double value = vector(i); value != 0.)
          entries.emplace_back(i, value);
      const auto of_all = dealii::Utilities::MPI::gather(vector.get_mpi_communicator(), entries, 0);
      entries.clear();
      for (const auto &part : of_all)
        entries.insert(entries.end(), part.begin(), part.end());
      return entries;
    }


    /** The same numbers, with the ghosts of another system. */
    Vector in_system(const Vector &vector, DynamicalSystem &system)
    {
      Vector result = system.make_vector();
      for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
        result.local_element(i) = vector.local_element(i);
      return result;
    }
  } // namespace


  template <int dim>
  PackedState::PackedState(const State &state, const ContactSurface<dim> &surface)
    : everywhere{state.displacement, state.velocity}
    , at_contact{state.contact_force, surface.gaps()}
  {
    numbers.step           = state.step;
    numbers.time           = state.time;
    numbers.last_step.size = state.last_step.size;
    has_acceleration       = state.acceleration.size() > 0;
    if (has_acceleration)
      everywhere.push_back(state.acceleration);
    if (state.last_step.any())
      everywhere.push_back(state.last_step.velocity_change);
    if (state.friction.any())
      for (const Vector &values : {state.friction.force,
                                   state.friction.slip,
                                   state.friction.accumulated_slip,
                                   path_and_status(surface, state.friction)})
        at_contact.push_back(values);
  }


  template <int dim>
  State PackedState::unpack(ContactSurface<dim> &surface, DynamicalSystem &system) const
  {
    State state        = numbers;
    auto  next         = everywhere.begin();
    state.displacement = in_system(*next++, system);
    state.velocity     = in_system(*next++, system);
    if (has_acceleration)
      state.acceleration = in_system(*next++, system);
    state.momentum = state.internal_force = system.make_vector();
    system.apply_mass(state.momentum, state.velocity);
    system.apply_stiffness(state.internal_force, state.displacement);
    if (state.last_step.any())
      {
        state.last_step.velocity_change = in_system(*next++, system);
        state.last_step.momentum_change = system.make_vector();
        system.apply_mass(state.last_step.momentum_change, state.last_step.velocity_change);
      }
    auto value          = at_contact.begin();
    state.contact_force = in_system(*value++, system);
    if (surface.follows())
      ++value;
    else
      surface.set_gaps(*value++);
    if (MovingContact *contact = system.capabilities().moving_contact)
      contact->arrive(state.displacement, state.time);
    if (value == at_contact.end())
      return state;
    state.friction.force            = in_system(*value++, system);
    state.friction.slip             = in_system(*value++, system);
    state.friction.accumulated_slip = in_system(*value++, system);
    set_path_and_status(surface, in_system(*value++, system), state.friction);
    return state;
  }


  void PackedState::archive(Archive &archive, const Vector &like)
  {
    std::size_t n_everywhere = everywhere.size(), n_at_contact = at_contact.size();
    archive(numbers.step, numbers.time, numbers.last_step.size);
    archive(has_acceleration, n_everywhere, n_at_contact);
    everywhere.resize(n_everywhere, like);
    at_contact.resize(n_at_contact, like);
    for (Vector &vector : at_contact)
      {
        std::vector<std::pair<std::uint64_t, double>> entries;
        if (!archive.reads())
          entries = nonzero_entries(vector);
        archive(entries);
        if (!archive.reads())
          continue;
        vector = 0.;
        for (const auto &[i, entry] : entries)
          if (vector.in_local_range(i))
            vector(i) = entry;
      }
  }


#define INSTANTIATE(dim)                                                                           \
  template PackedState::PackedState(const State &, const ContactSurface<dim> &);                   \
  template State PackedState::unpack(ContactSurface<dim> &, DynamicalSystem &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
