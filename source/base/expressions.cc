// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <regex>
#include <vector>

namespace signorini
{
  template <int dim, std::size_t n_components>
  std::unique_ptr<dealii::FunctionParser<dim>>
  make_function(const std::array<std::string, n_components> &expressions,
                const std::string                           &further_variable)
  {
    std::vector<std::string> texts(expressions.begin(), expressions.end());
    for (std::string &text : texts)
      if (text.empty() || text == "-")
        text = "0";
    auto function = std::make_unique<dealii::FunctionParser<dim>>(n_components);
    function->initialize((dim == 2 ? "x,y," : "x,y,z,") + further_variable,
                         texts,
                         {{"pi", dealii::numbers::PI}},
                         true);
    return function;
  }


  template <std::size_t n_components>
  bool is_given(const std::array<std::string, n_components> &expressions)
  {
    return std::any_of(expressions.begin(), expressions.end(), [](const std::string &text) {
      return !text.empty() && text != "-" && text != "0";
    });
  }


  template <std::size_t n_components>
  bool has_time(const std::array<std::string, n_components> &expressions)
  {
    static const std::regex name("\\bt\\b");
    return std::any_of(expressions.begin(), expressions.end(), [](const std::string &text) {
      return std::regex_search(text, name);
    });
  }


  template std::unique_ptr<dealii::FunctionParser<2>>
  make_function<2, 1>(const std::array<std::string, 1> &, const std::string &);
  template std::unique_ptr<dealii::FunctionParser<2>>
  make_function<2, 2>(const std::array<std::string, 2> &, const std::string &);
  template std::unique_ptr<dealii::FunctionParser<3>>
  make_function<3, 1>(const std::array<std::string, 1> &, const std::string &);
  template std::unique_ptr<dealii::FunctionParser<3>>
                make_function<3, 3>(const std::array<std::string, 3> &, const std::string &);
  template bool is_given(const std::array<std::string, 2> &);
  template bool is_given(const std::array<std::string, 3> &);
  template bool has_time(const std::array<std::string, 1> &);
  template bool has_time(const std::array<std::string, 2> &);
  template bool has_time(const std::array<std::string, 3> &);
} // namespace signorini
