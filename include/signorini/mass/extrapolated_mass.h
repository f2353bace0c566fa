// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_extrapolated_mass_h
#define signorini_mass_extrapolated_mass_h

#include <signorini/mass/contact_strip.h>

namespace signorini
{
  /**
   * Mass redistribution by extrapolation: M~ = P'MP, where P leaves the nodes with mass alone and
   * extrapolates the motion of each contact node linearly from nodes behind it: u_p = sum_q w_q u_q
   * with sum_q w_q = 1 and sum_q w_q x_q = x_p.
   *
   * P reproduces linear functions, therefore total mass, centre of gravity and tensor of inertia
   * are those of M, exactly; contact nodes have no mass, and the rest of M~ is positive definite,
   * because P is injective there. Where a line of the mesh leads inwards, the weights are 2 and -1
   * of the first and second node on it (with equal spacing), and M~ couples no other nodes than M.
   * Curved meshes need small weights of further nodes, the least possible ones. (The idea of
   * massless contact nodes: Khenous, Laborde and Renard 2008; Krause and Walloth 2012,
   * section 3.3.)
   *
   * Collective.
   * @return changes of the rows that this process owns
   * @throws UserError if there are too few nodes behind a contact node
   */
  template <int dim>
  MassChange extrapolated_mass(const Discretization<dim> &discretization,
                               const ContactStrip<dim>   &strip);

  /**
   * The weights w of extrapolation to a massless node.
   * @return empty if the nodes around cannot reproduce linear functions there
   */
  template <int dim>
  NodeWeights extrapolation_weights(const ContactStrip<dim>        &strip,
                                    dealii::types::global_dof_index node);
} // namespace signorini

#endif
