// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_contact_stacked_blocks_h
#define signorini_tests_contact_stacked_blocks_h

#include "two_bodies.h"

#include <cmath>

namespace signorini::tests
{
  // Two stacked blocks of different materials under a uniform pressure; the exact solution is
  // linear in each.

  constexpr double pressure = 5., lower_height = 0.7, height = 1.6;

  /** Two blocks of the same footprint. */
  template <int dim>
  struct Stack
  {
    BodyDescription<dim> lower, upper;
    bool                 lower_is_slave = false;
    double               side           = 1.; ///< of the footprint
    bool                 is_distorted   = false;

    /** Cells of many shapes; the outside of the blocks and their common face stay what they are. */
    Map<dim> map() const
    {
      if (!is_distorted)
        return {};
      return [side = side](const dealii::Point<dim> &p) {
        const double pi   = dealii::numbers::PI;
        double       bump = 0.02;
        for (unsigned int d = 0; d < dim - 1; ++d)
          bump *= 1. + std::sin(2.3 * p[d] + d);
        dealii::Point<dim> result = p;
        for (unsigned int d = 0; d < dim - 1; ++d)
          result[d] += bump * (1. + p[dim - 1]) * std::sin(pi * p[d] / side);
        result[dim - 1] += bump * std::sin(pi * p[dim - 1] / lower_height) * (height - p[dim - 1]);
        return result;
      };
    }

    /**
     * Rollers at the bottom; at rest also rollers in the planes where all lateral displacements
     * are zero.
     */
    Scene<dim> scene(const bool at_rest) const
    {
      BodyDescription<dim>         low = lower, high = upper;
      std::array<std::string, dim> vertical, load;
      vertical.fill("-");
      load.fill("0");
      vertical[dim - 1] = "0";
      load[dim - 1]     = std::to_string(-pressure);
      low.dirichlet.push_back({bottom_id<dim>, vertical});
      high.traction.push_back({top_id<dim>, load});
      for (unsigned int d = 0; at_rest && d < dim - 1; ++d)
        {
          std::array<std::string, dim> lateral;
          lateral.fill("-");
          lateral[d] = "0";
          low.dirichlet.push_back({2 * d, lateral});
          high.dirichlet.push_back({2 * d, lateral});
        }
      if (!lower_is_slave)
        return stacked<dim>(high, low);
      Scene<dim> scene                   = stacked<dim>(low, high);
      scene.pairs[0].slave_boundary_ids  = {top_id<dim>};
      scene.pairs[0].master_boundary_ids = {bottom_id<dim>};
      return scene;
    }

    /** The exact displacement; the lower block ends at lower_height. */
    Vector exact(const TwoBodies<dim> &bodies) const
    {
      const auto is_low = bodies.nodes_of_body(lower_is_slave ? 0 : 1);
      Vector     u      = bodies.discretization.make_vector();
      for (unsigned int node = 0; node < bodies.discretization.matrices().pattern.n_owned; ++node)
        {
          if (bodies.discretization.matrices().pattern.is_empty(node))
            continue;
          const Material           &material = (is_low[node] ? lower : upper).material;
          const double              nu       = material.poissons_ratio;
          const dealii::Point<dim> &p        = bodies.discretization.node_positions()[node];
          const double              lateral =
            (dim == 3 ? nu : nu * (1. + nu)) * pressure / material.youngs_modulus;
          for (unsigned int d = 0; d < dim - 1; ++d)
            u.local_element(dim * node + d) = lateral * p[d];
          u.local_element(dim * node + dim - 1) =
            is_low[node]
              ? -strain(lower) * p[dim - 1]
              : -strain(lower) * lower_height - strain(upper) * (p[dim - 1] - lower_height);
        }
      return u;
    }

    static double strain(const BodyDescription<dim> &body)
    {
      const double nu = body.material.poissons_ratio;
      return (dim == 3 ? 1. : 1. - nu * nu) * pressure / body.material.youngs_modulus;
    }
  };

  template <int dim>
  Stack<dim> stack(const std::array<unsigned int, dim> &lower,
                   const std::array<unsigned int, dim> &upper,
                   const double                         side)
  {
    dealii::Point<dim> origin, middle_low, middle_high, top;
    for (unsigned int d = 0; d < dim - 1; ++d)
      middle_high[d] = top[d] = side;
    middle_low[dim - 1] = middle_high[dim - 1] = lower_height;
    top[dim - 1]                               = height;
    Stack<dim> result{block<dim>("lower", origin, middle_high, lower),
                      block<dim>("upper", middle_low, top, upper)};
    result.side           = side;
    result.lower.material = {800., 0.2, 3.};
    return result;
  }

  /** The vector of contact forces of the pressure p everywhere. */
  template <int dim>
  Vector uniform_contact_force(const TwoBodies<dim> &bodies)
  {
    Vector force = bodies.discretization.make_vector();
    for (unsigned int k = 0; k < bodies.surface.nodes().size(); ++k)
      force.local_element(bodies.coordinates.normal_entries()[k]) =
        -pressure * bodies.surface.nodes()[k].weight;
    bodies.coordinates.force_to_cartesian(force);
    return force;
  }
} // namespace signorini::tests

#endif
