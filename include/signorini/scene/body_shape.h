// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_body_shape_h
#define signorini_scene_body_shape_h

#include <signorini/scene/body_description.h>

#include <vector>

namespace signorini
{
  /**
   * The boundary ids of a shape. Box: deal.II's colours 0..2*dim-1 (0, 1: x-, x+; 2, 3: y-, y+; ...); ball: 0;
   * cylinder: 0 mantle, 1 bottom, 2 top.
   */
  template <int dim>
  std::vector<dealii::types::boundary_id> boundary_ids(const BodyDescription<dim> &body);

  /** A few points on one boundary, for trying expressions. */
  template <int dim>
  std::vector<dealii::Point<dim>> boundary_points(const BodyDescription<dim> &body, dealii::types::boundary_id id);

  /** The centre of the body and the points of all its boundaries. */
  template <int dim>
  std::vector<dealii::Point<dim>> sample_points(const BodyDescription<dim> &body);

  template <int dim>
  dealii::Point<dim> centre_of(const BodyDescription<dim> &body);
} // namespace signorini

#endif
