// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/followed_contact.h>
#include <signorini/system/step_contact.h>

namespace signorini
{
  template <int dim>
  StepContact<dim>::StepContact(const Discretization<dim>                &discretization,
                                const DirichletConditions<dim>           &dirichlet,
                                ContactSurface<dim>                      &surface,
                                ContactCoordinates<dim>                  &coordinates,
                                const std::function<std::vector<bool>()> &held)
    : coordinates(coordinates)
    , surface(surface)
    , geometry(std::make_unique<FollowedContact<dim>>(discretization, dirichlet, surface))
    , held(held)
  {
    for (const unsigned int node : geometry->nodes())
      for (unsigned int c = 0; c < dim; ++c)
        entries_of_contact.push_back(dim * node + c);
  }


  template <int dim>
  StepContact<dim>::~StepContact() = default;


  template <int dim>
  double StepContact<dim>::geometry_work(const Vector &contact_force) const
  {
    const std::vector<double> missed = geometry->missed_gaps();
    Vector                    force  = contact_force;
    coordinates.force_to_contact(force); // without what others hand on to a node
    double work = 0.;
    for (std::size_t k = 0; k < missed.size(); ++k)
      if (missed[k] != 0.)
        work -= force.local_element(surface.nodes()[k].entry()) * missed[k];
    return dealii::Utilities::MPI::sum(work, contact_force.get_mpi_communicator());
  }


  template <int dim>
  void StepContact<dim>::arrive(const Vector &displacement, const double time)
  {
    Vector nothing;
    nothing.reinit(displacement);
    geometry->begin_step(displacement, nothing, time, time);
    take_over_geometry();
  }


  template <int dim>
  void StepContact<dim>::return_to(const State &start, const State &end)
  {
    Vector increment = end.displacement;
    increment -= start.displacement;
    geometry->begin_step(start.displacement, increment, start.time, end.time, latest_normals);
    take_over_geometry();
  }


  template <int dim>
  void StepContact<dim>::take_back(const State &start)
  {
    while (!moments.empty() && moments.front().time > start.time)
      moments.pop_front();
    if (moments.size() < 2)
      {
        arrive(start.displacement, start.time);
        return;
      }
    State                            before;
    const std::vector<unsigned int> &contact = entries();
    before.time                              = moments[1].time;
    before.displacement                      = start.displacement;
    for (std::size_t i = 0; i < contact.size(); ++i)
      before.displacement.local_element(contact[i]) = moments[1].displacement[i];
    return_to(before, start);
  }


  template <int dim>
  void StepContact<dim>::begin_step(const State      &start,
                                    const double      step_size,
                                    const StepNormals normals)
  {
    geometry->expect_forces(start.contact_force);
    geometry->begin_step(start.displacement,
                         expected_increment(start, step_size),
                         start.time,
                         start.time + step_size,
                         normals);
    latest_normals = normals;
    take_over_geometry();
    is_repetition = false;
  }


  template <int dim>
  Vector StepContact<dim>::expected_increment(const State &start, const double step_size)
  {
    const std::vector<unsigned int> &contact = entries();
    while (!moments.empty() && moments.front().time >= start.time)
      moments.pop_front(); // the step is made again
    moments.push_front({start.time, {}});
    for (const unsigned int i : contact)
      moments.front().displacement.push_back(start.displacement.local_element(i));
    if (moments.size() > 3)
      moments.pop_back();

    Vector expected = start.velocity;
    expected *= step_size;
    if (moments.size() == 1)
      return expected;
    const auto mean_velocity = [&](const unsigned int moment, const std::size_t i) {
      const Moment &to = moments[moment], &from = moments[moment + 1];
      return (to.displacement[i] - from.displacement[i]) / (to.time - from.time);
    };
    // What the bodies did on average is a better guess than their velocity: it has no vibrations
    // that the steps do not resolve, and contact has acted on it.
    for (std::size_t i = 0; i < contact.size(); ++i)
      {
        const double velocity              = moments.size() == 2
                                               ? mean_velocity(0, i)
                                               : 2. * mean_velocity(0, i) - mean_velocity(1, i);
        expected.local_element(contact[i]) = step_size * velocity;
      }
    return expected;
  }


  template <int dim>
  void StepContact<dim>::follow(const Vector &increment)
  {
    geometry->follow(increment);
    take_over_geometry();
    is_repetition = true;
  }


  template <int dim>
  void StepContact<dim>::take_over_geometry()
  {
    coordinates.follow_frames();
    if (!geometry->obstacles_move())
      return;
    motion_of_obstacles = geometry->obstacle_motion();
    // What follows another body is carried along: the motion of an obstacle is none of its own.
    coordinates.rotate_to_frames(motion_of_obstacles);
    for (const unsigned int i : coordinates.relative_entries())
      motion_of_obstacles.local_element(i) = 0.;
    coordinates.displacement_to_cartesian(motion_of_obstacles);
  }


  template <int dim>
  NormalGap StepContact<dim>::tangential_approach(const Vector &free_increment) const
  {
    return geometry->tangential_approach(free_increment);
  }


  template <int dim>
  void StepContact<dim>::face_end(const Vector &increment)
  {
    if (!geometry->may_turn())
      return;
    geometry->face_end(increment);
    coordinates.follow_frames();
  }


  template <int dim>
  void StepContact<dim>::face_motion()
  {
    if (!geometry->may_turn())
      return;
    geometry->face_motion();
    coordinates.follow_frames();
  }


  template <int dim>
  NormalGap StepContact<dim>::gaps_at_start() const
  {
    return geometry->gaps_at_start();
  }


  template <int dim>
  const Vector *StepContact<dim>::obstacle_motion() const
  {
    return geometry->obstacles_move() ? &motion_of_obstacles : nullptr;
  }


  template <int dim>
  Vector StepContact<dim>::drag() const
  {
    if (!geometry->obstacles_move())
      return {};
    Vector all = motion_of_obstacles, result;
    coordinates.displacement_to_contact(all);
    result.reinit(all);
    for (const auto &of_node : coordinates.tangential_entries())
      for (const unsigned int i : of_node)
        result.local_element(i) = all.local_element(i);
    return result;
  }


  template <int dim>
  double StepContact<dim>::mismatch(const Vector &increment)
  {
    return geometry->mismatch(increment, held());
  }


  template <int dim>
  bool StepContact<dim>::passes_through(const Vector &increment) const
  {
    return geometry->passes_through(increment);
  }


  template class StepContact<2>;
  template class StepContact<3>;
} // namespace signorini
