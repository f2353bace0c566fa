// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_minimised_mass_h
#define signorini_mass_minimised_mass_h

#include <signorini/mass/contact_strip.h>

namespace signorini
{
  /**
   * Mass redistribution by constrained minimisation (Khenous, Laborde and Renard 2008; Krause and
   * Walloth 2012, section 3.3): among all symmetric matrices with the couplings of M and empty rows
   * at contact nodes the one that is closest to M and keeps total mass, centre of gravity and
   * tensor of inertia of each body. Changes are measured relative to the size of the entry,
   *
   * @f[
   *   \text{minimise} \quad \sum_{ij} (\tilde M_{ij} - M_{ij})^2 / M_{ij}, \quad \text{hence} \quad
   *   \tilde M_{ij} = M_{ij} (1 + q(x_i, x_j)) \text{ between nodes with mass,}
   * @f]
   *
   * with a symmetric polynomial q, linear in each point, whose few coefficients follow from the
   * constraints. (Without the weights the matrix of a ball is indefinite.) It is positive definite
   * if the matrix of the coefficients of 1 + q is, by Schur's product theorem; else look at
   * MassSolver::smallest_ratio().
   *
   * Collective. Replaces matrices.mass and keeps the consistent one in matrices.standard_mass.
   * @throws UserError if all nodes of a body are contact nodes
   */
  template <int dim>
  void minimise_change_of_mass(Discretization<dim> &discretization, const ContactStrip<dim> &strip);
} // namespace signorini

#endif
