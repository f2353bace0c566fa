// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_body_shape_h
#define signorini_model_body_shape_h

#include <signorini/model/body_description.h>

#include <vector>

namespace signorini
{
  /**
   * The boundary ids of a shape. Box: deal.II's colours 0..2*dim-1 (0, 1: x-, x+; 2, 3: y-, y+;
   * ...); ball: 0; cylinder: 0 mantle, 1 bottom, 2 top; file: those of the file.
   */
  template <int dim>
  std::vector<dealii::types::boundary_id> boundary_ids(const BodyDescription<dim> &body);

  /**
   * The boundary ids that a scene means by a number, or by the name of a group of faces in a mesh
   * file, whatever its capital letters and blanks; empty if there are none.
   */
  template <int dim>
  std::vector<dealii::types::boundary_id> boundary_ids_named(const BodyDescription<dim> &body,
                                                             const std::string          &word);

  /** All boundary ids, with names behind them, for messages: `1 (face), 2`. */
  template <int dim>
  std::string list_of_boundaries(const BodyDescription<dim> &body);

  /** A few points on one boundary of the body in its place, for trying expressions. */
  template <int dim>
  std::vector<dealii::Point<dim>> boundary_points(const BodyDescription<dim> &body,
                                                  dealii::types::boundary_id  id);

  /** The centre of the body in its place and the points of all its boundaries. */
  template <int dim>
  std::vector<dealii::Point<dim>> sample_points(const BodyDescription<dim> &body);

  /**
   * The centre of the shape before it is placed; that of a mesh from a file is the centre of its
   * bounding box.
   */
  template <int dim>
  dealii::Point<dim> centre_of_shape(const BodyDescription<dim> &body);

  /** The centre of the body in its place. */
  template <int dim>
  dealii::Point<dim> centre_of(const BodyDescription<dim> &body);
} // namespace signorini

#endif
