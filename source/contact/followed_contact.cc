// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/contact_frame.h>
#include <signorini/contact/followed_contact.h>
#include <signorini/contact/free_directions.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Of the size of the bodies. Beyond it contact would do work: a gap is one in the energy. */
    constexpr double relative_tolerance = 1e-12;
    /** Times that a node may change its mind in a step about the obstacle that it meets. */
    constexpr unsigned int most_changes = 4;
    constexpr double       infinity     = std::numeric_limits<double>::infinity();
  } // namespace


  template <int dim>
  FollowedContact<dim>::FollowedContact(const Discretization<dim>      &discretization,
                                        const DirichletConditions<dim> &dirichlet,
                                        ContactSurface<dim>            &surface)
    : discretization(discretization)
    , dirichlet(dirichlet)
    , surface(surface)
    , at_obstacles(surface.at_obstacles())
    , nodes(surface.nodes().size())
  {
    for (unsigned int pair = 0; pair < surface.pairs().size(); ++pair)
      some_move = some_move || !at_obstacles.obstacle(pair).is_at_rest();
  }


  template <int dim>
  Tensor<1, dim> FollowedContact<dim>::motion(const std::size_t k, const Vector &increment) const
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = increment.local_element(dim * surface.nodes()[k].node + c);
    return result;
  }


  template <int dim>
  void FollowedContact<dim>::begin_step(const Vector &displacement,
                                        const Vector &expected,
                                        const double  start,
                                        const double  end)
  {
    surface.move_obstacles(start, end);
    double largest_coordinate = 0.;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        Node &node        = nodes[k];
        node.displacement = motion(k, displacement);
        node.start        = surface.nodes()[k].position + node.displacement;
        for (unsigned int c = 0; c < dim; ++c)
          largest_coordinate = std::max(largest_coordinate, std::abs(node.start[c]));
        const auto  &areas = at_obstacles.surface().at(surface.nodes()[k].node).areas;
        unsigned int pair  = areas.front().first;
        if (areas.size() > 1)
          for (const auto &[other, area] : areas)
            if (at_obstacles.is_closer(at_obstacles.obstacle(other).project_before(node.start),
                                       at_obstacles.obstacle(pair).project_before(node.start)))
              pair = other;
        face(node, pair);
      }
    largest_coordinate = Utilities::MPI::max(largest_coordinate, discretization.communicator());
    accepted           = relative_tolerance * discretization.mesh().body_size()
               + 16. * std::numeric_limits<double>::epsilon() * largest_coordinate;
    n_followed = 0;
    follow(expected);
  }


  template <int dim>
  void FollowedContact<dim>::face(Node &node, const unsigned int pair) const
  {
    const ObstacleProjection<dim> way = at_obstacles.obstacle(pair).project_before(node.start);
    node.pair                         = pair;
    node.gap       = way.is_carried(at_obstacles.end_tolerance()) ? way.gap : infinity;
    node.condition = {way.normal, node.gap};
  }


  template <int dim>
  void FollowedContact<dim>::face_what_is_entered(const std::size_t k, const Point<dim> &end)
  {
    const auto gap_at_end = [&](const unsigned int pair) {
      const auto way = at_obstacles.obstacle(pair).project(end);
      return way.is_carried(at_obstacles.end_tolerance()) ? way.gap : infinity;
    };
    Node  &node    = nodes[k];
    double deepest = std::min(-accepted, gap_at_end(node.pair));
    for (const auto &[other, area] : at_obstacles.surface().at(surface.nodes()[k].node).areas)
      if (const double gap = gap_at_end(other); gap < deepest)
        {
          deepest = gap;
          face(node, other);
        }
  }


  template <int dim>
  void FollowedContact<dim>::follow(const Vector &increment)
  {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        Node                &node = nodes[k];
        const Tensor<1, dim> d    = motion(k, increment);
        const Point<dim>     end  = node.start + d;
        if (n_followed < most_changes
            && at_obstacles.surface().at(surface.nodes()[k].node).areas.size() > 1)
          face_what_is_entered(k, end);
        const MovedObstacle<dim> &obstacle = at_obstacles.obstacle(node.pair);
        // What cannot get there needs no more than the plane at the start.
        if (std::isfinite(node.gap)
            && (!obstacle.is_at_rest() || (node.gap < 2. * d.norm() && !obstacle.is_flat())))
          node.condition = obstacle.condition_of_motion(node.start, end);
        enter(k);
      }
    ++n_followed;
  }


  template <int dim>
  void FollowedContact<dim>::enter(const std::size_t k)
  {
    const Node      &node         = nodes[k];
    ContactNode<dim> contact_node = surface.nodes()[k];
    if (contact_node.pair != node.pair)
      {
        const auto &areas = at_obstacles.surface().at(contact_node.node).areas;
        contact_node.weight =
          std::find_if(areas.begin(), areas.end(), [&](const auto &pair_and_area) {
            return pair_and_area.first == node.pair;
          })->second;
        contact_node.pair = node.pair;
      }
    contact_node.gap      = node.condition.bound;
    const auto conditions = dirichlet.nodes().find(contact_node.node);
    if (conditions == dirichlet.nodes().end())
      contact_node.frame = contact_frame(node.condition.normal);
    else if (meet_in_free_directions<dim>(conditions->second, node.condition.normal, contact_node))
      contact_node.gap /= contact_node.free_part; // prescribed displacements rest
    else
      contact_node.gap = infinity;
    // The surface counts displacements from the reference configuration.
    contact_node.gap += contact_node.normal() * node.displacement;
    surface.set_geometry(k, contact_node);
  }


  template <int dim>
  Vector FollowedContact<dim>::obstacle_motion() const
  {
    Vector result = discretization.make_vector();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < dim; ++c)
        result.local_element(dim * surface.nodes()[k].node + c) =
          nodes[k].condition.obstacle_motion[c];
    return result;
  }


  template <int dim>
  double FollowedContact<dim>::mismatch(const Vector            &increment,
                                        const std::vector<bool> &matters) const
  {
    AssertDimension(matters.size(), nodes.size());
    double largest = 0.;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const Node               &node     = nodes[k];
        const MovedObstacle<dim> &obstacle = at_obstacles.obstacle(node.pair);
        if (node.gap == infinity || obstacle.is_flat())
          continue;
        const Tensor<1, dim> d = motion(k, increment);
        if (!matters[k] && node.gap > 2. * d.norm() && obstacle.is_at_rest())
          continue;
        const double gap = obstacle.project(node.start + d).gap;
        if (matters[k] || gap < 0.)
          largest = std::max(largest, std::abs(gap - node.condition.gap_after(d)));
      }
    return Utilities::MPI::max(largest, discretization.communicator()) / accepted;
  }


  template class FollowedContact<2>;
  template class FollowedContact<3>;
} // namespace signorini
