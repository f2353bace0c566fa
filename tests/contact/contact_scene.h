// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_contact_contact_scene_h
#define signorini_tests_contact_contact_scene_h

#include "../discretization/bodies.h"

#include <signorini/contact/contact_surface.h>
#include <signorini/obstacles/plane.h>
#include <signorini/obstacles/round_obstacle.h>

namespace signorini::tests
{
  template <int dim>
  NamedObstacle<dim> plane(const std::string            &name,
                           const dealii::Point<dim>     &point,
                           const dealii::Tensor<1, dim> &normal)
  {
    return {name, std::make_shared<Plane<dim>>(point, normal)};
  }

  /** Upper side at a height of the last coordinate. */
  template <int dim>
  NamedObstacle<dim> floor_at(const double height)
  {
    dealii::Point<dim>     point;
    dealii::Tensor<1, dim> up;
    point[dim - 1] = height;
    up[dim - 1]    = 1.;
    return plane<dim>("floor", point, up);
  }

  template <int dim>
  NamedObstacle<dim>
  sphere(const dealii::Point<dim> &centre, const double radius, const bool bodies_inside = false)
  {
    const dealii::Tensor<1, dim> no_axis;
    return {"sphere", std::make_shared<RoundObstacle<dim>>(centre, no_axis, radius, bodies_inside)};
  }

  /** The first body against each obstacle, with the given boundary ids (none: all). */
  template <int dim>
  Scene<dim> contact_scene(const BodyDescription<dim>                    &body,
                           const std::vector<NamedObstacle<dim>>         &obstacles,
                           const std::vector<dealii::types::boundary_id> &ids = {})
  {
    Scene<dim> scene = scene_of<dim>({body});
    scene.obstacles  = obstacles;
    for (unsigned int o = 0; o < obstacles.size(); ++o)
      {
        PairDescription pair;
        pair.name               = body.name + " : " + obstacles[o].name;
        pair.slave              = 0;
        pair.slave_boundary_ids = ids;
        pair.obstacle           = o;
        scene.pairs.push_back(pair);
      }
    return scene;
  }

  /** Everything up to the contact surface. */
  template <int dim>
  struct ContactProblem : public Assembled<dim>
  {
    explicit ContactProblem(const Scene<dim> &scene)
      : Assembled<dim>(scene)
      , dirichlet(this->discretization)
      , surface(this->discretization, dirichlet, scene.obstacles, scene.pairs)
    {
    }

    double area() const
    {
      double sum = 0.;
      for (const ContactNode<dim> &node : surface.nodes())
        sum += node.weight;
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }

    const DirichletConditions<dim> dirichlet;
    const ContactSurface<dim>      surface;
  };
} // namespace signorini::tests

#endif
