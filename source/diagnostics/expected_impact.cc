// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/expected_impact.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr double pi = 3.14159265358979324;

    /** Of a body in contact with something as stiff or light as the other. */
    double in_series(const double a, const double b)
    {
      return 1. / (1. / a + 1. / b);
    }

    /** Duration over the time in which the flattening would be reached at constant speed. */
    constexpr double hertz_duration = 2.9432;


    template <int dim>
    ExpectedImpact
    impact_of_round_bodies(const FirstTouch &touch, const double mass, const double modulus)
    {
      const double   v = touch.speed, radius = 1. / touch.curvature;
      ExpectedImpact impact;
      double         flattening;
      if (dim == 3)
        {
          const double K  = 4. / 3. * modulus * std::sqrt(radius);
          flattening      = std::pow(5. * mass * v * v / (4. * K), 0.4);
          impact.force    = K * std::pow(flattening, 1.5);
          impact.duration = hertz_duration * flattening / v;
        }
      else
        {
          const double K  = pi / 4. * modulus;
          flattening      = v * std::sqrt(mass / K);
          impact.force    = K * flattening;
          impact.duration = pi * flattening / v;
        }
      const double contact_radius = std::sqrt(radius * flattening);
      const double in_radius      = contact_radius / touch.node_spacing;
      impact.n_nodes              = dim == 3 ? pi * in_radius * in_radius : 2. * in_radius;
      // Johnson (4.22), (4.44): the pressure in the centre over E* is 2 a/(pi R), in 2d a/(2 R).
      impact.strain = (dim == 3 ? 2. / pi : 0.5) * contact_radius / radius;
      return impact;
    }


    /** What a body resists with, per area of the touch: all of its cross-section does. */
    double Z_of(const Collider &side, const FirstTouch &touch)
    {
      const double Z = side.density * side.wave_speed;
      return std::isfinite(side.depth) ? Z * std::max(1., side.volume / side.depth / touch.area)
                                       : Z;
    }

    /** The time of a wave through a body. */
    double way_through(const Collider &side)
    {
      return side.depth / side.wave_speed;
    }


    ExpectedImpact
    impact_of_flat_faces(const FirstTouch &touch, const Collider &body, const Collider &other)
    {
      // What comes back from within a much stiffer body is small; a rigid one is the limit.
      const double Z = Z_of(body, touch), Z_other = Z_of(other, touch);
      double       way = Z_other < 2. * Z ? way_through(other) : way_through(body);
      if (Z_other < 2. * Z && Z < 2. * Z_other)
        way = std::min(way, way_through(body));
      ExpectedImpact impact;
      impact.force    = touch.area * in_series(Z, Z_other) * touch.speed;
      impact.duration = 2. * way;
      impact.n_nodes  = touch.n_at_once;
      impact.strain =
        impact.force / touch.area / (body.density * body.wave_speed * body.wave_speed);
      return impact;
    }
  } // namespace


  template <int dim>
  ExpectedImpact
  expected_impact(const FirstTouch &touch, const Collider &body, const Collider &other)
  {
    Assert(touch.is_smooth && std::isfinite(touch.time), dealii::ExcMessage("There is no theory."));
    if (touch.curvature == 0.)
      return impact_of_flat_faces(touch, body, other);
    return impact_of_round_bodies<dim>(
      touch, in_series(body.mass, other.mass), in_series(body.modulus, other.modulus));
  }


  template ExpectedImpact
  expected_impact<2>(const FirstTouch &, const Collider &, const Collider &);
  template ExpectedImpact
  expected_impact<3>(const FirstTouch &, const Collider &, const Collider &);
} // namespace signorini
