// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/box_tree.h>
#include <signorini/obstacles/closest_point.h>
#include <signorini/obstacles/faceted_obstacle.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  struct FacetedObstacle<dim>::Trees
  {
    using Rim   = std::array<Point<dim>, dim - 1>;
    using Boxes = std::vector<BoundingBox<dim>>;

    Trees(const Boxes              &facet_boxes,
          std::vector<unsigned int> numbers,
          const Boxes              &rim_boxes,
          std::vector<Rim>          rim_pieces)
      : facets(facet_boxes)
      , numbers(std::move(numbers))
      , rim(rim_boxes)
      , rim_pieces(std::move(rim_pieces))
    {
    }

    BoxTree<dim>              facets;
    std::vector<unsigned int> numbers; ///< of the facets in the surface
    BoxTree<dim>              rim;
    std::vector<Rim>          rim_pieces; ///< edges, in 2d points
  };


  /** The closest point of the surface. */
  template <int dim>
  struct FacetedObstacle<dim>::Foot
  {
    unsigned int           facet;
    ClosestPoint<dim, dim> place;
  };


  /** The facets at a foot: one, or those that meet there. */
  template <int dim>
  struct FacetedObstacle<dim>::Star
  {
    std::vector<unsigned int> facets;
    bool                      is_at_end      = false; ///< of the surface, or of the side
    bool                      is_in_a_corner = false; ///< an inner one, where the side goes on
  };


  template <int dim>
  FacetedObstacle<dim>::FacetedObstacle(std::shared_ptr<const Surface> shape,
                                        const unsigned int             side)
    : surface(std::move(shape))
    , side(side)
  {
    std::vector<BoundingBox<dim>>    boxes, rim_boxes;
    std::vector<unsigned int>        numbers;
    std::vector<typename Trees::Rim> rim;
    for (unsigned int f = 0; f < surface->facets().size(); ++f)
      if (belongs(f))
        {
          const auto &facet = surface->facets()[f];
          boxes.push_back(box_around(surface->corners(f)));
          numbers.push_back(f);
          for (unsigned int i = 0; i < dim; ++i)
            if (side == Surface::none && facet.neighbours[i] == Surface::none)
              {
                rim.emplace_back();
                for (unsigned int v = 0, k = 0; v < dim; ++v)
                  if (v != i)
                    rim.back()[k++] = surface->vertices()[facet.vertices[v]];
                rim_boxes.push_back(box_around(rim.back()));
              }
        }
    trees = std::make_unique<const Trees>(boxes, std::move(numbers), rim_boxes, std::move(rim));
  }


  template <int dim>
  FacetedObstacle<dim>::~FacetedObstacle() = default;


  template <int dim>
  typename FacetedObstacle<dim>::Foot FacetedObstacle<dim>::find_foot(const Point<dim> &p) const
  {
    // Of a point whose distances are no numbers any facet is the nearest.
    const unsigned int any = trees->numbers.front();
    Foot               foot{any, closest_point(p, surface->corners(any))};
    double             least = std::numeric_limits<double>::infinity();
    trees->facets.least_square_distance(p, [&](const unsigned int thing) {
      const auto   facet    = trees->numbers[thing];
      const auto   place    = closest_point(p, surface->corners(facet));
      const double distance = p.distance_square(place.foot);
      if (distance < least)
        {
          least = distance;
          foot  = {facet, place};
        }
      return distance;
    });
    return foot;
  }


  template <int dim>
  double FacetedObstacle<dim>::distance_to_rim(const Point<dim> &p) const
  {
    return std::sqrt(trees->rim.least_square_distance(p, [&](const unsigned int piece) {
      return p.distance_square(closest_point(p, trees->rim_pieces[piece]).foot);
    }));
  }


  template <int dim>
  unsigned int FacetedObstacle<dim>::side_at(const Point<dim> &p) const
  {
    return surface->facets()[find_foot(p).facet].side;
  }


  template <int dim>
  std::set<unsigned int> FacetedObstacle<dim>::sides_around(const Point<dim> &p,
                                                            const double      reach) const
  {
    std::set<unsigned int> result;
    trees->facets.for_each_near(p, reach, [&](const unsigned int thing) {
      result.insert(surface->facets()[trees->numbers[thing]].side);
    });
    return result;
  }


  template <int dim>
  void FacetedObstacle<dim>::look_at_ridge(const unsigned int facet,
                                           const unsigned int ridge,
                                           Star              &star) const
  {
    if (belongs(surface->facets()[facet].neighbours[ridge]))
      return;
    if (surface->is_inner_corner(facet, ridge))
      star.is_in_a_corner = true;
    else
      star.is_at_end = true;
  }


  template <int dim>
  typename FacetedObstacle<dim>::Star FacetedObstacle<dim>::star_of(const Foot &foot) const
  {
    Star        star{{foot.facet}, false, false};
    const auto  is_out  = [](const double weight) { return weight == 0.; };
    const auto &weights = foot.place.weights;
    const auto  n_out   = std::count_if(weights.begin(), weights.end(), is_out);
    if (n_out == 0)
      return star;
    const auto &facet = surface->facets()[foot.facet];
    if (dim == 2 || n_out == 1)
      {
        const unsigned int ridge =
          std::find_if(weights.begin(), weights.end(), is_out) - weights.begin();
        if (belongs(facet.neighbours[ridge]))
          star.facets.push_back(facet.neighbours[ridge]);
        look_at_ridge(foot.facet, ridge, star);
        return star;
      }
    const unsigned int place = std::max_element(weights.begin(), weights.end()) - weights.begin();
    star.facets.clear();
    for (const unsigned int f : surface->facets_at(facet.vertices[place]))
      if (belongs(f))
        {
          star.facets.push_back(f);
          for (unsigned int i = 0; i < dim; ++i)
            if (surface->facets()[f].vertices[i] != facet.vertices[place])
              look_at_ridge(f, i, star);
        }
    return star;
  }


  template <int dim>
  ObstacleProjection<dim> FacetedObstacle<dim>::project(const Point<dim> &p) const
  {
    const Foot           foot = find_foot(p);
    const Star           star = star_of(foot);
    const auto          &all  = surface->facets();
    const Tensor<1, dim> away = p - foot.place.foot;
    Tensor<1, dim>       pseudonormal;
    double               spread  = 0.; // of the normals
    unsigned int         highest = star.facets.front();
    for (const unsigned int f : star.facets)
      {
        pseudonormal += surface->angle_at(f, foot.place.foot) * all[f].normal;
        spread = std::max(spread, (all[f].normal - all[star.facets.front()].normal).norm());
        if (all[f].height(p) > all[highest].height(p))
          highest = f;
      }
    pseudonormal /= pseudonormal.norm();
    if (star.is_at_end)
      {
        const double gap = away * pseudonormal;
        return {gap, -pseudonormal, (away - gap * pseudonormal).norm()};
      }
    ObstacleProjection<dim> result{all[highest].height(p), -all[highest].normal};
    // The direction to the foot is right but for round-off over the distance, the normal of a facet
    // but for the spread.
    if (const double distance = away.norm();
        !star.is_in_a_corner && distance * spread > surface->round_off())
      {
        result.gap    = away * pseudonormal < 0. ? -distance : distance;
        result.normal = -away / result.gap;
      }
    if (!trees->rim.empty())
      result.beyond = -distance_to_rim(foot.place.foot);
    return result;
  }


  template class FacetedObstacle<2>;
  template class FacetedObstacle<3>;
} // namespace signorini
