// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What the end of a motion says about the conditions that it was made with.

#include <signorini/contact/followed_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** What is passed through by a smaller part of a cell is an edge, or nothing the mesh can see.
     */
    constexpr double part_of_cell = 0.25;
    /** A visit of an obstacle that is less deep is none. */
    constexpr double noticed_of_cell = 0.01;
    /** A chord that is deeper, in its length, turns by more than 0.8 radian on a circle. */
    constexpr double deep_on_way = 0.1;
    /** Of a unit normal at the end of a load step: forces of an equilibrium are found to as much.
     */
    constexpr double normals_agree = 1e-9;
    /** What is accepted of a gap between bodies, in units of what is accepted at obstacles. */
    constexpr double bodies_by_obstacles = 10.;
    /**
     * Motions of a step that bodies are followed by, at most: where they meet with edges there may
     * be none that belongs to its own geometry.
     */
    constexpr unsigned int most_motions = 24;
    /** A mismatch that has no measure, in units of what is accepted. */
    constexpr double as_large_as_bodies = 1e12;
    constexpr double unlimited          = std::numeric_limits<double>::infinity();


    /**
     * Whether an obstacle comes to a node and leaves it again within a step, whose ends do not see
     * it.
     */
    template <int dim>
    bool pays_a_visit(const MovedObstacle<dim>     &obstacle,
                      const ContactSite<dim>       &site,
                      const Facing<dim>            &facing,
                      const dealii::Tensor<1, dim> &d)
    {
      const double noticed = noticed_of_cell * std::pow(facing.area, 1. / (dim - 1));
      if (!(facing.gap > noticed)
          || !(obstacle.depth_between(site.start, site.start + d) > noticed))
        return false;
      const auto last = obstacle.try_project(site.start + d);
      return !last || last->gap > noticed;
    }
  } // namespace


  template <int dim>
  bool FollowedContact<dim>::passes_through(const Vector &increment) const
  {
    if (pairs.any() && pairs.move_too_far(increment))
      return true;
    bool any = false;
    for_each_site(sites, discretization.communicator(), [&](const Site &site) {
      const Tensor<1, dim> d = motion(site, increment);
      for (const Facing<dim> &facing : site.facings)
        {
          if (facing.of_body || !facing.is_there())
            continue;
          const MovedObstacle<dim> &faced = obstacle(facing);
          if (any || pays_a_visit(faced, site, facing, d))
            {
              any = true;
              continue;
            }
          const double length = (d - facing.condition.obstacle_motion).norm();
          const double least  = part_of_cell * std::pow(facing.area, 1. / (dim - 1));
          if (faced.is_flat() || facing.gap > length || length < least || was_inside(facing)
              || enters(site, facing, d))
            continue;
          // A chord of what slides along the surface is deep only if it turns far.
          const double depth = faced.depth_on_way(site.start, site.start + d, least);
          const auto   last  = faced.try_project(site.start + d);
          const bool   flies = std::max(facing.gap, last ? last->gap : unlimited) > depth;
          any                = depth > least && (flies || depth > deep_on_way * length);
        }
    });
    return Utilities::MPI::max(static_cast<unsigned int>(any), discretization.communicator()) > 0;
  }


  template <int dim>
  double FollowedContact<dim>::mismatch_of(const Site           &site,
                                           const Facing<dim>    &facing,
                                           const Tensor<1, dim> &d,
                                           const bool            is_held) const
  {
    if (facing.of_body)
      {
        const PairCondition<dim> *opposite = facing.opposite;
        // What an equilibrium holds has to be there.
        if (is_held && normals_of_step == StepNormals::at_end
            && (opposite == nullptr || std::isnan(opposite->gap_at_end)))
          return as_large_as_bodies;
        if (opposite == nullptr || n_followed > most_motions
            || !(is_held || opposite->gap_at_end < 0.))
          return 0.;
        // A clipped bound cannot meet the true gap; what it misses comes to an end, too.
        const double missed = opposite->missed(),
                     wrong  = opposite->is_clipped ? missed - opposite->missed_before : missed;
        return std::abs(wrong) / (bodies_by_obstacles * wanted);
      }
    const MovedObstacle<dim> &faced = obstacle(facing);
    if (facing.gap == unlimited || faced.is_flat() || (!is_held && !is_in_reach(facing, d)))
      return 0.;
    const Point<dim> end = site.start + d;
    const auto       way = is_held ? std::optional(faced.project(end)) : faced.try_project(end);
    if (!way)
      return 0.;
    const double gap    = way->gap - (was_inside(facing) ? facing.gap : 0.);
    double       result = 0.;
    if ((is_held && facing.condition.is_exact) || gap < 0.)
      result = std::abs(gap - facing.condition.gap_after(d)) / wanted;
    if (is_held && normals_of_step == StepNormals::at_end)
      result = std::max(result, (way->normal - facing.condition.normal).norm() / normals_agree);
    return result;
  }


  template <int dim>
  double FollowedContact<dim>::mismatch(const Vector &increment, const std::vector<bool> &matters)
  {
    AssertDimension(matters.size(), surface.nodes().size());
    if (pairs.any())
      pairs.look_at_end(increment);
    double largest = 0.;
    for_each_site(sites, discretization.communicator(), [&](const Site &site) {
      const Tensor<1, dim> d = motion(site, increment);
      for (unsigned int row = 0; row < site.bounding.size(); ++row)
        largest = std::max(
          largest,
          mismatch_of(site, site.facings[site.bounding[row]], d, matters[site.first + row]));
      if (site.facings.size() > 1)
        for (unsigned int f = 0; f < site.facings.size(); ++f)
          if (!site.is_bounded_by(f) && enters(site, site.facings[f], d)
              && !(site.facings[f].of_body && n_followed > most_motions))
            largest = std::max(largest, -gap_after(site, site.facings[f], d) / accepted);
      if (misses_a_side(site, d))
        largest = std::max(largest, as_large_as_bodies);
    });
    return Utilities::MPI::max(largest, discretization.communicator());
  }


  template <int dim>
  std::vector<unsigned int> FollowedContact<dim>::nodes() const
  {
    std::vector<unsigned int> result = pairs.nodes();
    for (const Site &site : sites)
      result.push_back(surface.nodes()[site.first].node);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }


  template <int dim>
  std::vector<double> FollowedContact<dim>::missed_gaps() const
  {
    std::vector<double> result(surface.nodes().size(), 0.);
    for (const Site &site : sites)
      for (unsigned int row = 0; row < site.bounding.size(); ++row)
        if (const auto *opposite = site.facings[site.bounding[row]].opposite)
          result[site.first + row] = opposite->missed();
    return result;
  }


  template bool   FollowedContact<2>::passes_through(const Vector &) const;
  template double FollowedContact<2>::mismatch_of(const Site &,
                                                  const Facing<2> &,
                                                  const Tensor<1, 2> &,
                                                  bool) const;
  template double FollowedContact<2>::mismatch(const Vector &, const std::vector<bool> &);
  template std::vector<unsigned int> FollowedContact<2>::nodes() const;
  template std::vector<double>       FollowedContact<2>::missed_gaps() const;
  template bool                      FollowedContact<3>::passes_through(const Vector &) const;
  template double                    FollowedContact<3>::mismatch_of(const Site &,
                                                  const Facing<3> &,
                                                  const Tensor<1, 3> &,
                                                  bool) const;
  template double FollowedContact<3>::mismatch(const Vector &, const std::vector<bool> &);
  template std::vector<unsigned int> FollowedContact<3>::nodes() const;
  template std::vector<double>       FollowedContact<3>::missed_gaps() const;
} // namespace signorini
