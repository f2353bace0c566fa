// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/user_error.h>
#include <signorini/obstacles/obstacle_motion.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  ObstacleMotion<dim>::ObstacleMotion(const std::string &name, const Description &description)
    : name(name)
    , centre(description.centre)
    , axis(description.axis)
    , moves_by_rate(is_given(description.velocity))
    , rotates(!description.angular_velocity.empty() && description.angular_velocity != "0")
    , translation(
        make_function<dim, dim>(moves_by_rate ? description.velocity : description.displacement))
    , angular_velocity(make_function<dim, 1>({{description.angular_velocity}}))
  {
    for (unsigned int c = 0; c < dim; ++c)
      integrals.emplace_back([this, c](const double t) { return value(*translation, t, c); },
                             has_time<1>({{description.velocity[c]}}),
                             description.panel);
    integrals.emplace_back([this](const double t) { return value(*angular_velocity, t, 0); },
                           has_time<1>({{description.angular_velocity}}),
                           description.panel);
  }


  template <int dim>
  ObstaclePlace<dim> ObstacleMotion<dim>::place(const double time) const
  {
    for (const auto &[instant, place] : recent)
      if (instant == time)
        return place;
    recent.emplace_front(time, find_place(time));
    if (recent.size() > n_recent)
      recent.pop_back();
    return recent.front().second;
  }


  template <int dim>
  std::vector<ObstaclePlace<dim>> ObstacleMotion<dim>::places_between(const double start,
                                                                      const double end) const
  {
    if (rotates || start == end)
      return {};
    const Tensor<1, dim> first = place(start).displacement, last = place(end).displacement;
    const double         round_off = 1e-12 * (first.norm() + last.norm());
    std::vector<ObstaclePlace<dim>> result(n_parts - 1, place(start));
    for (unsigned int c = 0; c < dim; ++c)
      {
        const std::vector<double> way = displacements_between(start, end, c);
        for (unsigned int k = 1; k < n_parts; ++k)
          result[k - 1].displacement[c] = way[k];
      }
    bool is_straight = true;
    for (unsigned int k = 1; k < n_parts; ++k)
      {
        const double         part     = double(k) / n_parts;
        const Tensor<1, dim> straight = (1. - part) * first + part * last;
        is_straight = is_straight && (result[k - 1].displacement - straight).norm() <= round_off;
      }
    if (is_straight)
      result.clear();
    return result;
  }


  template <int dim>
  std::vector<double> ObstacleMotion<dim>::displacements_between(const double       start,
                                                                 const double       end,
                                                                 const unsigned int component) const
  {
    std::vector<double> result;
    if (!moves_by_rate)
      {
        for (unsigned int k = 0; k <= n_parts; ++k)
          result.push_back(
            value(*translation, start + double(k) / n_parts * (end - start), component));
        return result;
      }
    result.assign(1, place(start).displacement[component]);
    for (const double part : integrals[component].over_parts(start, end, n_parts))
      result.push_back(result.back() + part);
    return result;
  }


  template <int dim>
  ObstaclePlace<dim> ObstacleMotion<dim>::find_place(const double time) const
  {
    ObstaclePlace<dim> result{centre, {}, rotation(0.), 0.};
    for (unsigned int c = 0; c < dim; ++c)
      result.displacement[c] = moves_by_rate ? integrals[c](time) : value(*translation, time, c);
    if (rotates)
      {
        result.angle    = integrals[dim](time);
        result.rotation = rotation(result.angle);
      }
    return result;
  }


  template <int dim>
  double ObstacleMotion<dim>::value(Function          &function,
                                    const double       time,
                                    const unsigned int component) const
  {
    function.set_time(time);
    const double result = function.value(Point<dim>(), component);
    if (!std::isfinite(result))
      {
        std::ostringstream message;
        message << "The motion of the obstacle '" << name << "' is not a finite number at time "
                << time << ". Check `Motion`, `Velocity` and `Angular velocity` in Obstacles/"
                << name << ".";
        throw RunError(message.str());
      }
    return result;
  }


  template <int dim>
  Tensor<2, dim> ObstacleMotion<dim>::rotation(const double angle) const
  {
    const double   c = std::cos(angle), s = std::sin(angle);
    Tensor<2, dim> result;
    if constexpr (dim == 2)
      {
        result[0][0] = result[1][1] = c;
        result[1][0]                = s;
        result[0][1]                = -s;
      }
    else
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const unsigned int k    = 3 - i - j; // the third one, if i and j differ
            const double       turn = i == j ? 0. : ((j + 1) % 3 == i ? axis[k] : -axis[k]);
            result[i][j]            = (i == j ? c : 0.) + (1. - c) * axis[i] * axis[j] + s * turn;
          }
    return result;
  }


  template struct ObstaclePlace<2>;
  template struct ObstaclePlace<3>;
  template class ObstacleMotion<2>;
  template class ObstacleMotion<3>;
} // namespace signorini
