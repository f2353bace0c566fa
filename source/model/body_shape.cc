// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/body_shape.h>
#include <signorini/model/cap.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace signorini
{
  template <int dim>
  dealii::Point<dim> centre_of_shape(const BodyDescription<dim> &body)
  {
    if (body.shape == BodyShape::box)
      return body.lower_corner + .5 * (body.upper_corner - body.lower_corner);
    if (body.shape == BodyShape::file)
      return body.mesh_file.centre;
    return body.centre;
  }

  template <int dim>
  dealii::Point<dim> centre_of(const BodyDescription<dim> &body)
  {
    return body.placement.place(centre_of_shape(body));
  }

  template <int dim>
  std::vector<dealii::types::boundary_id> boundary_ids(const BodyDescription<dim> &body)
  {
    std::vector<dealii::types::boundary_id> ids;
    if (body.shape == BodyShape::file)
      {
        for (const auto &[id, vertices] : body.mesh_file.boundary_vertices)
          ids.push_back(id);
        return ids;
      }
    ids.resize(body.shape == BodyShape::box ? 2 * dim : body.shape == BodyShape::cylinder ? 3 : 1);
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
  }

  template <int dim>
  std::vector<dealii::types::boundary_id> boundary_ids_named(const BodyDescription<dim> &body,
                                                             const std::string          &word)
  {
    const auto &groups = body.mesh_file.boundaries;
    if (const auto exact = groups.find(word); exact != groups.end())
      return exact->second;
    std::set<dealii::types::boundary_id> ids;
    for (const auto &[name, ids_of_group] : groups)
      if (same_letters(name, word))
        ids.insert(ids_of_group.begin(), ids_of_group.end());
    for (const dealii::types::boundary_id id : boundary_ids(body))
      if (std::to_string(id) == word)
        ids.insert(id);
    return {ids.begin(), ids.end()};
  }

  template <int dim>
  std::string list_of_boundaries(const BodyDescription<dim> &body)
  {
    std::vector<std::string> list;
    for (const dealii::types::boundary_id id : boundary_ids(body))
      {
        std::vector<std::string> names;
        for (const auto &[name, ids] : body.mesh_file.boundaries)
          if (std::find(ids.begin(), ids.end(), id) != ids.end()
              && !consists_of(name, "0123456789"))
            names.push_back(name);
        list.push_back(std::to_string(id) + (names.empty() ? "" : " (" + join(names) + ")"));
      }
    return join(list);
  }

  namespace
  {
    template <int dim>
    std::vector<dealii::Point<dim>> points_of_box(const BodyDescription<dim>      &body,
                                                  const dealii::types::boundary_id id)
    {
      const unsigned int normal_direction = id / 2;
      const double       normal_coordinate =
        (id % 2 == 0 ? body.lower_corner : body.upper_corner)[normal_direction];
      std::vector<dealii::Point<dim>> points = {centre_of_shape(body)};
      for (unsigned int corner = 0; corner < (1u << dim); ++corner)
        {
          dealii::Point<dim> point;
          for (unsigned int d = 0; d < dim; ++d)
            point[d] = ((corner >> d) & 1u ? body.upper_corner : body.lower_corner)[d];
          points.push_back(point);
        }
      for (dealii::Point<dim> &point : points)
        {
          point[normal_direction] = normal_coordinate;
          point                   = Cap<dim>(body).bulge(point);
        }
      return points;
    }

    /**
     * Points at distance `radius` from @p centre along the coordinate directions, except the
     * direction @p axis.
     */
    template <int dim>
    std::vector<dealii::Point<dim>>
    poles(const dealii::Point<dim> &centre, const double radius, const unsigned int axis)
    {
      std::vector<dealii::Point<dim>> points;
      for (unsigned int d = 0; d < dim; ++d)
        for (const double side : {-1., 1.})
          if (d != axis)
            {
              points.push_back(centre);
              points.back()[d] += side * radius;
            }
      return points;
    }

    /** Points on the boundary of the shape before it is placed. */
    template <int dim>
    std::vector<dealii::Point<dim>> points_of_shape(const BodyDescription<dim>      &body,
                                                    const dealii::types::boundary_id id)
    {
      if (body.shape == BodyShape::box)
        return points_of_box(body, id);
      if (body.shape == BodyShape::file)
        return body.mesh_file.boundary_vertices.at(id);
      if (body.shape == BodyShape::ball)
        return poles(body.centre, body.radius, dealii::numbers::invalid_unsigned_int);
      if (id == 0)
        return poles(body.centre, body.radius, body.axis);
      dealii::Point<dim> end = body.centre;
      end[body.axis] += (id == 1 ? -.5 : .5) * body.length;
      std::vector<dealii::Point<dim>> points = poles(end, body.radius, body.axis);
      points.push_back(end);
      return points;
    }
  } // namespace

  template <int dim>
  std::vector<dealii::Point<dim>> boundary_points(const BodyDescription<dim>      &body,
                                                  const dealii::types::boundary_id id)
  {
    std::vector<dealii::Point<dim>> points = points_of_shape(body, id);
    for (dealii::Point<dim> &point : points)
      point = body.placement.place(point);
    return points;
  }

  template <int dim>
  std::vector<dealii::Point<dim>> sample_points(const BodyDescription<dim> &body)
  {
    std::vector<dealii::Point<dim>> points = {centre_of(body)};
    for (const dealii::types::boundary_id id : boundary_ids(body))
      for (const dealii::Point<dim> &point : boundary_points(body, id))
        points.push_back(point);
    return points;
  }

#define INSTANTIATE(dim)                                                                           \
  template dealii::Point<dim>                      centre_of_shape(const BodyDescription<dim> &);  \
  template dealii::Point<dim>                      centre_of(const BodyDescription<dim> &);        \
  template std::vector<dealii::types::boundary_id> boundary_ids(const BodyDescription<dim> &);     \
  template std::vector<dealii::types::boundary_id> boundary_ids_named(                             \
    const BodyDescription<dim> &, const std::string &);                                            \
  template std::string                     list_of_boundaries(const BodyDescription<dim> &);       \
  template std::vector<dealii::Point<dim>> boundary_points(const BodyDescription<dim> &,           \
                                                           dealii::types::boundary_id);            \
  template std::vector<dealii::Point<dim>> sample_points(const BodyDescription<dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
