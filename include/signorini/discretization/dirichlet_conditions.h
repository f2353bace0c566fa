// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_dirichlet_conditions_h
#define signorini_discretization_dirichlet_conditions_h

#include <signorini/discretization/discretization.h>

#include <deal.II/base/function_parser.h>

#include <map>

namespace signorini
{
  /** Which components of which owned nodes are prescribed, and their values in time. */
  template <int dim>
  class DirichletConditions
  {
  public:
    explicit DirichletConditions(const Discretization<dim> &discretization);

    /** Per component the index of the condition that prescribes it, or `none`. */
    using Components                   = std::array<unsigned int, dim>;
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    /** Prescribed components by owned node. */
    const std::map<unsigned int, Components> &nodes() const { return prescribed; }

    /** Displacement prescribed by a condition for a component at a point. */
    double value(unsigned int              condition,
                 const dealii::Point<dim> &point,
                 unsigned int              component,
                 double                    time) const;

  private:
    std::map<unsigned int, Components> prescribed;
    std::vector<dealii::FunctionParser<dim> *>
      functions; ///< of each condition; the mesh keeps them
  };
} // namespace signorini

#endif
