// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_residual_parts_h
#define signorini_adaptivity_residual_parts_h

#include <signorini/adaptivity/contact_fields.h>
#include <signorini/adaptivity/residual_weights.h>

namespace signorini
{
  // The parts of the residual estimate. Integrals by the formula of Gauss with two points per
  // direction: on parallelepipeds and rectangles all of them are exact. Vectors have values at
  // hanging nodes; each part adds to the squares of the cells of this process.

  /** Interior residual of a stress and a force per mass. */
  template <int dim>
  void add_interior_residual(const StressVectors<dim> &stress,
                             const Vector             &specific_force,
                             const ResidualWeights    &weights,
                             dealii::Vector<double>   &squares);

  /** Jumps of the stress vector between cells. */
  template <int dim>
  void add_stress_jumps(const StressVectors<dim> &stress,
                        const ResidualWeights    &weights,
                        dealii::Vector<double>   &squares);

  /** All surfaces of the bodies. */
  template <int dim>
  void add_boundary_residual(const StressVectors<dim> &stress,
                             const SurfaceRoles<dim>  &roles,
                             const ForceBalance       &balance,
                             const ContactFields<dim> &fields,
                             const ResidualWeights    &weights,
                             dealii::Vector<double>   &squares);
} // namespace signorini

#endif
