// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_energy_projection_h
#define signorini_system_energy_projection_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/model/run_parameters.h>

namespace signorini
{
  /**
   * The correction that makes a displacement the projection of another function in the norm of
   * elastic energy onto the admissible ones: minimise 1/2 c'A c - r'c over c with c.nu <= bounds
   * and c = 0 in prescribed entries, r the products of the error with the shape functions. The
   * elastic energy of the result is not larger than that of the function, unless a bound is in the
   * way.
   *
   * Rigid motions of free bodies have no energy; a tiny multiple of the mass keeps them where they
   * are.
   *
   * Collective.
   * @param error_moments r
   * @param size          of the function, as a norm of energy (the square root of twice an energy):
   *                      the unit of accepted errors
   */
  template <int dim>
  Vector project_in_energy(const Discretization<dim>     &discretization,
                           const ContactCoordinates<dim> &coordinates,
                           const Vector                  &error_moments,
                           const std::vector<double>     &bounds,
                           double                         size,
                           const SolverParameters        &limits);
} // namespace signorini

#endif
