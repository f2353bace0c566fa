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
   * @param diagonal any vector of the size of the matrix
   */
  inline std::vector<double> node_stiffness(const LinearOperator            &matrix,
                                            const std::vector<unsigned int> &bounded_entries,
                                            const Friction                  &friction,
                                            Vector                           diagonal)
  {
    matrix.diagonal(diagonal);
    std::vector<double> stiffness;
    for (std::size_t k = 0; k < bounded_entries.size(); ++k)
      {
        double sum = diagonal.local_element(bounded_entries[k]);
        for (const unsigned int i : friction[k].entries)
          sum += diagonal.local_element(i);
        stiffness.push_back(sum / (1. + friction[k].entries.size()));
      }
    return stiffness;
  }

  inline std::vector<double> node_stiffness(const ConstrainedProblem &problem)
  {
    return node_stiffness(
      problem.matrix, problem.bounded_entries, problem.friction, problem.right_hand_side);
  }
} // namespace signorini

#endif
