// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_free_directions_h
#define signorini_contact_free_directions_h

#include <signorini/contact/contact_node.h>
#include <signorini/discretization/dirichlet_conditions.h>

namespace signorini
{
  /**
   * A node with prescribed directions meets an obstacle in the others: along the direction there
   * that is closest to the unit normal. Sets ContactNode::free_part, prescribed_part, and a frame
   * in which prescribed directions are tangential.
   * @return whether the node can move towards the obstacle; if not, the frame is what it was
   */
  template <int dim>
  bool meet_in_free_directions(const typename DirichletConditions<dim>::Components &conditions,
                               const dealii::Tensor<1, dim>                        &unit_normal,
                               ContactNode<dim>                                    &contact_node);
} // namespace signorini

#endif
