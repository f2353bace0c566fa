// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_point_probe_h
#define signorini_model_point_probe_h

#include <deal.II/base/point.h>

#include <string>

namespace signorini
{
  /** Section `Probes/<name>` with a `Body`: the history of a point of that body. */
  template <int dim>
  struct PointProbeDescription
  {
    std::string        name;
    std::string        body_name;
    unsigned int       body;  ///< its index
    dealii::Point<dim> point; ///< in the reference configuration
  };
} // namespace signorini

#endif
