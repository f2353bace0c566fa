// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_kelly_indicator_h
#define signorini_adaptivity_kelly_indicator_h

#include <signorini/adaptivity/error_indicator.h>
#include <signorini/finite_elements/cell_neighbors.h>

namespace signorini
{
  /**
   * The jumps of the stress vector between cells at the end of the step (Kelly, Gago, Zienkiewicz
   * and Babuska 1983; the weight h/24, over the shear modulus, makes it an energy). Knows neither
   * mass nor contact, and works for a state at rest.
   */
  template <int dim>
  class KellyIndicator : public ErrorIndicator<dim>
  {
  public:
    explicit KellyIndicator(const Discretization<dim> &discretization);

    dealii::Vector<double> evaluate(const StepRecord &step) const override;

  private:
    const CellNeighbors<dim> mesh;
  };
} // namespace signorini

#endif
