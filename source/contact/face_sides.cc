// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/followed_contact.h>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Sides that are nearer than this part of a cell count, however small the motion. */
    constexpr double within = 0.25;
  } // namespace


  template <int dim>
  const MovedObstacle<dim> &FollowedContact<dim>::obstacle(const Facing &facing) const
  {
    const MovedObstacle<dim> &all = at_obstacles.obstacle(facing.pair);
    return facing.side == Facing::whole ? all : all.side(facing.side);
  }


  template <int dim>
  void FollowedContact<dim>::face_sides(Site &site, const Tensor<1, dim> &expected_motion) const
  {
    for (std::size_t first = 0; first < site.facings.size();)
      {
        const MovedObstacle<dim> &all = at_obstacles.obstacle(site.facings[first].pair);
        const unsigned int        n   = all.most_conditions();
        std::vector<unsigned int> sides;
        if (n > 1)
          {
            // The motion may turn out to be another one.
            const double cell  = std::pow(site.facings[first].area, 1. / (dim - 1));
            const double moved = all.relative_motion(site.start, site.start + expected_motion);
            sides              = all.sides_near_before(site.start, 2. * moved + within * cell);
          }
        for (unsigned int k = 0; k < n; ++k)
          site.facings[first + k].side = k < sides.size() ? sides[k]
                                         : k == 0         ? Facing::whole
                                                          : Facing::absent;
        first += n;
      }
  }


  template const MovedObstacle<2> &FollowedContact<2>::obstacle(const Facing &) const;
  template const MovedObstacle<3> &FollowedContact<3>::obstacle(const Facing &) const;
  template void FollowedContact<2>::face_sides(Site &, const Tensor<1, 2> &) const;
  template void FollowedContact<3>::face_sides(Site &, const Tensor<1, 3> &) const;
} // namespace signorini
