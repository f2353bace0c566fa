// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/user_error.h>
#include <signorini/obstacles/level_set.h>
#include <signorini/prm/check_expressions.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  LevelSet<dim>::LevelSet(const std::string &name, const std::string &expression)
    : name(name)
    , function(make_function<dim, 1>({{expression}}))
  {
    function->set_formula(AutoDerivativeFunction<dim>::FourthOrder);
  }


  template <int dim>
  ObstacleProjection<dim> LevelSet<dim>::project(const Point<dim> &p) const
  {
    const Tensor<1, dim> gradient = this->gradient(p);
    const double         slope    = gradient.norm();
    if (!(slope > 1e-8))
      throw UserError("Obstacles/" + name
                      + "/Signed distance does not change near a contact node (its gradient "
                        "vanishes), so it has no normal there. Give a distance function whose "
                        "gradient has length 1.");
    return {function->value(p) / slope, -gradient / slope};
  }


  template <int dim>
  Tensor<1, dim> LevelSet<dim>::gradient(const Point<dim> &p) const
  {
    // Differences of order h^4. Steps are right if the next smaller ones agree: longer ones suffer
    // from the features of the surface, shorter ones from cancellation, which depends on how far
    // away the origin is.
    double step = 1e-2 * std::max(1e-3, p.norm()), best = std::numeric_limits<double>::max();
    Tensor<1, dim> result, last;
    for (unsigned int k = 0; k < 6; ++k, step /= 10.)
      {
        function->set_h(step);
        const Tensor<1, dim> next = function->gradient(p);
        if (k > 0 && (next - last).norm() < best)
          {
            best   = (next - last).norm();
            result = next;
          }
        last = next;
      }
    return result;
  }


  void declare_level_set(ParameterHandler &prm)
  {
    prm.declare_entry("Signed distance",
                      "",
                      Patterns::Anything(),
                      "Function: expression in x, y, z (length), positive where the bodies may be, "
                      "near its zero set the distance to it. Example, a bowl: z - 0.1*(x^2 + y^2)");
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
    return std::make_shared<LevelSet<dim>>(name, expression);
  }


#define INSTANTIATE(dim)                                                                           \
  template class LevelSet<dim>;                                                                    \
  template std::shared_ptr<const RigidObstacle<dim>> parse_level_set(const SectionReader &,        \
                                                                     const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
