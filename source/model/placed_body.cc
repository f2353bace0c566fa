// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/model/placed_body.h>

namespace signorini
{
  template <int dim>
  dealii::Point<dim> centre_of(const BodyDescription<dim> &body)
  {
    return body.placement.place(body.shape->midpoint());
  }


  template <int dim>
  std::vector<dealii::Point<dim>> boundary_points(const BodyDescription<dim>      &body,
                                                  const dealii::types::boundary_id id)
  {
    std::vector<dealii::Point<dim>> points = body.shape->boundary_points(id);
    for (dealii::Point<dim> &point : points)
      point = body.placement.place(point);
    return points;
  }


  template <int dim>
  std::vector<dealii::Point<dim>> sample_points(const BodyDescription<dim> &body)
  {
    std::vector<dealii::Point<dim>> points = {centre_of(body)};
    for (const dealii::types::boundary_id id : body.shape->boundary_ids())
      for (const dealii::Point<dim> &point : boundary_points(body, id))
        points.push_back(point);
    return points;
  }


#define INSTANTIATE(dim)                                                                           \
  template dealii::Point<dim>              centre_of(const BodyDescription<dim> &);                \
  template std::vector<dealii::Point<dim>> boundary_points(const BodyDescription<dim> &,           \
                                                           dealii::types::boundary_id);            \
  template std::vector<dealii::Point<dim>> sample_points(const BodyDescription<dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
