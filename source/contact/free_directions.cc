// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/free_directions.h>
#include <signorini/surfaces/contact_frame.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double no_part = 1e-12; ///< parts of a unit normal below this are none
    constexpr double no_free_part =
      1e-6; ///< with a free part below this, nothing can close the gap
  }         // namespace


  template <int dim>
  bool meet_in_free_directions(const typename DirichletConditions<dim>::Components &conditions,
                               const Tensor<1, dim>                                &unit_normal,
                               ContactNode<dim>                                    &contact_node)
  {
    std::array<bool, dim> held;
    Tensor<1, dim>        normal = unit_normal, prescribed_part;
    for (unsigned int c = 0; c < dim; ++c)
      if ((held[c] = conditions[c] != DirichletConditions<dim>::none)
          && std::abs(normal[c]) > no_part)
        {
          prescribed_part[c] = normal[c];
          normal[c]          = 0.;
        }
    contact_node.prescribed_part = prescribed_part;
    contact_node.free_part       = 1.;
    if (prescribed_part.norm() > 0.)
      {
        const double free_part = normal.norm();
        if (free_part < no_free_part)
          return false;
        contact_node.free_part = free_part;
        normal /= free_part;
      }
    contact_frame_with_dirichlet<dim>(normal, held, contact_node.frame);
    return true;
  }


  template bool meet_in_free_directions(const DirichletConditions<2>::Components &,
                                        const Tensor<1, 2> &,
                                        ContactNode<2> &);
  template bool meet_in_free_directions(const DirichletConditions<3>::Components &,
                                        const Tensor<1, 3> &,
                                        ContactNode<3> &);
} // namespace signorini
