// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_placed_body_h
#define signorini_model_placed_body_h

#include <signorini/model/body_description.h>

#include <vector>

namespace signorini
{
  /** The centre of the body in its place. */
  template <int dim>
  dealii::Point<dim> centre_of(const BodyDescription<dim> &body);

  /** A few points on one boundary of the body in its place, for trying expressions. */
  template <int dim>
  std::vector<dealii::Point<dim>> boundary_points(const BodyDescription<dim> &body,
                                                  dealii::types::boundary_id  id);

  /** The centre of the body in its place and the points of all its boundaries. */
  template <int dim>
  std::vector<dealii::Point<dim>> sample_points(const BodyDescription<dim> &body);
} // namespace signorini

#endif
