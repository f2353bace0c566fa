// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_reach_of_forces_h
#define signorini_preconditioners_reach_of_forces_h

#include <signorini/linear_algebra/elastic_matrices.h>

namespace signorini
{
  /**
   * How much of what happens at some nodes arrives at others, when only the mass couples them: per
   * owned node an estimate of M^-1 f there over that where the forces f act. The inverse of a band
   * matrix decays exponentially (Demko, Moss and Smith, Math. Comp. 43 (1984) 491-499); with
   * bilinear and trilinear elements by 2 - 3^(1/2) per edge, a little more than the coupling of the
   * ends of an edge over their masses, 1/4. So it is the largest product of such ratios along a way
   * from there. Collective.
   * @param origins owned nodes
   * @param least   what is less need not be right
   */
  template <int dim>
  std::vector<double> reach_of_forces(const ElasticMatrices<dim>      &matrices,
                                      const std::vector<unsigned int> &origins,
                                      double                           least);
} // namespace signorini

#endif
