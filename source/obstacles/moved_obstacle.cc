// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/moved_obstacle.h>

#include <deal.II/base/symmetric_tensor.h>

#include <limits>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  MovedObstacle<dim>::MovedObstacle(const NamedObstacle<dim> &obstacle)
    : shape(obstacle.shape)
    , motion(obstacle.motion)
  {
    before.rotation = after.rotation = Tensor<2, dim>(unit_symmetric_tensor<dim>());
    for (const auto &side : shape->sides())
      parts.push_back(MovedObstacle({obstacle.name, side, motion}));
    move(0., 0.);
  }


  template <int dim>
  void MovedObstacle<dim>::move(const double start, const double end)
  {
    if (!motion)
      return;
    before   = motion->place(start);
    after    = motion->place(end);
    duration = end - start;
    between  = motion->places_between(start, end);
    for (MovedObstacle &part : parts)
      {
        part.before   = before;
        part.after    = after;
        part.duration = duration;
        part.between  = between;
      }
  }


  template <int dim>
  std::optional<ObstacleProjection<dim>> MovedObstacle<dim>::try_project(const Point<dim> &p) const
  {
    const auto way = shape->try_project(after.back(p));
    return way ? std::optional(turned(*way, after)) : std::nullopt;
  }


  template <int dim>
  std::optional<ObstacleProjection<dim>>
  MovedObstacle<dim>::try_project_before(const Point<dim> &p) const
  {
    const auto way = shape->try_project(before.back(p));
    return way ? std::optional(turned(*way, before)) : std::nullopt;
  }


  template <int dim>
  MotionCondition<dim> MovedObstacle<dim>::condition_of_motion(const Point<dim> &start,
                                                               const Point<dim> &end) const
  {
    if (!motion)
      return shape->condition_of_motion(start, end);
    const Point<dim>     first = before.back(start), second = after.back(end);
    MotionCondition<dim> condition = shape->condition_of_motion(first, second);
    const Point<dim>     middle    = first + 0.5 * (second - first);
    condition.obstacle_motion      = after.forth(middle) - before.forth(middle);

    const Tensor<2, dim> mean_rotation = 0.5 * (before.rotation + after.rotation);
    const Tensor<1, dim> normal        = transpose(invert(mean_rotation)) * condition.normal;
    const double         size          = normal.norm();
    condition.normal                   = normal / size;
    condition.bound = condition.bound / size + condition.normal * condition.obstacle_motion;
    condition.gap_per_slack *= size;
    return condition;
  }


  template <int dim>
  std::vector<std::array<Point<dim>, dim>> MovedObstacle<dim>::facets() const
  {
    auto result = shape->facets();
    if (motion)
      for (auto &facet : result)
        for (Point<dim> &corner : facet)
          corner = after.forth(corner);
    return result;
  }


  template <int dim>
  MotionCondition<dim> MovedObstacle<dim>::condition_at_end(const Point<dim> &start,
                                                            const Point<dim> &end) const
  {
    const ObstacleProjection<dim> way = project(end);
    MotionCondition<dim>          condition{way.normal, way.gap + way.normal * (end - start)};
    if (motion)
      condition.obstacle_motion = end - before.forth(after.back(end));
    return condition;
  }


  template <int dim>
  double MovedObstacle<dim>::depth_on_way(const Point<dim> &start,
                                          const Point<dim> &end,
                                          const double      noticed) const
  {
    const Point<dim>     first   = motion ? before.back(start) : start;
    const Tensor<1, dim> way     = (motion ? after.back(end) : end) - first;
    const double         length  = way.norm();
    constexpr double     nowhere = std::numeric_limits<double>::infinity();
    double               deepest = 0.;
    const auto           gap_at  = [&](const double part, const bool is_between) {
      const auto projection = shape->try_project(first + part * way);
      if (projection && is_between)
        deepest = std::max(deepest, projection->depth());
      return projection ? projection->gap : -nowhere;
    };
    struct Stretch
    {
      double start, end, gap_at_start, gap_at_end;
    };
    // Gaps change by no more than the way, so most stretches need not be halved.
    for (std::vector<Stretch> left{{0., 1., gap_at(0., false), gap_at(1., false)}}; !left.empty();)
      {
        const Stretch s = left.back();
        left.pop_back();
        const double way_of_stretch = (s.end - s.start) * length;
        const double at_most        = 0.5 * (way_of_stretch - s.gap_at_start - s.gap_at_end);
        if (at_most <= std::max(deepest, noticed) || 0.5 * way_of_stretch <= noticed)
          continue;
        const double middle = 0.5 * (s.start + s.end), gap = gap_at(middle, true);
        left.push_back({middle, s.end, gap, s.gap_at_end});
        left.push_back({s.start, middle, s.gap_at_start, gap});
      }
    return deepest;
  }


  template <int dim>
  double MovedObstacle<dim>::depth_between(const Point<dim> &start, const Point<dim> &end) const
  {
    double deepest = 0.;
    for (std::size_t k = 0; k < between.size(); ++k)
      {
        const double part = (k + 1.) / (between.size() + 1.);
        if (const auto way = shape->try_project(between[k].back(start + part * (end - start))))
          deepest = std::max(deepest, way->depth());
      }
    return deepest;
  }


  template class MovedObstacle<2>;
  template class MovedObstacle<3>;
} // namespace signorini
