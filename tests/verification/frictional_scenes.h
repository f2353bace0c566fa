// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_verification_frictional_scenes_h
#define signorini_tests_verification_frictional_scenes_h

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

namespace signorini::tests
{
  inline FrictionDescription coulomb(const std::string &coefficient, const std::string &cap = "")
  {
    return {FrictionKind::coulomb, coefficient, cap, true};
  }

  inline FrictionDescription tresca(const std::string &bound)
  {
    return {FrictionKind::tresca, "0", bound, true};
  }

  /** Some nodes stick and others slip with this friction and velocity of the first body. */
  template <int dim>
  dealii::Tensor<1, dim> oblique_velocity()
  {
    dealii::Tensor<1, dim> v;
    v[0] = 0.4;
    v[dim - 2] += 0.25;
    v[dim - 1] = -2.;
    return v;
  }

  /**
   * With this element and these steps no node is so close to the edge between two statuses that
   * round-off decides; other ones may need other steps.
   */
  template <int dim>
  void set_step(Scene<dim> &scene, const double step_size, const FrictionDescription &friction)
  {
    for (BodyDescription<dim> &body : scene.bodies)
      body.element = ElementKind::standard;
    scene.time.step_size    = step_size;
    scene.solver.tolerance  = 1e-13;
    scene.pairs[0].friction = friction;
  }

  /** A block a little above a floor; in 3d with hanging nodes, also in its lower face. */
  template <int dim>
  Scene<dim> block_on_floor(const FrictionDescription &friction)
  {
    auto body = block<dim>("block", {}, {}, {});
    for (unsigned int c = 0; c < dim; ++c)
      {
        box_of(body).lower_corner[c] = c == dim - 1 ? 0.004 : 0.;
        box_of(body).upper_corner[c] = c == 0 ? 1.4 : 1.;
        box_of(body).repetitions[c]  = dim == 2 ? 4 : 2;
      }
    if (dim == 3)
      {
        body.local_refinements = 1;
        body.refine_where      = "0.7 - x - 0.4*y";
      }
    Scene<dim> scene = contact_scene<dim>(body, {floor_at<dim>(0.)}, {bottom_id<dim>});
    set_step(scene, dim == 2 ? 0.004 : 0.006, friction);
    return scene;
  }

  /** Off-centre in every direction; in 3d with hanging nodes. */
  template <int dim>
  Scene<dim> block_on_block(const FrictionDescription &friction)
  {
    BodyDescription<dim> slave, master;
    if constexpr (dim == 2)
      {
        slave  = block<2>("slave", {0.45, 0.004}, {1.65, 1.}, {{5, 4}});
        master = block<2>("master", {-0.2, -1.}, {std::sqrt(2.) - 0.23, 0.}, {{7, 5}});
      }
    else
      {
        slave  = block<3>("slave", {0.4, 0.3, 0.004}, {1.6, 1.3, 1.}, {{2, 2, 2}});
        master = block<3>("master", {-0.2, -0.1, -1.}, {std::sqrt(2.) - 0.2, 1., 0.}, {{3, 4, 2}});
        slave.local_refinements = master.local_refinements = 1;
        slave.refine_where = master.refine_where = "x + 0.5*y - 1.1";
      }
    Scene<dim> scene = stacked<dim>(slave, master);
    set_step(scene, dim == 2 ? 0.004 : 0.006, friction);
    return scene;
  }

  /** Another obstacle, turned about the origin. */
  template <int dim>
  class TurnedObstacle : public RigidObstacle<dim>
  {
  public:
    TurnedObstacle(const std::shared_ptr<const RigidObstacle<dim>> &shape, const double angle)
      : shape(shape)
      , matrix(rotation<dim>(angle))
    {
    }

    ObstacleProjection<dim> project(const dealii::Point<dim> &point) const override
    {
      const auto turned_back =
        shape->project(dealii::Point<dim>(transpose(matrix) * dealii::Tensor<1, dim>(point)));
      return {turned_back.gap, matrix * turned_back.normal};
    }

  private:
    const std::shared_ptr<const RigidObstacle<dim>> shape;
    const dealii::Tensor<2, dim>                    matrix;
  };

  /** Turn a scene as turn<dim>(angle) turns its mesh. */
  template <int dim>
  Scene<dim> turned(Scene<dim> scene, const double angle)
  {
    for (auto &obstacle : scene.obstacles)
      obstacle.shape = std::make_shared<TurnedObstacle<dim>>(obstacle.shape, angle);
    return scene;
  }
} // namespace signorini::tests

#endif
