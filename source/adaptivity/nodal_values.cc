// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/nodal_values.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  Vector stress_at_nodes(const ContactSurface<dim>     &surface,
                         const ContactCoordinates<dim> &coordinates,
                         Vector                         forces)
  {
    coordinates.force_to_contact(forces);
    Vector stress;
    stress.reinit(forces);
    const auto divide = [&](const unsigned int entry, const double area) {
      stress.local_element(entry) = forces.local_element(entry) / area;
    };
    for (const ContactNode<dim> &node : surface.nodes())
      if (node.row == 0)
        for (unsigned int c = 0; c < dim; ++c)
          divide(dim * node.node + c, node.weight);
      else if (node.is_bounded()) // each obstacle at a node has an area of its own
        divide(node.entry(), node.weight);
    coordinates.force_from_frames(stress);
    return stress;
  }


  template <int dim>
  Vector forces_of_nodes(const ContactSurface<dim>     &surface,
                         const ContactCoordinates<dim> &coordinates,
                         const Vector                  &stress)
  {
    Vector local = stress;
    coordinates.force_to_frames(local);
    Vector forces;
    forces.reinit(stress);
    for (std::size_t k = 0; k < surface.nodes().size(); ++k)
      {
        const ContactNode<dim> &node   = surface.nodes()[k];
        const unsigned int      normal = coordinates.normal_entries()[k];
        if (!node.is_bounded())
          continue;
        forces.local_element(normal) = node.weight * std::min(0., local.local_element(normal));
        for (const unsigned int entry : coordinates.tangential_entries()[k])
          forces.local_element(entry) = node.weight * local.local_element(entry);
      }
    coordinates.force_to_cartesian(forces);
    return forces;
  }


  namespace
  {
    // No mean of these and zero is one of them again, unless all are the same.
    constexpr double slip_mark = 1., stick_mark = 1.4142135623730951;
  } // namespace


  template <int dim>
  Vector path_and_status(const ContactSurface<dim> &surface, const FrictionState &friction)
  {
    Vector values;
    values.reinit(friction.slip);
    for (std::size_t k = 0; k < surface.nodes().size(); ++k)
      {
        if (surface.nodes()[k].row > 0)
          continue; // friction is that of the first obstacle
        const unsigned int node        = dim * surface.nodes()[k].node;
        const char         status      = friction.status[k];
        values.local_element(node)     = friction.slip_path[k];
        values.local_element(node + 1) = contact_status::sticks(status)      ? stick_mark
                                         : contact_status::is_closed(status) ? slip_mark
                                                                             : 0.;
      }
    return values;
  }


  template <int dim>
  void set_path_and_status(const ContactSurface<dim> &surface,
                           const Vector              &values,
                           FrictionState             &friction)
  {
    for (const ContactNode<dim> &node : surface.nodes())
      {
        if (node.row > 0)
          {
            friction.slip_path.push_back(0.);
            friction.status.push_back(contact_status::open);
            continue;
          }
        friction.slip_path.push_back(values.local_element(dim * node.node));
        const double status = values.local_element(dim * node.node + 1);
        friction.status.push_back(std::abs(status - stick_mark) < 1e-6  ? contact_status::stick
                                  : std::abs(status - slip_mark) < 1e-6 ? contact_status::slip
                                                                        : contact_status::open);
      }
  }


#define INSTANTIATE(dim)                                                                           \
  template Vector stress_at_nodes(                                                                 \
    const ContactSurface<dim> &, const ContactCoordinates<dim> &, Vector);                         \
  template Vector forces_of_nodes(                                                                 \
    const ContactSurface<dim> &, const ContactCoordinates<dim> &, const Vector &);                 \
  template Vector path_and_status(const ContactSurface<dim> &, const FrictionState &);             \
  template void   set_path_and_status(const ContactSurface<dim> &, const Vector &, FrictionState &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
