// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/base/user_error.h>
#include <signorini/contact/contact_frame.h>
#include <signorini/contact/followed_contact.h>
#include <signorini/contact/free_directions.h>
#include <signorini/contact/nodal_friction.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Of the size of the bodies. Beyond it contact would do work: a gap is one in the energy. */
    constexpr double relative_tolerance = 1e-12;
    /** Times in a step that an obstacle may take the place of another one that bounds a node. */
    constexpr unsigned int most_changes = 6;
    /** What is passed through by a smaller part of a cell is an edge, or nothing the mesh can see.
     */
    constexpr double part_of_cell = 0.25;
    /** A chord that is deeper, in its length, turns by more than 0.8 radian on a circle. */
    constexpr double deep_on_way = 0.1;
    /** Of an obstacle in a step, radians: its mean rotation is far from a rotation beyond. */
    constexpr double largest_turn = 1.;
    /** Of a unit normal at the end of a load step: forces of an equilibrium are found to as much.
     */
    constexpr double normals_agree = 1e-9;
    /** Of a unit normal, across those of the other obstacles at a node. */
    constexpr double independent = 0.1;
    constexpr double infinity    = std::numeric_limits<double>::infinity();


    /**
     * Call an action for each site. Where an obstacle has no distance, all processes throw
     * together. Collective.
     */
    template <typename Sites, typename Action>
    void for_each_site(Sites &sites, const MPI_Comm communicator, const Action &action)
    {
      std::vector<Complaint> complaints;
      try
        {
          for (auto &site : sites)
            action(site);
        }
      catch (const UserError &error)
        {
          complaints.emplace_back(1., error.what());
        }
      throw_worst(complaints, communicator);
    }
  } // namespace


  template <int dim>
  FollowedContact<dim>::FollowedContact(const Discretization<dim>      &discretization,
                                        const DirichletConditions<dim> &dirichlet,
                                        ContactSurface<dim>            &surface)
    : discretization(discretization)
    , dirichlet(dirichlet)
    , surface(surface)
    , at_obstacles(surface.at_obstacles())
  {
    const auto &nodes = surface.nodes();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (nodes[k].row > 0)
        ++sites.back().n_rows;
      else
        {
          sites.push_back({k, 1, {}, {}, {}, {}});
          for (const auto &[pair, area] : at_obstacles.surface().at(nodes[k].node).areas)
            sites.back().facings.push_back({pair, area, {}, infinity, {}});
        }
    for (unsigned int pair = 0; pair < surface.pairs().size(); ++pair)
      some_move = some_move || !at_obstacles.obstacle(pair).is_at_rest();
    find_friction();
  }


  template <int dim>
  void FollowedContact<dim>::find_friction()
  {
    std::vector<ContactNode<dim>> nodes;
    for (const Site &site : sites)
      for (const Facing &facing : site.facings)
        {
          nodes.push_back(surface.nodes()[site.first]);
          nodes.back().pair     = facing.pair;
          nodes.back().weight   = facing.area;
          nodes.back().friction = {};
        }
    assign_friction(discretization, dirichlet, surface.pairs(), nodes);
    auto node = nodes.begin();
    for (Site &site : sites)
      for (Facing &facing : site.facings)
        facing.friction = (node++)->friction;
  }


  template <int dim>
  Tensor<1, dim> FollowedContact<dim>::motion(const Site &site, const Vector &increment) const
  {
    const unsigned int node = surface.nodes()[site.first].node;
    Tensor<1, dim>     result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = increment.local_element(dim * node + c);
    return result;
  }


  template <int dim>
  void FollowedContact<dim>::begin_step(const Vector     &displacement,
                                        const Vector     &expected,
                                        const double      start,
                                        const double      end,
                                        const StepNormals normals)
  {
    normals_of_step = normals;
    surface.move_obstacles(start, end);
    for (unsigned int pair = 0; pair < surface.pairs().size(); ++pair)
      if (at_obstacles.obstacle(pair).turn() > largest_turn)
        throw StepError(
          "Contact/Pairs = " + surface.pairs()[pair].name
          + ": the obstacle turns by more than 1 radian in a step. Take smaller steps, "
            "or let `Time/Step size control` choose them.");
    double largest_coordinate = 0.;
    for_each_site(sites, discretization.communicator(), [&](Site &site) {
      site.displacement = motion(site, displacement);
      site.start        = surface.nodes()[site.first].position + site.displacement;
      for (unsigned int c = 0; c < dim; ++c)
        largest_coordinate = std::max(largest_coordinate, std::abs(site.start[c]));
      look_around(site);
    });
    largest_coordinate = Utilities::MPI::max(largest_coordinate, discretization.communicator());
    accepted           = relative_tolerance * discretization.mesh().body_size()
               + 16. * std::numeric_limits<double>::epsilon() * largest_coordinate;
    n_followed = 0;
    follow(expected);
  }


  template <int dim>
  void FollowedContact<dim>::look_around(Site &site) const
  {
    const double                         tolerance = at_obstacles.end_tolerance();
    std::vector<ObstacleProjection<dim>> ways;
    unsigned int                         closest = 0;
    for (unsigned int f = 0; f < site.facings.size(); ++f)
      {
        Facing &facing = site.facings[f];
        ways.push_back(at_obstacles.obstacle(facing.pair).project_before(site.start));
        facing.gap       = ways[f].is_carried(tolerance) ? ways[f].gap : infinity;
        facing.condition = {ways[f].normal, facing.gap};
        if (at_obstacles.is_closer(ways[f], ways[closest]))
          closest = f;
      }
    site.bounding = {closest};
    for (unsigned int f = 0; f < site.facings.size(); ++f)
      if (f != closest && site.facings[f].gap <= tolerance)
        add_row(site, f);
  }


  template <int dim>
  bool FollowedContact<dim>::is_in_reach(const Facing &facing, const Tensor<1, dim> &d) const
  {
    // The motion that is expected may turn out to be larger.
    return !at_obstacles.obstacle(facing.pair).is_at_rest() || facing.gap <= 2. * d.norm();
  }


  template <int dim>
  bool FollowedContact<dim>::add_row(Site &site, const unsigned int facing) const
  {
    if (site.bounding.size() == site.n_rows)
      return false;
    std::vector<Tensor<1, dim>> normals;
    for (const unsigned int f : site.bounding)
      normals.push_back(site.facings[f].condition.normal);
    const auto     frame  = orthonormal_frame<dim>(oblique_frame<dim>(normals));
    Tensor<1, dim> across = site.facings[facing].condition.normal;
    for (unsigned int row = 0; row < normals.size(); ++row)
      {
        Tensor<1, dim> other;
        for (unsigned int c = 0; c < dim; ++c)
          other[c] = frame[dim * row + c];
        across -= (across * other) * other;
      }
    if (across.norm() < independent)
      return false;
    site.bounding.push_back(facing);
    return true;
  }


  template <int dim>
  bool FollowedContact<dim>::enters(const Site           &site,
                                    const Facing         &facing,
                                    const Tensor<1, dim> &d) const
  {
    if (was_inside(facing) || !is_in_reach(facing, d))
      return false;
    const auto way = at_obstacles.obstacle(facing.pair).project(site.start + d);
    return way.is_carried(at_obstacles.end_tolerance()) && way.gap < -accepted;
  }


  template <int dim>
  void FollowedContact<dim>::bound_by_what_is_entered(Site &site, const Tensor<1, dim> &d) const
  {
    const auto gap_at_end = [&](const unsigned int f) {
      return at_obstacles.obstacle(site.facings[f].pair).project(site.start + d).gap;
    };
    for (unsigned int f = 0; f < site.facings.size(); ++f)
      if (std::find(site.bounding.begin(), site.bounding.end(), f) == site.bounding.end()
          && enters(site, site.facings[f], d) && !add_row(site, f) && n_followed < most_changes)
        {
          // No room, or nearly the same direction as another one: the deepest ones count.
          const auto least = std::max_element(
            site.bounding.begin(), site.bounding.end(), [&](const unsigned a, const unsigned b) {
              return gap_at_end(a) < gap_at_end(b);
            });
          if (gap_at_end(f) < gap_at_end(*least))
            {
              site.bounding.erase(least);
              if (site.bounding.empty() || !add_row(site, f))
                site.bounding = {f};
            }
        }
  }


  template <int dim>
  void FollowedContact<dim>::follow(const Vector &increment)
  {
    for_each_site(sites, discretization.communicator(), [&](Site &site) {
      const Tensor<1, dim> d = motion(site, increment);
      for (Facing &facing : site.facings)
        {
          // What cannot get there needs no more than the plane at the start.
          const auto &obstacle = at_obstacles.obstacle(facing.pair);
          const bool  at_end   = normals_of_step == StepNormals::at_end;
          if (std::isfinite(facing.gap) && is_in_reach(facing, d))
            facing.condition = at_end ? obstacle.condition_at_end(site.start, site.start + d)
                                      : obstacle.condition_of_motion(site.start, site.start + d);
          // What has come in past an end, or where no row was left, is not pushed out at once.
          if (was_inside(facing))
            facing.condition.bound = at_end
                                       ? facing.condition.bound - facing.gap
                                       : facing.condition.normal * facing.condition.obstacle_motion;
        }
      if (site.facings.size() > 1)
        bound_by_what_is_entered(site, d);
      write(site);
    });
    ++n_followed;
  }


  template <int dim>
  void FollowedContact<dim>::write(const Site &site)
  {
    // Rows without a bound show what else there is.
    std::vector<unsigned int> order = site.bounding;
    for (unsigned int f = 0; f < site.facings.size(); ++f)
      if (std::find(order.begin(), order.end(), f) == order.end())
        order.push_back(f);
    std::vector<Tensor<1, dim>> normals;
    for (const unsigned int f : site.bounding)
      normals.push_back(site.facings[f].condition.normal);
    const auto frame      = oblique_frame<dim>(normals);
    const auto conditions = dirichlet.nodes().find(surface.nodes()[site.first].node);
    for (unsigned int row = 0; row < site.n_rows; ++row)
      {
        const Facing    &facing = site.facings[order[row]];
        ContactNode<dim> node   = surface.nodes()[site.first + row];
        node.pair               = facing.pair;
        node.weight             = facing.area;
        node.friction           = facing.friction;
        node.n_bounds           = site.bounding.size();
        node.gap                = row < node.n_bounds ? facing.condition.bound : infinity;
        if (conditions == dirichlet.nodes().end())
          node.frame = frame;
        else if (meet_in_free_directions<dim>(conditions->second, normals[0], node))
          node.gap /= node.free_part; // prescribed displacements rest
        else
          node.gap = infinity;
        if (node.is_shared())
          node.dual = dual_frame<dim>(frame);
        // The surface counts displacements from the reference configuration.
        node.gap += node.normal() * site.displacement;
        surface.set_geometry(site.first + row, node);
      }
  }


  template <int dim>
  Vector FollowedContact<dim>::obstacle_motion() const
  {
    Vector result = discretization.make_vector();
    for (const Site &site : sites)
      {
        // Where several obstacles bound a node, that whose own motions are theirs along its
        // normals; where a part of the normal is prescribed, that which moves the bound.
        const ContactNode<dim>     &contact_node = surface.nodes()[site.first];
        const unsigned int          node         = contact_node.node;
        const auto                 &dual         = contact_node.dual_frame();
        const MotionCondition<dim> &only         = site.facings[site.bounding[0]].condition;
        Tensor<1, dim>              s            = only.obstacle_motion;
        if (contact_node.prescribed_part.norm() > 0.)
          s += (only.normal * s / contact_node.free_part - contact_node.normal() * s)
               * contact_node.normal();
        else if (site.bounding.size() > 1)
          {
            s = Tensor<1, dim>();
            for (unsigned int row = 0; row < site.bounding.size(); ++row)
              {
                const auto &condition = site.facings[site.bounding[row]].condition;
                for (unsigned int c = 0; c < dim; ++c)
                  s[c] += condition.normal * condition.obstacle_motion * dual[dim * row + c];
              }
          }
        for (unsigned int c = 0; c < dim; ++c)
          result.local_element(dim * node + c) = s[c];
      }
    return result;
  }


  template <int dim>
  bool FollowedContact<dim>::passes_through(const Vector &increment) const
  {
    bool any = false;
    for_each_site(sites, discretization.communicator(), [&](const Site &site) {
      const Tensor<1, dim> d = motion(site, increment);
      for (const Facing &facing : site.facings)
        {
          const MovedObstacle<dim> &obstacle = at_obstacles.obstacle(facing.pair);
          const double              length   = (d - facing.condition.obstacle_motion).norm();
          const double              least    = part_of_cell * std::pow(facing.area, 1. / (dim - 1));
          if (any || obstacle.is_flat() || facing.gap > length || length < least
              || was_inside(facing) || enters(site, facing, d))
            continue;
          // A chord of what slides along the surface is deep only if it turns far.
          const double depth = obstacle.depth_on_way(site.start, site.start + d);
          const bool   flies = std::max(facing.gap, obstacle.project(site.start + d).gap) > depth;
          any                = depth > least && (flies || depth > deep_on_way * length);
        }
    });
    return Utilities::MPI::max(static_cast<unsigned int>(any), discretization.communicator()) > 0;
  }


  template <int dim>
  double FollowedContact<dim>::mismatch(const Vector            &increment,
                                        const std::vector<bool> &matters) const
  {
    AssertDimension(matters.size(), surface.nodes().size());
    double largest = 0.;
    for_each_site(sites, discretization.communicator(), [&](const Site &site) {
      const Tensor<1, dim> d = motion(site, increment);
      for (unsigned int row = 0; row < site.bounding.size(); ++row)
        {
          const Facing             &facing   = site.facings[site.bounding[row]];
          const MovedObstacle<dim> &obstacle = at_obstacles.obstacle(facing.pair);
          const bool                is_held  = matters[site.first + row];
          if (facing.gap == infinity || obstacle.is_flat() || (!is_held && !is_in_reach(facing, d)))
            continue;
          const double admitted = was_inside(facing) ? facing.gap : 0.;
          const auto   way      = obstacle.project(site.start + d);
          const double gap      = way.gap - admitted;
          if ((is_held && facing.condition.is_exact) || gap < 0.)
            largest = std::max(largest, std::abs(gap - facing.condition.gap_after(d)));
          if (is_held && normals_of_step == StepNormals::at_end)
            largest = std::max(
              largest, (way.normal - facing.condition.normal).norm() / normals_agree * accepted);
        }
      if (site.facings.size() > 1)
        for (unsigned int f = 0; f < site.facings.size(); ++f)
          if (std::find(site.bounding.begin(), site.bounding.end(), f) == site.bounding.end()
              && enters(site, site.facings[f], d))
            largest = infinity;
    });
    return Utilities::MPI::max(largest, discretization.communicator()) / accepted;
  }


  template class FollowedContact<2>;
  template class FollowedContact<3>;
} // namespace signorini
