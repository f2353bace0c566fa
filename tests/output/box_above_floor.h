// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_output_box_above_floor_h
#define signorini_tests_output_box_above_floor_h

#include "../shapes/shape_of.h"

#include <signorini/contact/contact_surface.h>
#include <signorini/obstacles/plane.h>
#include <signorini/scene/scene.h>

/**
 * The unit box (square) with hanging nodes, 0.1 above a floor, and its bottom as contact surface.
 * Small enough that in 3d some process may own no face of the bottom.
 */
template <int dim>
signorini::Scene<dim> box_above_floor()
{
  signorini::Scene<dim>           scene;
  signorini::BodyDescription<dim> box;
  box.name                    = "box";
  box.shape                   = std::make_shared<signorini::BoxShape<dim>>();
  box.refinements             = 1;
  box.local_refinements       = 1;
  box.refine_where            = "0.5 - x";
  box.material.youngs_modulus = 7.;
  box.material.poissons_ratio = 0.2;
  scene.bodies.push_back(box);

  dealii::Point<dim>     point;
  dealii::Tensor<1, dim> up;
  point[dim - 1] = -0.1;
  up[dim - 1]    = 1.;
  scene.obstacles.push_back({"floor", std::make_shared<signorini::Plane<dim>>(point, up)});
  signorini::PairDescription pair;
  pair.name               = "box[bottom] : floor";
  pair.slave              = 0;
  pair.slave_boundary_ids = {2 * dim - 2};
  pair.obstacle           = 0;
  scene.pairs.push_back(pair);
  scene.time.step_size = 0.1;
  scene.time.end_time  = 1.;
  return scene;
}

template <int dim>
struct BoxAboveFloor
{
  explicit BoxAboveFloor(const bool friction = false)
    : scene(with_friction(box_above_floor<dim>(), friction))
    , mesh(scene.bodies, MPI_COMM_WORLD)
    , discretization(mesh)
  {
    dirichlet = std::make_unique<signorini::DirichletConditions<dim>>(discretization);
    surface   = std::make_unique<signorini::ContactSurface<dim>>(
      discretization, *dirichlet, scene.obstacles, scene.pairs);
  }

  static signorini::Scene<dim> with_friction(signorini::Scene<dim> scene, const bool friction)
  {
    scene.pairs[0].friction.any = friction;
    return scene;
  }

  signorini::Scene<dim>                                scene;
  signorini::Mesh<dim>                                 mesh;
  signorini::Discretization<dim>                       discretization;
  std::unique_ptr<signorini::DirichletConditions<dim>> dirichlet;
  std::unique_ptr<signorini::ContactSurface<dim>>      surface;
};

#endif
