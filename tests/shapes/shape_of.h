// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_shapes_shape_of_h
#define signorini_tests_shapes_shape_of_h

#include <signorini/model/body_description.h>
#include <signorini/shapes/ball_shape.h>
#include <signorini/shapes/box_shape.h>
#include <signorini/shapes/cylinder_shape.h>
#include <signorini/shapes/mesh_file_shape.h>

#include <memory>

namespace signorini
{
  /**
   * The shape of a body, to be changed: its own copy, for the time up to the next call; that of a
   * body without a shape of this class begins with the defaults of the class.
   */
  template <typename Shape, int dim>
  Shape &shape_of(BodyDescription<dim> &body)
  {
    const auto *known = dynamic_cast<const Shape *>(body.shape.get());
    const auto  own   = known ? std::make_shared<Shape>(*known) : std::make_shared<Shape>();
    body.shape        = own;
    return *own;
  }

  /** The same to look at. @throws std::bad_cast if it is of another class */
  template <typename Shape, int dim>
  const Shape &shape_of(const BodyDescription<dim> &body)
  {
    return dynamic_cast<const Shape &>(*body.shape);
  }

  template <int dim>
  BoxShape<dim> &box_of(BodyDescription<dim> &body)
  {
    return shape_of<BoxShape<dim>>(body);
  }
  template <int dim>
  const BoxShape<dim> &box_of(const BodyDescription<dim> &body)
  {
    return shape_of<BoxShape<dim>>(body);
  }

  template <int dim>
  BallShape<dim> &ball_of(BodyDescription<dim> &body)
  {
    return shape_of<BallShape<dim>>(body);
  }
  template <int dim>
  const BallShape<dim> &ball_of(const BodyDescription<dim> &body)
  {
    return shape_of<BallShape<dim>>(body);
  }

  template <int dim>
  const MeshFile<dim> &mesh_of(const BodyDescription<dim> &body)
  {
    return shape_of<MeshFileShape<dim>>(body).mesh_file;
  }
} // namespace signorini

#endif
