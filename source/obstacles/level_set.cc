// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/obstacles/level_set.h>
#include <signorini/prm/check_expressions.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  LevelSet<dim>::LevelSet(const std::string &name, const std::string &expression)
    : name(name)
    , expression(expression)
  {
  }


  template <int dim>
  std::optional<ObstacleProjection<dim>> LevelSet<dim>::try_project(const Point<dim> &p) const
  {
    const DualNumber<dim> distance = expression(p);
    const double          slope    = distance.gradient.norm();
    if (!std::isfinite(distance.value) || !std::isfinite(slope) || !(slope > 0.))
      return {};
    return ObstacleProjection<dim>{distance.value / slope, -distance.gradient / slope};
  }


  template <int dim>
  ObstacleProjection<dim> LevelSet<dim>::project(const Point<dim> &p) const
  {
    const auto projection = try_project(p);
    if (!projection)
      refuse(p);
    return *projection;
  }


  template <int dim>
  void LevelSet<dim>::refuse(const Point<dim> &p) const
  {
    const DualNumber<dim> distance = expression(p);
    std::ostringstream    message;
    message << "Obstacles/" << name << "/Signed distance ";
    if (!std::isfinite(distance.value))
      message << "is not a finite number";
    else if (!std::isfinite(distance.gradient.norm()))
      message << "has no gradient, and so no normal,";
    else
      message << "does not change (its gradient vanishes), so it has no normal";
    message << " at (" << p
            << "), where a contact node is. Give a distance function whose gradient has length 1, "
               "or another one at such points with if(condition, a, b).";
    throw UserError(message.str());
  }


  void declare_level_set(ParameterHandler &prm)
  {
    prm.declare_entry("Signed distance",
                      "",
                      Patterns::Anything(),
                      "Function: expression in x, y, z (length), positive where the bodies may be, "
                      "near its zero set the distance to it, with all functions that have a "
                      "derivative. Example, a bowl: z - 0.1*(x^2 + y^2)");
  }


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_level_set(const SectionReader &in,
                                                            const std::string   &name)
  {
    const std::string key = "Signed distance", expression = in.text(key);
    if (expression.empty())
      in.fail(key,
              "an obstacle of shape `function` needs this expression. Give one, for example z - "
              "0.1*x^2.");
    check_expression<dim>(in, key, expression, {}, "");
    try
      {
        return std::make_shared<LevelSet<dim>>(name, expression);
      }
    catch (const UserError &error)
      {
        in.fail(key,
                std::string(error.what())
                  + ", and the normal of the obstacle is one. Write it with other functions.");
      }
  }


#define INSTANTIATE(dim)                                                                           \
  template class LevelSet<dim>;                                                                    \
  template std::shared_ptr<const RigidObstacle<dim>> parse_level_set(const SectionReader &,        \
                                                                     const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
