// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_level_set_h
#define signorini_obstacles_level_set_h

#include <signorini/base/differentiable_expression.h>
#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/prm/section_reader.h>

namespace signorini
{
  /**
   * Where an expression is negative. It is a signed distance near its zero, so that one division
   * corrects its slope: exact on the surface, of second order in the distance beside it. Any
   * factor, any unit of length and any place of the origin give the same, up to the round-off of
   * the value.
   */
  template <int dim>
  class LevelSet : public RigidObstacle<dim>
  {
  public:
    /**
     * @param name       of the obstacle, for messages
     * @param expression in x, y, z; positive where the bodies may be
     * @throws UserError saying what in the expression has no derivative
     */
    LevelSet(const std::string &name, const std::string &expression);

    /** @throws UserError where the expression has no value or no direction in which it grows */
    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override;

    std::optional<ObstacleProjection<dim>> try_project(const dealii::Point<dim> &p) const override;

  private:
    const std::string                   name;
    const DifferentiableExpression<dim> expression;

    [[noreturn]] void refuse(const dealii::Point<dim> &p) const;
  };

  void declare_level_set(dealii::ParameterHandler &prm);

  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_level_set(const SectionReader &in,
                                                            const std::string   &name);
} // namespace signorini

#endif
