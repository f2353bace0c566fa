// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_obstacle_motion_h
#define signorini_obstacles_obstacle_motion_h

#include <signorini/obstacles/integral_of_rate.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>

#include <array>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /**
   * Where a rigid obstacle is: what is at X in the scene is at
   *
   *   x = centre + displacement + R (X - centre).
   */
  template <int dim>
  struct ObstaclePlace
  {
    dealii::Point<dim>     centre;
    dealii::Tensor<1, dim> displacement;
    dealii::Tensor<2, dim> rotation;   ///< R, orthogonal
    double                 angle = 0.; ///< of R, with all full turns: radians

    dealii::Point<dim> back(const dealii::Point<dim> &x) const
    {
      return centre + transpose(rotation) * (x - centre - displacement);
    }
    dealii::Point<dim> forth(const dealii::Point<dim> &X) const
    {
      return centre + displacement + rotation * (X - centre);
    }
  };

  /**
   * The prescribed motion of a rigid obstacle: a displacement, and a rotation about an axis that it
   * takes along. Either may be given as it is or as its rate, from 0 at time 0.
   */
  template <int dim>
  class ObstacleMotion
  {
  public:
    /** Expressions of t, which have been checked when the scene was read. */
    struct Description
    {
      std::array<std::string, dim> displacement;     ///< lengths, or
      std::array<std::string, dim> velocity;         ///< lengths per time
      std::string                  angular_velocity; ///< radians per time, counterclockwise
      dealii::Point<dim>           centre;           ///< of the rotation, at time 0
      dealii::Tensor<1, dim>       axis;             ///< unit vector; of no meaning in 2d
      double                       panel = 0.01;     ///< see IntegralOfRate
    };

    /** @param name of the obstacle, for messages */
    ObstacleMotion(const std::string &name, const Description &description);

    /** @throws RunError if an expression is not a finite number */
    ObstaclePlace<dim> place(double time) const;

    /** At equal times between two instants, if it does not go straight on there, nor turns. */
    std::vector<ObstaclePlace<dim>> places_between(double start, double end) const;

    /** Whether it rotates. */
    bool turns() const { return rotates; }

  private:
    using Function = dealii::FunctionParser<dim>;

    const std::string                   name;
    const dealii::Point<dim>            centre;
    const dealii::Tensor<1, dim>        axis;
    const bool                          moves_by_rate, rotates;
    const std::unique_ptr<Function>     translation, angular_velocity;
    mutable std::vector<IntegralOfRate> integrals; ///< of the components, and of the rotation

    /** Between two instants. */
    static constexpr unsigned int n_parts = 8;

    /** Of the instants asked for last: a step asks for few, again and again. */
    static constexpr unsigned int                             n_recent = 4;
    mutable std::deque<std::pair<double, ObstaclePlace<dim>>> recent;

    ObstaclePlace<dim> find_place(double time) const;

    /** At equal times from one instant to another, both included: about, where a rate is given. */
    std::vector<double>
    displacements_between(double start, double end, unsigned int component) const;

    /** A component of a function of t. */
    double                 value(Function &function, double time, unsigned int component) const;
    dealii::Tensor<2, dim> rotation(double angle) const;
  };
} // namespace signorini

#endif
