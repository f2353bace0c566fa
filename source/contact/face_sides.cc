// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/followed_contact.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Sides that are nearer than this part of a cell count, however small the motion. */
    constexpr double within = 0.25;
  } // namespace


  template <int dim>
  const MovedObstacle<dim> &FollowedContact<dim>::obstacle(const Facing<dim> &facing) const
  {
    const MovedObstacle<dim> &all = at_obstacles.obstacle(facing.pair);
    return facing.side == Facing<dim>::whole ? all : all.side(facing.side);
  }


  template <int dim>
  void FollowedContact<dim>::face_sides(Site &site, const Tensor<1, dim> &expected_motion) const
  {
    for (std::size_t first = 0; first < site.facings.size();)
      {
        if (site.facings[first].of_body)
          return; // they come last
        const MovedObstacle<dim> &all = at_obstacles.obstacle(site.facings[first].pair);
        const unsigned int        n   = all.most_conditions();
        std::vector<unsigned int> sides;
        if (n > 1)
          {
            // The motion may turn out to be another one.
            const double     cell = std::pow(site.facings[first].area, 1. / (dim - 1));
            const Point<dim> end  = site.start + expected_motion;
            sides                 = all.sides_near(
              site.start, end, 2. * all.relative_motion(site.start, end) + within * cell);
          }
        for (unsigned int k = 0; k < n; ++k)
          site.facings[first + k].side = k < sides.size() ? sides[k]
                                         : k == 0         ? Facing<dim>::whole
                                                          : Facing<dim>::absent;
        first += n;
      }
  }


  template <int dim>
  bool FollowedContact<dim>::misses_a_side(const Site &site, const Tensor<1, dim> &d) const
  {
    // What none of the sides of an obstacle says about the end of the motion.
    const auto depth = [&](const MovedObstacle<dim> &at) {
      const auto way = at.project(site.start + d);
      return way.is_carried(at_obstacles.end_tolerance()) ? -way.gap : 0.;
    };
    std::map<unsigned int, double> deepest;
    for (const Facing<dim> &facing : site.facings)
      if (!facing.of_body && facing.side < Facing<dim>::absent)
        deepest[facing.pair] = std::max(deepest[facing.pair], depth(obstacle(facing)));
    return std::any_of(deepest.begin(), deepest.end(), [&](const auto &pair_depth) {
      const double most = std::max(2. * accepted, pair_depth.second + accepted);
      return depth(at_obstacles.obstacle(pair_depth.first)) > most;
    });
  }


  template const MovedObstacle<2> &FollowedContact<2>::obstacle(const Facing<2> &) const;
  template const MovedObstacle<3> &FollowedContact<3>::obstacle(const Facing<3> &) const;
  template bool FollowedContact<2>::misses_a_side(const Site &, const Tensor<1, 2> &) const;
  template bool FollowedContact<3>::misses_a_side(const Site &, const Tensor<1, 3> &) const;
  template void FollowedContact<2>::face_sides(Site &, const Tensor<1, 2> &) const;
  template void FollowedContact<3>::face_sides(Site &, const Tensor<1, 3> &) const;
} // namespace signorini
