// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_nodal_friction_h
#define signorini_contact_nodal_friction_h

#include <signorini/contact/contact_node.h>
#include <signorini/discretization/dirichlet_conditions.h>

namespace signorini
{
  /**
   * Give each contact node the law of friction of its pair, evaluated at the node and in forces of
   * the node (stresses times weight), and find out which of its directions are relative:
   * ContactNode::friction and ContactNode::relative. Collective.
   * @throws UserError where a coefficient or a bound is negative or not finite
   */
  template <int dim>
  void assign_friction(const Discretization<dim>          &discretization,
                       const DirichletConditions<dim>     &dirichlet,
                       const std::vector<PairDescription> &pairs,
                       std::vector<ContactNode<dim>>      &nodes);

  /**
   * Which directions of a contact node are relative to the other side: a prescribed displacement is
   * that of the node itself. @param conditions prescribed components of the node; null: none
   */
  template <int dim>
  std::array<bool, dim>
  relative_directions(const ContactNode<dim>                              &node,
                      const typename DirichletConditions<dim>::Components *conditions);
} // namespace signorini

#endif
