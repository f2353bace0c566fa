// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/unseen_contact.h>
#include <signorini/discretization/common_boxes.h>
#include <signorini/discretization/common_points.h>
#include <signorini/obstacles/closest_point.h>

#include <deal.II/base/mpi.h>

#include <deal.II/numerics/rtree.h>

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/index/predicates.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** A node that bears is in contact with this other side, if that is as near. */
    constexpr double near_a_node = 0.25;
    /** Around a node that bears, estimates of the error know what contact misses. */
    constexpr double seen_around_a_node = 3.;
    /**
     * Height over distance. Beyond the end of a surface its nearest point is at its rim, hardly
     * below or above; behind hollow edges and corners of right angles it is 0.58 at least.
     */
    constexpr double steep = 0.5;
    /** What is less deep is round-off. */
    constexpr double noticed = 1e-6;


    /** Where facets are. */
    template <int dim>
    class Facets
    {
    public:
      using Facet = std::array<Point<dim>, dim>;

      explicit Facets(std::vector<Facet> all)
        : facets(std::move(all))
        , boxes(boxes_around(facets))
        , tree(pack_rtree_of_indices(boxes))
      {
      }

      /** Distance to the closest one, negative behind it. */
      std::optional<double> gap(const Point<dim> &point) const
      {
        namespace index = boost::geometry::index;
        double distance = std::numeric_limits<double>::infinity(), height = 0.;
        for (auto k = tree.qbegin(index::nearest(point, most_looked_at)); k != tree.qend(); ++k)
          {
            const double of_box = boost::geometry::distance(point, tree.indexable_get()(*k));
            if (of_box > distance)
              break;
            const Point<dim> foot  = closest_point(point, facets[*k]).foot;
            const double     above = (point - foot) * normal_of_facet<dim>(facets[*k]);
            const double     away  = point.distance(foot);
            // Of facets that are equally close, at their common edge, the steepest one counts.
            if (away < (1. - 1e-12) * distance
                || (away <= (1. + 1e-12) * distance && std::abs(above) > std::abs(height)))
              height = above;
            distance = std::min(distance, away);
          }
        return height < -steep * distance ? -distance : distance;
      }

      /** Whether the box of any of them meets another box. */
      bool any_in(const BoundingBox<dim> &box) const
      {
        return tree.qbegin(boost::geometry::index::intersects(box)) != tree.qend();
      }

    private:
      /** A facet is among them if it is the closest one: some boxes overlap. */
      static constexpr unsigned int most_looked_at = 16;

      const std::vector<Facet>                     facets;
      const std::vector<BoundingBox<dim>>          boxes;
      const decltype(pack_rtree_of_indices(boxes)) tree; // it looks boxes up

      static std::vector<BoundingBox<dim>> boxes_around(const std::vector<Facet> &facets)
      {
        std::vector<BoundingBox<dim>> boxes;
        for (const Facet &facet : facets)
          boxes.emplace_back(std::vector<Point<dim>>(facet.begin(), facet.end()));
        return boxes;
      }
    };
  } // namespace


  template <int dim>
  UnseenContact<dim>::UnseenContact(const Discretization<dim> &discretization,
                                    const ContactSurface<dim> &surface)
    : discretization(discretization)
    , surface(surface)
  {
    for (unsigned int p = 0; p < surface.pairs().size(); ++p)
      {
        const PairDescription &pair = surface.pairs()[p];
        add_side(p, pair.slave, pair.slave_boundary_ids);
        if (pair.of_two_bodies())
          add_side(p, pair.master, pair.master_boundary_ids);
      }
  }


  template <int dim>
  void UnseenContact<dim>::add_side(const unsigned int                     pair,
                                    const unsigned int                     body,
                                    const std::vector<types::boundary_id> &boundary_ids)
  {
    Side side{pair, {}};
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int face : cell->face_indices())
          if (is_surface_face<dim>(cell, face, body, boundary_ids))
            side.faces.emplace_back(cell, face);
    sides.push_back(std::move(side));
  }


  template <int dim>
  typename UnseenContact<dim>::Finding UnseenContact<dim>::find(const Vector &displacement,
                                                                const Vector &contact_force,
                                                                const double  time)
  {
    const unsigned int n_pairs = surface.pairs().size();
    Finding      result{std::vector<bool>(discretization.mesh().triangulation().n_active_cells()),
                   std::vector<double>(n_pairs, 0.),
                   std::vector<double>(n_pairs, 0.),
                   std::vector<double>(n_pairs, 0.)};
    const Vector moved  = discretization.interpolate_hanging_nodes(displacement),
                 forces = discretization.interpolate_hanging_nodes(contact_force);
    for (unsigned int s = 0; s < sides.size(); ++s)
      if (const unsigned int pair = sides[s].pair; surface.pairs()[pair].of_two_bodies())
        {
          judge(sides[s], other_body(sides[s + 1], sides[s], moved), moved, forces, result);
          judge(sides[s + 1], other_body(sides[s], sides[s + 1], moved), moved, forces, result);
          ++s;
        }
      else
        judge(sides[s], obstacle(pair, time), moved, forces, result);
    const MPI_Comm communicator = discretization.communicator();
    Utilities::MPI::max(result.depths, communicator, result.depths);
    Utilities::MPI::max(result.relative_depths, communicator, result.relative_depths);
    Utilities::MPI::max(
      result.relative_depths_of_nodes, communicator, result.relative_depths_of_nodes);
    return result;
  }


  template <int dim>
  typename UnseenContact<dim>::Opposite UnseenContact<dim>::obstacle(const unsigned int pair,
                                                                     const double       time) const
  {
    MovedObstacle<dim> there = surface.at_obstacles().obstacle(pair);
    there.move(time, time); // it may be where a step has put it that was taken back
    const auto gap = [there](const Point<dim> &point) -> std::optional<double> {
      const auto way = there.try_project(point);
      if (!way)
        return {};
      return way->depth() > 0. ? -way->depth() : way->distance();
    };
    const auto may_be_in = [gap](const BoundingBox<dim> &box) {
      const double size =
        box.get_boundary_points().first.distance(box.get_boundary_points().second);
      return gap(box.center()).value_or(size) < 0.5 * size;
    };
    return {gap, may_be_in};
  }


  template <int dim>
  typename UnseenContact<dim>::Opposite
  UnseenContact<dim>::other_body(Side &other, const Side &own, const Vector &displacement) const
  {
    CommonBoxes<dim> around;
    for (const FineFace<dim> &face : own.faces)
      {
        const auto corners = face.wide_box(displacement).get_boundary_points();
        around.add(corners.first);
        around.add(corners.second);
      }
    const BoundingBox<dim>  box = around.around_all(discretization.communicator())[0];
    std::vector<Point<dim>> own_corners; // of facets, one after the other
    for (FineFace<dim> &face : other.faces)
      if (boost::geometry::intersects(face.wide_box(displacement), box))
        for (const auto &facet : face.facets(displacement))
          own_corners.insert(own_corners.end(), facet.begin(), facet.end());
    const auto corners = common_points(own_corners, discretization.communicator());
    std::vector<std::array<Point<dim>, dim>> facets(corners.size() / dim);
    for (std::size_t k = 0; k < corners.size(); ++k)
      facets[k / dim][k % dim] = corners[k];
    const auto near = std::make_shared<const Facets<dim>>(std::move(facets));
    return {[near](const Point<dim> &point) { return near->gap(point); },
            [near](const BoundingBox<dim> &place) { return near->any_in(place); }};
  }


  template <int dim>
  std::pair<double, double>
  UnseenContact<dim>::range_of_gaps(const std::vector<Point<dim>> &vertices,
                                    const Opposite                &opposite)
  {
    double least = std::numeric_limits<double>::max(), largest = -least;
    for (const Point<dim> &vertex : vertices)
      {
        const double gap = opposite.gap(vertex).value_or(std::numeric_limits<double>::max());
        least            = std::min(least, gap);
        largest          = std::max(largest, gap);
      }
    return {least, largest};
  }


  template <int dim>
  void UnseenContact<dim>::judge(Side           &side,
                                 const Opposite &opposite,
                                 const Vector   &displacement,
                                 const Vector   &contact_force,
                                 Finding        &finding) const
  {
    std::vector<FineFace<dim> *> candidates;
    for (FineFace<dim> &face : side.faces)
      if (opposite.may_be_in(face.wide_box(displacement)))
        candidates.push_back(&face);
    const MPI_Comm     communicator = discretization.communicator();
    const unsigned int n_candidates = candidates.size();
    if (Utilities::MPI::sum(n_candidates, communicator) == 0)
      return;

    const auto bearing = pack_rtree(
      common_points(bearing_vertices(side, opposite, displacement, contact_force), communicator));
    for (FineFace<dim> *face : candidates)
      {
        const Point<dim> middle  = face->middle(displacement);
        const auto       nearest = bearing.qbegin(boost::geometry::index::nearest(middle, 1));
        if (nearest != bearing.qend()
            && middle.distance(*nearest) < seen_around_a_node * face->diameter())
          continue;
        const auto [least, largest] = range_of_gaps(face->vertices(displacement), opposite);
        const double of_nodes       = -largest / face->diameter();
        if (of_nodes <= 1. && surface.pairs()[side.pair].of_two_bodies())
          finding.relative_depths_of_nodes[side.pair] =
            std::max(finding.relative_depths_of_nodes[side.pair], of_nodes);
        if (!opposite.may_be_in(face->box(displacement)))
          continue;
        const bool   is_known = least < 0.; // by its vertices
        const double depth    = is_known ? 0. : -face->least(opposite.gap, displacement);
        // What is deeper than a face is wide is behind the other side.
        if (!(depth > noticed * face->diameter()) || depth > face->diameter())
          continue;
        finding.cells[face->cell()->active_cell_index()] = true;
        finding.depths[side.pair] = std::max(finding.depths[side.pair], depth);
        finding.relative_depths[side.pair] =
          std::max(finding.relative_depths[side.pair], depth / face->diameter());
      }
  }


  template <int dim>
  std::vector<Point<dim>> UnseenContact<dim>::bearing_vertices(const Side     &side,
                                                               const Opposite &opposite,
                                                               const Vector   &displacement,
                                                               const Vector   &contact_force) const
  {
    std::vector<Point<dim>> result;
    for (const FineFace<dim> &face : side.faces)
      {
        const std::vector<Point<dim>> vertices = face.vertices(displacement);
        for (unsigned int v = 0; v < vertices.size(); ++v)
          if (face.has_value(v, contact_force))
            if (const auto distance = opposite.gap(vertices[v]);
                distance && *distance < near_a_node * face.diameter())
              result.push_back(vertices[v]);
      }
    return result;
  }


  template class UnseenContact<2>;
  template class UnseenContact<3>;
} // namespace signorini
