// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/prm/section_reader.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace signorini
{
  namespace
  {
    /**
     * dealii::FunctionParser reports a syntax error on std::cerr besides throwing it: once is
     * enough.
     */
    class MuteStandardError
    {
    public:
      MuteStandardError()
        : buffer(std::cerr.rdbuf(sink.rdbuf()))
      {
      }
      MuteStandardError(const MuteStandardError &) = delete;
      ~MuteStandardError() { std::cerr.rdbuf(buffer); }

    private:
      std::ostringstream sink;
      std::streambuf    *buffer;
    };

    std::string parser_message(const dealii::ExceptionBase &exception)
    {
      std::ostringstream info;
      exception.print_info(info);
      const std::string text  = info.str();
      const std::string mark  = "The parser said: ";
      const std::size_t begin = text.find(mark);
      std::string       message =
        trim(begin == std::string::npos ? text : text.substr(begin + mark.size()));
      if (!message.empty() && message.back() == '.')
        message.pop_back();
      return message;
    }

    template <int dim>
    std::string variables(const std::string &further)
    {
      return std::string(dim == 2 ? "x,y" : "x,y,z") + (further.empty() ? "" : ",") + further;
    }

    [[noreturn]] void refuse_syntax(const SectionReader         &in,
                                    const std::string           &key,
                                    const std::string           &expression,
                                    const std::string           &variables,
                                    const dealii::ExceptionBase &exception)
    {
      in.fail(key,
              "the expression `" + expression + "` cannot be understood: "
                + parser_message(exception) + ". It may use the variables " + variables
                + ", the constant pi, and functions such as sin, exp, if(condition, a, b).");
    }
  } // namespace

  template <int dim>
  std::array<std::string, dim>
  split_components(const SectionReader &in, const std::string &key, const std::string &expressions)
  {
    const std::vector<std::string> components = split(expressions, ';');
    if (components.size() != dim)
      in.fail(key,
              "must have " + std::to_string(dim)
                + " components, separated by semicolons (one per space dimension); `" + expressions
                + "` has " + std::to_string(components.size()) + ".");
    std::array<std::string, dim> result;
    std::copy(components.begin(), components.end(), result.begin());
    return result;
  }

  namespace
  {
    /** Readers of expressions go one level of the stack deeper for each parenthesis. */
    constexpr int         most_nested   = 100;
    constexpr std::size_t most_in_total = 10000; ///< characters

    /** What muParser would understand differently, or not within the limits of the stack. */
    void check_form(const SectionReader &in, const std::string &key, const std::string &expression)
    {
      if (expression.size() > most_in_total)
        in.fail(key,
                "the expression has " + std::to_string(expression.size())
                  + " characters, and at most " + std::to_string(most_in_total)
                  + " can be used. Write it in a shorter way.");
      int depth = 0;
      for (const char c : expression)
        {
          depth += (c == '(') - (c == ')');
          if (depth > most_nested)
            in.fail(key,
                    "the expression has more than " + std::to_string(most_nested)
                      + " parentheses inside each other. Write it in a simpler way.");
          if (c == ',' && depth == 0)
            in.fail(key,
                    "the expression `" + expression
                      + "` has a comma outside of parentheses. Numbers have a point, as in 0.5, "
                        "and components are separated by semicolons.");
        }
    }
  } // namespace

  template <int dim>
  void check_expression(const SectionReader                   &in,
                        const std::string                     &key,
                        const std::string                     &expression,
                        const std::vector<dealii::Point<dim>> &points,
                        const std::string                     &further_variable)
  {
    check_form(in, key, expression);
    dealii::FunctionParser<dim> function;
    try
      {
        const MuteStandardError        mute;
        const std::vector<std::string> components = {expression};
        function.initialize(variables<dim>(further_variable),
                            components,
                            {{"pi", dealii::numbers::PI}},
                            !further_variable.empty());
        // The syntax is looked at when the first value is asked for.
        function.value(dealii::Point<dim>());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        refuse_syntax(in, key, expression, variables<dim>(further_variable), exception);
      }

    for (const dealii::Point<dim> &point : points)
      {
        const double value = function.value(point);
        if (!std::isfinite(value))
          {
            std::ostringstream where;
            where << '(' << point << ')';
            in.fail(key,
                    "the expression `" + expression + "` is "
                      + (std::isnan(value) ? "not a number" : "infinite") + " at the point "
                      + where.str()
                      + (further_variable.empty() ? "" : " at " + further_variable + " = 0")
                      + ". Correct it, or exclude the point with if(condition, a, b).");
          }
      }
  }

  std::optional<double> constant_value(const std::string &expression)
  {
    try
      {
        const MuteStandardError        mute;
        const std::vector<std::string> components = {expression};
        dealii::FunctionParser<1>      function;
        function.initialize(
          "the_variable_that_nobody_uses", components, {{"pi", dealii::numbers::PI}});
        return function.value(dealii::Point<1>());
      }
    catch (const dealii::ExceptionBase &)
      {
        return std::nullopt;
      }
  }

  template <int dim>
  std::array<std::string, dim> read_expressions(const SectionReader                   &in,
                                                const std::string                     &key,
                                                const std::vector<dealii::Point<dim>> &points,
                                                const bool                             with_time)
  {
    const std::array<std::string, dim> expressions = split_components<dim>(in, key, in.text(key));
    for (const std::string &expression : expressions)
      check_expression<dim>(in, key, expression, points, with_time ? "t" : "");
    return expressions;
  }

  using Points2 = std::vector<dealii::Point<2>>;
  using Points3 = std::vector<dealii::Point<3>>;
  using Text    = std::string;
  using Reader  = SectionReader;
  template std::array<Text, 2> split_components<2>(const Reader &, const Text &, const Text &);
  template std::array<Text, 3> split_components<3>(const Reader &, const Text &, const Text &);
  template void
  check_expression<2>(const Reader &, const Text &, const Text &, const Points2 &, const Text &);
  template void
  check_expression<3>(const Reader &, const Text &, const Text &, const Points3 &, const Text &);
  template std::array<Text, 2>
  read_expressions<2>(const Reader &, const Text &, const Points2 &, bool);
  template std::array<Text, 3>
  read_expressions<3>(const Reader &, const Text &, const Points3 &, bool);
} // namespace signorini
