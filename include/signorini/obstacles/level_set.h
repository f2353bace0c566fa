// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_level_set_h
#define signorini_obstacles_level_set_h

#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/prm/section_reader.h>

#include <deal.II/base/function_parser.h>

namespace signorini
{
  /**
   * Where an expression is negative. It is a signed distance near its zero, so that one division
   * corrects its slope.
   */
  template <int dim>
  class LevelSet : public RigidObstacle<dim>
  {
  public:
    /**
     * @param name       of the obstacle, for messages
     * @param expression in x, y, z; positive where the bodies may be
     */
    LevelSet(const std::string &name, const std::string &expression);

    /** @throws UserError where the expression has no gradient */
    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override;

  private:
    const std::string                                  name;
    const std::unique_ptr<dealii::FunctionParser<dim>> function;

    dealii::Tensor<1, dim> gradient(const dealii::Point<dim> &p) const;
  };

  void declare_level_set(dealii::ParameterHandler &prm);

  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_level_set(const SectionReader &in,
                                                            const std::string   &name);
} // namespace signorini

#endif
