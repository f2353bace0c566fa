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


    /** With the half-width of contact that belongs to the largest force, and its largest strain. */
    ExpectedImpact with_contact_of(const FirstTouch &touch,
                                   const double      force,
                                   const double      duration,
                                   const double      half_width,
                                   const bool        in_space)
    {
      ExpectedImpact impact;
      impact.force           = force;
      impact.duration        = duration;
      const double in_radius = half_width / touch.node_spacing;
      impact.n_nodes         = in_space ? pi * in_radius * in_radius : 2. * in_radius;
      // Johnson (4.22), (4.44): the pressure in the centre over E* is 2 a/(pi R), in 2d a/(2 R).
      impact.strain = (in_space ? 2. / pi : 0.5) * half_width * touch.curvature;
      return impact;
    }


    ExpectedImpact impact_of_balls(const FirstTouch &touch, const double mass, const double modulus)
    {
      const double v = touch.speed, radius = 1. / touch.curvature;
      const double K          = 4. / 3. * modulus * std::sqrt(radius);
      const double flattening = std::pow(5. * mass * v * v / (4. * K), 0.4);
      return with_contact_of(touch,
                             K * std::pow(flattening, 1.5),
                             hertz_duration * flattening / v,
                             std::sqrt(radius * flattening),
                             true);
    }


    /**
     * 2 ln(2 d/a) - 1 of both sides, weighted with what each of them gives way: pi E* times the
     * flattening over the force.
     */
    double logarithm_of(const Collider &body, const Collider &other, const double half_width)
    {
      const double modulus = in_series(body.modulus, other.modulus);
      double       sum     = 0.;
      for (const Collider *side : {&body, &other})
        if (std::isfinite(side->modulus))
          sum += modulus / side->modulus * (2. * std::log(2. * side->depth / half_width) - 1.);
      return sum;
    }


    /** The force F for which the work F^2 (L - 1/2) / (2 pi E*) is the energy of the approach. */
    ExpectedImpact
    impact_of_cylinders(const FirstTouch &touch, const Collider &body, const Collider &other)
    {
      const double mass       = in_series(body.mass, other.mass);
      const double stiffness  = pi * in_series(body.modulus, other.modulus);
      double       resistance = 4., force = 0., half_width = 0.; // L - 1/2 where a = R/4
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          force      = touch.speed * std::sqrt(mass * stiffness / resistance);
          half_width = std::sqrt(4. * force / (touch.curvature * stiffness));
          // Where contact is as wide as the bodies no law is left; they are no stiffer than that.
          resistance = std::max(1., logarithm_of(body, other, half_width) - 0.5);
        }
      return with_contact_of(touch, force, pi * mass * touch.speed / force, half_width, false);
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
    if (dim == 2)
      return impact_of_cylinders(touch, body, other);
    return impact_of_balls(
      touch, in_series(body.mass, other.mass), in_series(body.modulus, other.modulus));
  }


  template ExpectedImpact
  expected_impact<2>(const FirstTouch &, const Collider &, const Collider &);
  template ExpectedImpact
  expected_impact<3>(const FirstTouch &, const Collider &, const Collider &);
} // namespace signorini
