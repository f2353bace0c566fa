// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_differentiable_expression_h
#define signorini_base_differentiable_expression_h

#include <signorini/base/dual_number.h>

#include <deal.II/base/point.h>

#include <functional>
#include <string>

namespace signorini
{
  /**
   * An expression in x, y, (z) and the constant pi, in the language of muParser as
   * dealii::FunctionParser has it, with its exact gradient. See doc/architecture.md for why there
   * is a second reader of that language.
   */
  template <int dim>
  class DifferentiableExpression
  {
  public:
    /**
     * @param text an expression that dealii::FunctionParser understands
     * @throws UserError saying what in it has no derivative (a random number) or is no value (an
     * assignment)
     */
    explicit DifferentiableExpression(const std::string &text);

    /** Value and gradient; not finite where the expression has none. */
    DualNumber<dim> operator()(const dealii::Point<dim> &p) const { return evaluate(p); }

  private:
    std::function<DualNumber<dim>(const dealii::Point<dim> &)> evaluate;
  };
} // namespace signorini

#endif
