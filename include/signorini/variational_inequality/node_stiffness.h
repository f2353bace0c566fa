// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_node_stiffness_h
#define signorini_variational_inequality_node_stiffness_h

#include <signorini/variational_inequality/constrained_problem.h>

namespace signorini
{
  /**
   * A number of the size of K for each bounded entry: the mean of the diagonal over the entry and
   * the tangential entries of its node. It does not depend on the choice of the tangents.
   */
  inline std::vector<double> node_stiffness(const ConstrainedProblem &problem)
  {
    Vector diagonal;
    diagonal.reinit(problem.right_hand_side, true);
    problem.matrix.diagonal(diagonal);
    std::vector<double> stiffness;
    for (std::size_t k = 0; k < problem.bounded_entries.size(); ++k)
      {
        const auto &entries = problem.friction[k].entries;
        double      sum     = diagonal.local_element(problem.bounded_entries[k]);
        for (const unsigned int i : entries)
          sum += diagonal.local_element(i);
        stiffness.push_back(sum / (1. + entries.size()));
      }
    return stiffness;
  }
} // namespace signorini

#endif
