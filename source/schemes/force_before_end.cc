// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/alpha_rule.h>
#include <signorini/schemes/scheme_table.h>

#include <deal.II/base/function_parser.h>

namespace signorini
{
  bool balances_momentum_by_one_force(const SchemeInfo &info)
  {
    return info.trapezoidal_rule || (info.balance == StepBalance::end && !info.mean_velocity);
  }


  double force_before_end(const SchemeInfo &info, const SchemeParameters &parameters)
  {
    double parameter = parameters.spectral_radius.value_or(AlphaRule::usual_radius);
    if (info.parameter == "HHT alpha")
      parameter = parameters.hht_alpha;
    dealii::FunctionParser<1> expression;
    expression.initialize("p", info.force_before_end, {});
    return expression.value(dealii::Point<1>(parameter));
  }
} // namespace signorini
