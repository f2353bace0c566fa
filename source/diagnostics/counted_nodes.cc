// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/diagnostics/counted_nodes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  double force_of_round_off(const ContactSurface<dim> &surface,
                            const Discretization<dim> &discretization,
                            const State               &state,
                            const Vector              &own)
  {
    double largest = 0.;
    for (const ContactNode<dim> &node : surface.nodes())
      largest = std::max(largest, std::abs(node.normal_force(own)));
    largest = dealii::Utilities::MPI::max(largest, discretization.communicator());
    if (largest == 0.)
      return 0.;
    const double energy =
      0.5 * (state.velocity * state.momentum + state.displacement * state.internal_force);
    return unnoticed_force * std::max(largest, energy / discretization.mesh().body_size());
  }


  template double force_of_round_off(const ContactSurface<2> &,
                                     const Discretization<2> &,
                                     const State &,
                                     const Vector &);
  template double force_of_round_off(const ContactSurface<3> &,
                                     const Discretization<3> &,
                                     const State &,
                                     const Vector &);
} // namespace signorini
