// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_expressions_h
#define signorini_base_expressions_h

#include <deal.II/base/function_parser.h>

#include <array>
#include <map>
#include <memory>
#include <string>

namespace signorini
{
  /**
   * A function of x, y, (z) and one further variable from one expression per component. An empty
   * expression is 0. The expressions have been checked when the scene was read.
   * @param further_variable its name; set_time() sets its value, whatever it means
   */
  template <int dim, std::size_t n_components>
  std::unique_ptr<dealii::FunctionParser<dim>>
  make_function(const std::array<std::string, n_components> &expressions,
                const std::string                           &further_variable = "t");

  /**
   * Functions of x, y, (z) and t that were made before: to parse an expression takes as long as a
   * step in 2d.
   */
  template <int dim>
  class FunctionCache
  {
  public:
    dealii::FunctionParser<dim> &get(const std::array<std::string, dim> &expressions)
    {
      auto &function = functions[expressions];
      if (!function)
        function = make_function<dim, dim>(expressions);
      return *function;
    }

  private:
    std::map<std::array<std::string, dim>, std::unique_ptr<dealii::FunctionParser<dim>>> functions;
  };

  /** Whether any of the expressions may be something else than zero. */
  template <std::size_t n_components>
  bool is_given(const std::array<std::string, n_components> &expressions);

  /** Whether any of the expressions depends on the variable t. */
  template <std::size_t n_components>
  bool has_time(const std::array<std::string, n_components> &expressions);
} // namespace signorini

#endif
