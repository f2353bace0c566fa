// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/base/user_error.h>
#include <signorini/contact/followed_contact.h>
#include <signorini/contact/nodal_friction.h>
#include <signorini/surfaces/contact_frame.h>

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
    /**
     * A gap that is wrong by this part of what contact strains makes forces wrong by about as much;
     * of the size of the bodies at least, where round-off begins.
     */
    constexpr double part_of_strain = 1e-12, finest_tolerance = 1e-14;
    /** Times in a step that an obstacle may take the place of another one that bounds a node. */
    constexpr unsigned int most_changes = 6;
    /** Of an obstacle in a step, radians: its mean rotation is far from a rotation beyond. */
    constexpr double largest_turn = 1.;
    /**
     * Motions of a step after which the geometry of bodies follows no more: where nodes appear and
     * vanish with the motion there may be none that has its own geometry. That of the motion that
     * was expected is kept then, because it does not depend on where the repetitions have led.
     */
    constexpr unsigned int most_full_steps = 12;
    constexpr double       infinity        = std::numeric_limits<double>::infinity();


  } // namespace


  template <int dim>
  FollowedContact<dim>::FollowedContact(const Discretization<dim>      &discretization,
                                        const DirichletConditions<dim> &dirichlet,
                                        ContactSurface<dim>            &surface)
    : discretization(discretization)
    , dirichlet(dirichlet)
    , surface(surface)
    , at_obstacles(surface.at_obstacles())
    , pairs(surface.followed_pairs())
  {
    const auto &nodes = surface.nodes();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (nodes[k].row > 0)
        ++sites.back().n_rows;
      else
        {
          sites.push_back({k});
          const auto &of_obstacles = at_obstacles.surface();
          if (const auto node = of_obstacles.find(nodes[k].node); node != of_obstacles.end())
            for (const auto &[pair, area] : node->second.areas)
              for (unsigned int n = at_obstacles.obstacle(pair).most_conditions(); n > 0; --n)
                sites.back().facings.push_back({pair, false, area, {}});
          for (const auto &[pair, bodies] : pairs.pairs())
            if (const auto node = bodies->slave_nodes().find(nodes[k].node);
                node != bodies->slave_nodes().end())
              sites.back().facings.push_back({pair, true, node->second, {}});
        }
    for (unsigned int pair = 0; pair < surface.pairs().size(); ++pair)
      if (!surface.pairs()[pair].of_two_bodies())
        {
          const MovedObstacle<dim> &faced = at_obstacles.obstacle(pair);
          some_move                       = some_move || !faced.is_at_rest();
          some_are_curved                 = some_are_curved || !faced.is_flat();
        }
    find_friction();
  }


  template <int dim>
  void FollowedContact<dim>::find_friction()
  {
    std::vector<ContactNode<dim>> nodes;
    for (const Site &site : sites)
      for (const Facing<dim> &facing : site.facings)
        {
          nodes.push_back(surface.nodes()[site.first]);
          nodes.back().pair      = facing.pair;
          nodes.back().weight    = facing.area;
          nodes.back().free_part = 1.; // turns with the motion, see ContactSite::contact_node()
          nodes.back().friction  = {};
        }
    assign_friction(discretization, dirichlet, surface.pairs(), nodes);
    auto node = nodes.begin();
    for (Site &site : sites)
      for (Facing<dim> &facing : site.facings)
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
  void FollowedContact<dim>::expect_forces(const Vector &contact_force)
  {
    double softest = infinity;
    for (const auto &body : discretization.mesh().bodies())
      softest = std::min(softest, body.material.youngs_modulus);
    std::vector<double> force_and_area(2, 0.);
    for (const Site &site : sites)
      if (const double force = motion(site, contact_force).norm(); force > 0.)
        {
          force_and_area[0] += force;
          force_and_area[1] += surface.nodes()[site.first].weight;
        }
    Utilities::MPI::sum(force_and_area, discretization.communicator(), force_and_area);
    strain = force_and_area[1] > 0. ? force_and_area[0] / force_and_area[1] / softest : 0.;
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
      if (!surface.pairs()[pair].of_two_bodies()
          && at_obstacles.obstacle(pair).turn() > largest_turn)
        throw StepError(
          "Contact/Pairs = " + surface.pairs()[pair].name
          + ": the obstacle turns by more than 1 radian in a step. Take smaller steps, "
            "or let `Time/Step size control` choose them.");
    if (pairs.any())
      pairs.begin_step(displacement, expected, normals);
    double largest_coordinate = 0.;
    for_each_site(sites, discretization.communicator(), [&](Site &site) {
      site.displacement = motion(site, displacement);
      site.start        = surface.nodes()[site.first].position + site.displacement;
      for (unsigned int c = 0; c < dim; ++c)
        largest_coordinate = std::max(largest_coordinate, std::abs(site.start[c]));
      face_sides(site, motion(site, expected));
      look_around(site);
      for (const Facing<dim> &facing : site.facings)
        if (!facing.of_body && facing.is_there() && is_in_reach(facing, motion(site, expected)))
          largest_coordinate = std::max(largest_coordinate, obstacle(facing).lever(site.start));
    });
    largest_coordinate     = Utilities::MPI::max(largest_coordinate, discretization.communicator());
    const double size      = discretization.mesh().body_size();
    const double round_off = 16. * std::numeric_limits<double>::epsilon() * largest_coordinate;
    const double part = std::clamp(part_of_strain * strain, finest_tolerance, relative_tolerance);
    accepted          = relative_tolerance * size + round_off;
    wanted            = strain > 0. ? part * size + round_off : accepted;
    n_followed        = 0;
    follow(expected);
  }


  template <int dim>
  void FollowedContact<dim>::look_around(Site &site) const
  {
    const double            tolerance = at_obstacles.end_tolerance();
    std::pair<bool, double> closest(true, infinity); // whether it does not carry; gap
    for (Facing<dim> &facing : site.facings)
      facing.gap = infinity;
    update_opposite(site);
    for (unsigned int f = 0; f < site.facings.size(); ++f)
      {
        Facing<dim>            &facing = site.facings[f];
        std::pair<bool, double> rank;
        if (facing.of_body)
          rank = {facing.opposite == nullptr, facing.gap};
        else
          {
            const auto way =
              facing.is_there() ? obstacle(facing).try_project_before(site.start) : std::nullopt;
            const auto projection  = way.value_or(far_projection<dim>());
            rank                   = {!projection.is_carried(tolerance), projection.gap};
            facing.gap             = rank.first ? infinity : projection.gap;
            facing.condition       = {projection.normal, facing.gap};
            facing.normal_at_start = projection.normal;
          }
        if (f == 0 || rank < closest)
          {
            closest       = rank;
            site.bounding = {f};
          }
      }
    const unsigned int first = site.bounding[0];
    for (unsigned int f = 0; f < site.facings.size(); ++f)
      if (f != first && site.facings[f].gap <= tolerance && site.facings[first].is_there())
        site.add_row(f);
  }


  template <int dim>
  void FollowedContact<dim>::update_opposite(Site &site) const
  {
    for (Facing<dim> &facing : site.facings)
      if (facing.of_body)
        {
          facing.set_opposite(pairs.find(facing.pair, surface.nodes()[site.first].node));
          if (facing.is_there() && facing.gap == infinity)
            facing.gap = facing.opposite->gap_at_start;
        }
  }


  template <int dim>
  bool FollowedContact<dim>::is_in_reach(const Facing<dim> &facing, const Tensor<1, dim> &d) const
  {
    if (facing.of_body)
      return facing.is_there();
    // The motion that is expected may turn out to be larger.
    return !at_obstacles.obstacle(facing.pair).is_at_rest() || facing.gap <= 2. * d.norm();
  }


  template <int dim>
  bool FollowedContact<dim>::enters(const Site           &site,
                                    const Facing<dim>    &facing,
                                    const Tensor<1, dim> &d) const
  {
    if (facing.of_body)
      return facing.is_there() && facing.opposite->linear_gap() < -accepted;
    if (!facing.is_there() || was_inside(facing) || !is_in_reach(facing, d))
      return false;
    const auto way = obstacle(facing).try_project(site.start + d);
    return way && way->is_carried(at_obstacles.end_tolerance()) && way->gap < -accepted;
  }


  template <int dim>
  void FollowedContact<dim>::bound_by_what_is_entered(Site &site, const Tensor<1, dim> &d) const
  {
    const auto gap_at_end = [&](const unsigned int f) {
      return gap_after(site, site.facings[f], d);
    };
    for (unsigned int f = 0; f < site.facings.size(); ++f)
      if (!site.is_bounded_by(f) && enters(site, site.facings[f], d) && !site.add_row(f)
          && n_followed < most_changes)
        {
          // No room, or nearly the same direction as another one: the deepest ones count.
          const auto least = std::max_element(
            site.bounding.begin(), site.bounding.end(), [&](const unsigned a, const unsigned b) {
              return gap_at_end(a) < gap_at_end(b);
            });
          if (gap_at_end(f) < gap_at_end(*least))
            {
              site.bounding.erase(least);
              if (site.bounding.empty() || !site.add_row(f))
                site.bounding = {f};
            }
        }
  }


  template <int dim>
  double FollowedContact<dim>::gap_after(const Site           &site,
                                         const Facing<dim>    &facing,
                                         const Tensor<1, dim> &d) const
  {
    if (facing.of_body)
      return facing.is_there() ? facing.opposite->linear_gap() : infinity;
    const auto way =
      facing.is_there() ? obstacle(facing).try_project(site.start + d) : std::nullopt;
    return way.value_or(far_projection<dim>()).gap;
  }


  template <int dim>
  void FollowedContact<dim>::follow(const Vector &increment)
  {
    if (pairs.any() && n_followed == most_full_steps && normals_of_step == StepNormals::of_motion)
      pairs.keep_geometry_of_expected();
    else if (pairs.any() && n_followed > 0)
      pairs.follow(increment);
    if (n_followed > most_full_steps)
      wanted = accepted;
    for_each_site(sites, discretization.communicator(), [&](Site &site) {
      const Tensor<1, dim> d = motion(site, increment);
      update_opposite(site);
      for (Facing<dim> &facing : site.facings)
        {
          if (facing.of_body || !facing.is_there())
            continue;
          // What cannot get there needs no more than the plane at the start.
          const auto &faced  = obstacle(facing);
          const bool  at_end = normals_of_step == StepNormals::at_end;
          if (std::isfinite(facing.gap) && is_in_reach(facing, d))
            facing.condition = at_end ? faced.condition_at_end(site.start, site.start + d)
                                      : faced.condition_of_motion(site.start, site.start + d);
          // What has come in past an end, or where no row was left, is not pushed out at once.
          if (was_inside(facing))
            facing.condition.bound = at_end
                                       ? facing.condition.bound - facing.gap
                                       : facing.condition.normal * facing.condition.obstacle_motion;
        }
      site.drop_what_is_gone();
      if (site.facings.size() > 1)
        bound_by_what_is_entered(site, d);
      write(site);
    });
    surface.complete_geometry();
    ++n_followed;
  }


  template <int dim>
  void FollowedContact<dim>::write(const Site &site)
  {
    const auto conditions = dirichlet.nodes().find(surface.nodes()[site.first].node);
    for (unsigned int row = 0; row < site.n_rows; ++row)
      surface.set_geometry(
        site.first + row,
        site.contact_node(row,
                          surface.nodes()[site.first + row],
                          conditions == dirichlet.nodes().end() ? nullptr : &conditions->second));
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


  template class FollowedContact<2>;
  template class FollowedContact<3>;
} // namespace signorini
