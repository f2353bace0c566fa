// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Velocities belong to the ends of a step, its conditions to the motion between them: where an
// obstacle is curved, what is tangential at an end is not so in the middle.

#include <signorini/contact/followed_contact.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  bool FollowedContact<dim>::turns(const Site &site) const
  {
    const Facing<dim> &facing = site.facings[site.bounding[0]];
    return site.bounding.size() == 1 && !facing.of_body && facing.is_there()
           && std::isfinite(facing.gap) && !was_inside(facing) && obstacle(facing).turn() == 0.
           && !obstacle(facing).is_flat()
           && dirichlet.nodes().count(surface.nodes()[site.first].node) == 0;
  }


  template <int dim>
  std::vector<double> FollowedContact<dim>::tangential_approach(const Vector &free_increment) const
  {
    std::vector<double> result(surface.nodes().size(), 0.);
    if (some_are_curved)
      for (const Site &site : sites)
        if (turns(site))
          {
            const Tensor<1, dim> turned =
              surface.nodes()[site.first].normal() - site.facings[site.bounding[0]].normal_at_start;
            result[site.first] = std::max(0., motion(site, free_increment) * turned);
          }
    return result;
  }


  template <int dim>
  void FollowedContact<dim>::face_end(const Vector &increment)
  {
    for_each_site(sites, discretization.communicator(), [&](const Site &site) {
      if (!turns(site))
        return;
      Site         at_end = site;
      Facing<dim> &facing = at_end.facings[at_end.bounding[0]];
      if (const auto end = obstacle(facing).try_project(site.start + motion(site, increment)))
        {
          facing.condition.normal = end->normal;
          write(at_end);
        }
    });
  }


  template <int dim>
  void FollowedContact<dim>::face_motion()
  {
    for (const Site &site : sites)
      if (turns(site))
        write(site);
  }


#define INSTANTIATE(dim)                                                                           \
  template bool                FollowedContact<dim>::turns(const Site &) const;                    \
  template std::vector<double> FollowedContact<dim>::tangential_approach(const Vector &) const;    \
  template void                FollowedContact<dim>::face_end(const Vector &);                     \
  template void                FollowedContact<dim>::face_motion();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
