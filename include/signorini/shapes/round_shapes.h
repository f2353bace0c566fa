// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_round_shapes_h
#define signorini_shapes_round_shapes_h

#include <signorini/prm/section_reader.h>

#include <vector>

namespace signorini
{
  // What balls and cylinders have in common.

  /** Declares `Centre`, `Radius`, and `Length` and `Axis` of cylinders. */
  template <int dim>
  void declare_round_shapes(dealii::ParameterHandler &prm);

  /** The value of `Radius`. @throws UserError if no mesh can be made with it */
  double parse_radius(const SectionReader &in);

  /**
   * Points at distance @p radius from @p centre along the coordinate directions, except the
   * direction @p axis.
   */
  template <int dim>
  std::vector<dealii::Point<dim>>
  poles(const dealii::Point<dim> &centre, double radius, unsigned int axis);
} // namespace signorini

#endif
