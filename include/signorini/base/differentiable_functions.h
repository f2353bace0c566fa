// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_differentiable_functions_h
#define signorini_base_differentiable_functions_h

#include <signorini/base/dual_number.h>

#include <map>
#include <string>
#include <vector>

namespace signorini
{
  /** The number of arguments is that of dealii::FunctionParser, at least one. */
  template <int dim>
  using DifferentiableFunction = DualNumber<dim> (*)(const std::vector<DualNumber<dim>> &arguments);

  /**
   * By their names, the functions of dealii::FunctionParser that have a derivative: those of
   * muParser and its own. Functions with steps have the derivative 0 of their parts.
   */
  template <int dim>
  const std::map<std::string, DifferentiableFunction<dim>> &differentiable_functions();

  /** Rounds halves away from zero, as `int` and the conditions of dealii::FunctionParser do. */
  double rounded_half_away(double value);
} // namespace signorini

#endif
