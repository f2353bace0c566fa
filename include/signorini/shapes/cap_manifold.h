// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_cap_manifold_h
#define signorini_shapes_cap_manifold_h

#include <signorini/shapes/cap.h>

#include <deal.II/grid/manifold.h>

namespace signorini
{
  /**
   * A box with a cap, in its place: new vertices are means of old ones in the flat, unplaced box,
   * which is the chart.
   */
  template <int dim>
  class CapManifold : public dealii::ChartManifold<dim>
  {
  public:
    CapManifold(const BoxShape<dim> &box, const Placement<dim> &placement);

    std::unique_ptr<dealii::Manifold<dim>> clone() const override;
    dealii::Point<dim> pull_back(const dealii::Point<dim> &point) const override;
    dealii::Point<dim> push_forward(const dealii::Point<dim> &point) const override;

  private:
    Cap<dim>       cap;
    Placement<dim> placement;
  };
} // namespace signorini

#endif
