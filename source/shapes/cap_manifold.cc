// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/cap_manifold.h>

namespace signorini
{
  template <int dim>
  CapManifold<dim>::CapManifold(const BoxShape<dim> &box, const Placement<dim> &placement)
    : cap(box)
    , placement(placement)
  {
  }

  template <int dim>
  std::unique_ptr<dealii::Manifold<dim>> CapManifold<dim>::clone() const
  {
    return std::make_unique<CapManifold<dim>>(*this);
  }

  template <int dim>
  dealii::Point<dim> CapManifold<dim>::pull_back(const dealii::Point<dim> &point) const
  {
    return cap.flatten(placement.pull_back(point));
  }

  template <int dim>
  dealii::Point<dim> CapManifold<dim>::push_forward(const dealii::Point<dim> &point) const
  {
    return placement.place(cap.bulge(point));
  }

  template class CapManifold<2>;
  template class CapManifold<3>;
} // namespace signorini
