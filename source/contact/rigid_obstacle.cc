// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/user_error.h>
#include <signorini/contact/rigid_obstacle.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class Plane : public RigidObstacle<dim>
    {
    public:
      explicit Plane(const ObstacleDescription<dim> &description)
        : point(description.point)
        , normal(description.normal / description.normal.norm())
      {
      }

      ObstacleProjection<dim> project(const Point<dim> &p) const override
      {
        return {(p - point) * normal, -normal};
      }

    private:
      const Point<dim>     point;
      const Tensor<1, dim> normal;
    };


    /** Sphere, circle (2d), and cylinder, which is the sphere of the plane across its axis. */
    template <int dim>
    class Round : public RigidObstacle<dim>
    {
    public:
      Round(const Point<dim>     &centre,
            const Tensor<1, dim> &axis,
            const double          radius,
            const bool            bodies_inside)
        : centre(centre)
        , axis(axis.norm() > 0. ? axis / axis.norm() : axis)
        , radius(radius)
        , sign(bodies_inside ? -1. : 1.)
      {
      }

      ObstacleProjection<dim> project(const Point<dim> &p) const override
      {
        Tensor<1, dim> away = p - centre;
        away -= (away * axis) * axis;
        const double distance = away.norm();
        if (distance == 0.) // the centre: every direction is right
          {
            Tensor<1, dim> any;
            any[dim - 1] = 1.;
            any -= (any * axis) * axis;
            if (any.norm() < 0.5)
              {
                any    = Tensor<1, dim>();
                any[0] = 1.;
              }
            return {-sign * radius, any / any.norm()};
          }
        return {sign * (distance - radius), -sign / distance * away};
      }

    private:
      const Point<dim>     centre;
      const Tensor<1, dim> axis;
      const double         radius;
      const double         sign;
    };


    /**
     * Level set of an expression that is a signed distance near its zero, so that one division
     * corrects its slope.
     */
    template <int dim>
    class LevelSet : public RigidObstacle<dim>
    {
    public:
      explicit LevelSet(const ObstacleDescription<dim> &description)
        : name(description.name)
        , function(make_function<dim, 1>({{description.signed_distance}}))
      {
        function->set_formula(AutoDerivativeFunction<dim>::FourthOrder);
      }

      ObstacleProjection<dim> project(const Point<dim> &p) const override
      {
        // Truncation, of order h^4, and cancellation are both below 1e-11 of the slope unless the
        // surface has features much smaller than its distance from the origin.
        function->set_h(1e-4 * std::max(1e-3, p.norm()));
        const Tensor<1, dim> gradient = function->gradient(p);
        const double         slope    = gradient.norm();
        if (!(slope > 1e-8))
          throw UserError("Obstacles/" + name
                          + "/Signed distance does not change near a contact node (its gradient "
                            "vanishes), so it has no normal there. Give a distance function whose "
                            "gradient has length 1.");
        return {function->value(p) / slope, -gradient / slope};
      }

    private:
      const std::string                          name;
      const std::unique_ptr<FunctionParser<dim>> function;
    };
  } // namespace


  template <int dim>
  std::unique_ptr<RigidObstacle<dim>> make_obstacle(const ObstacleDescription<dim> &description)
  {
    if (description.shape == ObstacleShape::plane)
      return std::make_unique<Plane<dim>>(description);
    if (description.shape == ObstacleShape::sphere)
      return std::make_unique<Round<dim>>(
        description.centre, Tensor<1, dim>(), description.radius, description.bodies_inside);
    if (description.shape == ObstacleShape::cylinder)
      return std::make_unique<Round<dim>>(
        description.point, description.axis, description.radius, description.bodies_inside);
    return std::make_unique<LevelSet<dim>>(description);
  }


  template std::unique_ptr<RigidObstacle<2>> make_obstacle(const ObstacleDescription<2> &);
  template std::unique_ptr<RigidObstacle<3>> make_obstacle(const ObstacleDescription<3> &);
} // namespace signorini
