// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/field_output.h>
#include <signorini/output/whole_file.h>

#include <chrono>
#include <utility>

namespace signorini
{
  template <int dim>
  FieldOutput<dim>::FieldOutput(const std::string &directory,
                                const MPI_Comm     communicator,
                                const bool         in_background)
    : communicator(communicator)
    , in_background(in_background)
    , volume_series(directory, "volume", communicator)
    , surface_series(directory, "surface", communicator)
  {
  }


  template <int dim>
  void FieldOutput<dim>::write(const State                  &state,
                               const Discretization<dim>    &discretization,
                               const ContactSurface<dim>    &surface,
                               const dealii::Vector<double> &indicators)
  {
    finish();
    if (last_step == state.step)
      return;
    const Vector displacement = discretization.interpolate_hanging_nodes(state.displacement);
    const Vector velocity     = discretization.interpolate_hanging_nodes(state.velocity);
    volume.build(discretization, displacement, velocity, indicators);
    with_surface = !surface.pairs().empty();
    if (with_surface)
      contact_surface.build(discretization, surface, state, displacement, velocity);

    last_step = state.step;
    last_time = state.time;
    // Where the system gives no thread, finish() does the work.
    const auto later = std::launch::deferred;
    pieces           = std::async(in_background ? std::launch::async | later : later,
                        [this, step = state.step, time = state.time] {
                          volume_series.write_piece(volume, step, time);
                          if (with_surface)
                            surface_series.write_piece(contact_surface, step, time);
                        });
    if (!in_background)
      finish();
  }


  template <int dim>
  void FieldOutput<dim>::finish()
  {
    if (!is_writing())
      return;
    // Until all is well, the moment may be written again.
    const unsigned int step = std::exchange(last_step, none);
    succeed_together(communicator, [this] { pieces.get(); });
    // Only now all pieces are there for the files that name them.
    volume_series.name_moment(volume, step, last_time);
    if (with_surface)
      surface_series.name_moment(contact_surface, step, last_time);
    last_step = step;
  }


  template <int dim>
  void FieldOutput<dim>::finish_if_written()
  {
    if (!is_writing())
      return;
    const bool here = pieces.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
    if (dealii::Utilities::MPI::min(here ? 1 : 0, communicator) == 1)
      finish();
  }


  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace signorini
