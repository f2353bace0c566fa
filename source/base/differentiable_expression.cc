// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/differentiable_expression.h>
#include <signorini/base/differentiable_functions.h>
#include <signorini/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <cctype>
#include <locale>
#include <sstream>
#include <utility>

namespace signorini
{
  using dealii::Point;

  namespace
  {
    /**
     * The grammar of muParser by recursive descent, one function for each precedence, the weakest
     * first. Texts that muParser does not understand have been refused before.
     */
    template <int dim>
    class ExpressionReader
    {
    public:
      using Dual     = DualNumber<dim>;
      using Evaluate = std::function<Dual(const Point<dim> &)>;

      explicit ExpressionReader(const std::string &text)
        : text(text + " ") // a number ends before the end of the text
      {
      }

      Evaluate read()
      {
        const Evaluate all = conditional();
        skip_space();
        if (position < text.size())
          refuse_rest();
        return all;
      }

    private:
      const std::string text;
      std::size_t       position = 0;

      using Binary = Dual (*)(const Dual &, const Dual &);
      using Level  = std::vector<std::pair<std::string, Binary>>;

      [[noreturn]] void refuse_rest() const
      {
        throw UserError("`" + text.substr(position, text.size() - 1 - position)
                        + (text[position] == '=' ? "` is an assignment, which has no derivative"
                                                 : "` has no known derivative"));
      }

      void skip_space()
      {
        while (position < text.size() && std::isspace(static_cast<unsigned char>(text[position])))
          ++position;
      }

      bool take(const std::string &token)
      {
        skip_space();
        if (text.compare(position, token.size(), token) != 0)
          return false;
        position += token.size();
        return true;
      }

      void expect(const std::string &token)
      {
        if (!take(token))
          refuse_rest();
      }

      Evaluate conditional()
      {
        const Evaluate condition = binary(0);
        if (!take("?"))
          return condition;
        const Evaluate yes = conditional();
        expect(":");
        const Evaluate no = conditional();
        return [=](const Point<dim> &p) { return condition(p).value != 0. ? yes(p) : no(p); };
      }

      static Dual truth(const bool value) { return {value ? 1. : 0., {}}; }
      static bool holds(const Dual &a) { return rounded_half_away(a.value) != 0.; }

      /** Operators that group from the left; of those that begin alike the longer one first. */
      static const std::vector<Level> &levels()
      {
        static const std::vector<Level> table{
          {{"||",
            [](const Dual &a, const Dual &b) { return truth(a.value != 0. || b.value != 0.); }},
           {"|", [](const Dual &a, const Dual &b) { return truth(holds(a) || holds(b)); }}},
          {{"&&",
            [](const Dual &a, const Dual &b) { return truth(a.value != 0. && b.value != 0.); }},
           {"&", [](const Dual &a, const Dual &b) { return truth(holds(a) && holds(b)); }}},
          {{"<=", [](const Dual &a, const Dual &b) { return truth(a.value <= b.value); }},
           {">=", [](const Dual &a, const Dual &b) { return truth(a.value >= b.value); }},
           {"!=", [](const Dual &a, const Dual &b) { return truth(a.value != b.value); }},
           {"==", [](const Dual &a, const Dual &b) { return truth(a.value == b.value); }},
           {"<", [](const Dual &a, const Dual &b) { return truth(a.value < b.value); }},
           {">", [](const Dual &a, const Dual &b) { return truth(a.value > b.value); }}},
          {{"+", [](const Dual &a, const Dual &b) { return a + b; }},
           {"-", [](const Dual &a, const Dual &b) { return a - b; }}},
          {{"*", [](const Dual &a, const Dual &b) { return a * b; }},
           {"/", [](const Dual &a, const Dual &b) { return a / b; }}}};
        return table;
      }

      Binary take_operator(const Level &level)
      {
        for (const auto &[token, operation] : level)
          if (take(token))
            return operation;
        return nullptr;
      }

      Evaluate binary(const std::size_t level)
      {
        if (level == levels().size())
          return signed_power();
        Evaluate left = binary(level + 1);
        while (const Binary operation = take_operator(levels()[level]))
          left = [operation, left = std::move(left), right = binary(level + 1)](
                   const Point<dim> &p) { return operation(left(p), right(p)); };
        return left;
      }

      /** Signs bind weaker than powers: -x^2 is negative, and 2^-x has a negative exponent. */
      Evaluate signed_power()
      {
        if (take("-"))
          return [argument = signed_power()](const Point<dim> &p) { return -argument(p); };
        if (take("+"))
          return signed_power();
        const Evaluate base = primary();
        if (!take("^"))
          return base;
        return [base, exponent = signed_power()](const Point<dim> &p) {
          return power(base(p), exponent(p));
        };
      }

      Evaluate primary()
      {
        if (take("("))
          {
            const Evaluate inner = conditional();
            expect(")");
            return inner;
          }
        if (position < text.size()
            && (std::isalpha(static_cast<unsigned char>(text[position])) || text[position] == '_'))
          return named();
        return constant(number());
      }

      static Evaluate constant(const double value)
      {
        return [value](const Point<dim> &) { return Dual{value, {}}; };
      }

      /** As muParser reads it. */
      double number()
      {
        std::istringstream stream(text.substr(position));
        stream.imbue(std::locale::classic());
        double value;
        if (!(stream >> value))
          refuse_rest();
        position += static_cast<std::size_t>(stream.tellg());
        return value;
      }

      Evaluate named()
      {
        const std::size_t begin = position;
        while (
          position < text.size()
          && (std::isalnum(static_cast<unsigned char>(text[position])) || text[position] == '_'))
          ++position;
        const std::string name = text.substr(begin, position - begin);
        if (take("("))
          return call(name);
        for (unsigned int c = 0; c < dim; ++c)
          if (name == std::string(1, "xyz"[c]))
            return [c](const Point<dim> &p) {
              Dual coordinate{p[c], {}};
              coordinate.gradient[c] = 1.;
              return coordinate;
            };
        if (name == "pi" || name == "_pi")
          return constant(dealii::numbers::PI);
        if (name == "_e")
          return constant(dealii::numbers::E);
        throw UserError("`" + name + "` has no known derivative");
      }

      Evaluate call(const std::string &name)
      {
        std::vector<Evaluate> arguments;
        if (!take(")"))
          {
            do
              arguments.push_back(conditional());
            while (take(","));
            expect(")");
          }
        const auto &functions = differentiable_functions<dim>();
        const auto  function  = functions.find(name);
        if (function == functions.end())
          throw UserError("the function `" + name + "` has no derivative");
        return [evaluate = function->second, arguments](const Point<dim> &p) {
          std::vector<Dual> values;
          values.reserve(arguments.size());
          for (const Evaluate &argument : arguments)
            values.push_back(argument(p));
          return evaluate(values);
        };
      }
    };
  } // namespace


  template <int dim>
  DifferentiableExpression<dim>::DifferentiableExpression(const std::string &text)
    : evaluate(ExpressionReader<dim>(text).read())
  {
  }


  template class DifferentiableExpression<2>;
  template class DifferentiableExpression<3>;
} // namespace signorini
