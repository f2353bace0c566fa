// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_multigrid_level_problems_h
#define signorini_tests_multigrid_level_problems_h

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/multigrid/level_hierarchy.h>

namespace signorini::tests
{
  /** Everything that multigrid needs, for a body above a floor or for two bodies. */
  template <int dim>
  struct LevelProblem : public Assembled<dim>
  {
    explicit LevelProblem(const Scene<dim> &scene)
      : Assembled<dim>(scene)
      , dirichlet(this->discretization)
      , surface(this->discretization, dirichlet, scene.obstacles, scene.pairs)
      , coordinates(this->discretization, surface, dirichlet)
      , shared_hierarchy(std::make_shared<const LevelHierarchy<dim>>(this->discretization,
                                                                     coordinates.clamped_nodes()))
      , hierarchy(*shared_hierarchy)
    {
    }

    const ElasticMatrices<dim> &matrices() const { return this->discretization.matrices(); }

    /** Contact within a distance of the other side, sticking or not, and what is prescribed. */
    Mask mask(const double reach, const bool sticking = false) const
    {
      Mask result(dim * matrices().pattern.n_owned, 0);
      for (const unsigned int entry : coordinates.dirichlet_entries())
        result[entry] = 1;
      for (const ContactNode<dim> &node : surface.nodes())
        if (node.gap <= reach)
          for (unsigned int c = 0; c < (sticking ? dim : 1); ++c)
            result[dim * node.node + c] = 1;
      return result;
    }

    /** M + s A of a step with a Courant number. */
    MatrixSum step(const double courant_number) const
    {
      const double tau = courant_number / this->mesh.courant_number(1.);
      return {1., 0.25 * tau * tau};
    }

    const DirichletConditions<dim>                   dirichlet;
    const ContactSurface<dim>                        surface;
    const ContactCoordinates<dim>                    coordinates;
    const std::shared_ptr<const LevelHierarchy<dim>> shared_hierarchy;
    const LevelHierarchy<dim>                       &hierarchy;
  };

  /** The unit ball above a floor that it touches. */
  template <int dim>
  Scene<dim> ball_on_floor(const unsigned int refinements)
  {
    return contact_scene<dim>(ball<dim>(refinements), {floor_at<dim>(0.)});
  }

  /** A box with cells of three sizes, held at x = 0, on a floor. */
  template <int dim>
  Scene<dim> adaptive_box_on_floor()
  {
    BodyDescription<dim>         body = box_with_hanging_nodes<dim>();
    std::array<std::string, dim> held;
    held.fill("0");
    body.dirichlet = {{0, held}};
    return contact_scene<dim>(body, {floor_at<dim>(0.)}, {bottom_id<dim>});
  }

  /** Blocks with meshes that do not match, with friction; the lower one of another stiffness. */
  template <int dim>
  Scene<dim> blocks_on_each_other(const unsigned int refinements, const double stiffness_ratio)
  {
    dealii::Point<dim>            low, high;
    std::array<unsigned int, dim> two, three;
    two.fill(2);
    three.fill(3);
    for (unsigned int d = 0; d < dim; ++d)
      high[d] = 1.;
    BodyDescription<dim> upper = block<dim>("upper", low, high, two);
    low[dim - 1]               = -1.;
    high[dim - 1]              = 0.;
    BodyDescription<dim> lower = block<dim>("lower", low, high, three);
    upper.refinements = lower.refinements = refinements;
    lower.material.youngs_modulus *= stiffness_ratio;
    Scene<dim> scene        = stacked<dim>(upper, lower);
    scene.pairs[0].friction = {FrictionKind::coulomb, "0.3", "", true};
    return scene;
  }

  /** A stiff ball on a soft block: what carries it are few nodes of the block. */
  template <int dim>
  Scene<dim> ball_on_soft_block(const double stiffness_ratio)
  {
    dealii::Point<dim>            low, high;
    std::array<unsigned int, dim> cells;
    cells.fill(8);
    for (unsigned int d = 0; d < dim; ++d)
      {
        low[d]  = -2.;
        high[d] = d == dim - 1 ? 0. : 2.;
      }
    BodyDescription<dim> upper = ball<dim>(3), lower = block<dim>("lower", low, high, cells);
    upper.name        = "upper";
    lower.refinements = 2;
    lower.material.youngs_modulus /= stiffness_ratio;
    Scene<dim> scene                  = stacked<dim>(upper, lower);
    scene.pairs[0].slave_boundary_ids = {};
    return scene;
  }

  /** A cantilever of one mesh without coarser cells. */
  template <int dim>
  Scene<dim> unrefined_cantilever(const unsigned int length)
  {
    dealii::Point<dim>            low, high;
    std::array<unsigned int, dim> cells;
    cells.fill(6);
    cells[0] = 6 * length;
    for (unsigned int d = 0; d < dim; ++d)
      high[d] = 1.;
    high[0]                           = length;
    BodyDescription<dim>         body = block<dim>("beam", low, high, cells);
    std::array<std::string, dim> held;
    held.fill("0");
    body.dirichlet = {{0, held}};
    return contact_scene<dim>(body, {floor_at<dim>(0.)}, {bottom_id<dim>});
  }
} // namespace signorini::tests

#endif
