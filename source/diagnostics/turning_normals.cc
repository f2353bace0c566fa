// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/turning_normals.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  std::vector<double> TurningNormals<dim>::add(const ContactSurface<dim> &surface,
                                               const Vector              &contact_force,
                                               const unsigned int         n_bodies,
                                               const MPI_Comm             communicator)
  {
    std::vector<double> angles(n_bodies, 0.);
    const Vector        own     = own_forces(surface, contact_force);
    auto                earlier = std::move(when_it_began);
    when_it_began.clear();
    for (const ContactNode<dim> &node : surface.nodes())
      {
        if (node.row > 0 || !is_pressed(node.normal_force(own)))
          continue;
        const dealii::Tensor<1, dim> now   = node.normal();
        const auto                   found = earlier.find(node.position);
        const dealii::Tensor<1, dim> then  = found == earlier.end() ? now : found->second;
        when_it_began[node.position]       = then;
        // Exact for small angles, where a cosine is not.
        const double angle = 2. * std::asin(std::min(1., 0.5 * (now - then).norm()));
        double      &most  = angles[surface.pairs()[node.pair].slave];
        most               = std::max(most, angle);
      }
    dealii::Utilities::MPI::max(angles, communicator, angles);
    return angles;
  }


  template <int dim>
  void TurningNormals<dim>::archive(Archive &archive, const MPI_Comm communicator)
  {
    using Nodes = std::vector<std::pair<dealii::Point<dim>, dealii::Tensor<1, dim>>>;
    Nodes of_all;
    if (!archive.reads())
      for (const Nodes &nodes : dealii::Utilities::MPI::gather(
             communicator, Nodes(when_it_began.begin(), when_it_began.end()), 0))
        of_all.insert(of_all.end(), nodes.begin(), nodes.end());
    archive(of_all);
    if (archive.reads()) // nodes of other processes are never asked for
      when_it_began.insert(of_all.begin(), of_all.end());
  }


  template class TurningNormals<2>;
  template class TurningNormals<3>;
} // namespace signorini
