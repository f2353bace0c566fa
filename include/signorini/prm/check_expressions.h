// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_check_expressions_h
#define signorini_prm_check_expressions_h

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace signorini
{
  class SectionReader;

  /** The components of a vector-valued expression, "0; 0; -2". */
  template <int dim>
  std::array<std::string, dim>
  split_components(const SectionReader &in, const std::string &key, const std::string &expressions);

  /**
   * Refuse an expression that does not parse, or that is not a finite number in one of the points
   * where the further variable is 0. It may use x, y, z, the constant pi and, if its name is not
   * empty, the further variable. @p key is the key of the scene it stands in.
   */
  template <int dim>
  void check_expression(const SectionReader                   &in,
                        const std::string                     &key,
                        const std::string                     &expression,
                        const std::vector<dealii::Point<dim>> &points,
                        const std::string                     &further_variable);

  /**
   * The value of an expression that uses no variables, such as 1-1; nothing if it uses some or
   * does not parse.
   */
  std::optional<double> constant_value(const std::string &expression);

  /**
   * split_components() and check_expression() for the value of a key, in x, y, z and, if @p
   * with_time, t.
   */
  template <int dim>
  std::array<std::string, dim> read_expressions(const SectionReader                   &in,
                                                const std::string                     &key,
                                                const std::vector<dealii::Point<dim>> &points,
                                                bool                                   with_time);
} // namespace signorini

#endif
