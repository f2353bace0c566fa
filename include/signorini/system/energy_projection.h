// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_energy_projection_h
#define signorini_system_energy_projection_h

#include <signorini/base/solve_report.h>
#include <signorini/contact/contact_coordinates.h>

namespace signorini
{
  /**
   * The correction c that makes a displacement u_0 on a coarser mesh, interpolated from u, the
   * projection of u in the norm of elastic energy onto the admissible displacements:
   *
   *   minimise 1/2 c'A c - r'c    over c with c.nu <= bounds and c = 0 at Dirichlet conditions,
   *
   * r_i = int sigma(u - u_0) : eps(phi_i). The elastic energy of u_0 + c is not larger than that of
   * u, unless a bound is in the way.
   *
   * The energy does not see the rigid motions of free bodies. They are those of u: for all rigid
   * motions R that neither Dirichlet conditions nor closed nodes hold,
   *
   *   R'M c = R'm,    m_i = int rho (u - u_0).phi_i,
   *
   * so that the centre of mass of each free body and its mean rotation stay where they are, as the
   * projection of the velocity keeps linear and angular momentum; and so does the potential of
   * gravity. A closed node keeps its gap instead, lest a change of the mesh open it or push it into
   * the other side; what it holds of R'M c is the smallest that the bounds allow.
   *
   * @param energy_moments r
   * @param mass_moments   m
   * @param bounds         what is left of the gaps at u_0; may not be negative
   * @param size           of u as a norm of energy (the square root of twice an energy): the unit
   *                       of accepted errors
   * @return c. Collective.
   */
  template <int dim>
  Vector project_in_energy(const Discretization<dim>     &discretization,
                           const ContactCoordinates<dim> &coordinates,
                           const Vector                  &energy_moments,
                           const Vector                  &mass_moments,
                           const std::vector<double>     &bounds,
                           double                         size,
                           const ActiveSetLimits         &limits);
} // namespace signorini

#endif
