// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_macro_element_mass_h
#define signorini_mass_macro_element_mass_h

#include <signorini/mass/contact_strip.h>

namespace signorini
{
  /**
   * Mass redistribution by quadrature on macro-elements (Hager, Hueeber and Wohlmuth 2008; Krause
   * and Walloth 2012, section 3.4). Each cell at a contact node is joined to a cell behind it; on
   * the macro-element the mass is integrated with points in the cell behind only, three per
   * direction, and weights that are exact for all quadratic functions on the macro-element.
   * (Weights of Simpson's rule times 1 plus a quadratic polynomial; with two layers of equal bricks
   * they are 10/3, -8/3, 4/3 times the thickness across the layers.)
   *
   * Contact nodes have no mass; total mass, centre of gravity and tensor of inertia are kept; the
   * couplings are those of M. Some weights are negative, and nothing ensures that the result is
   * positive definite: look at MassSolver::smallest_ratio().
   *
   * Collective.
   * @return changes of the rows that this process owns
   * @throws UserError if there is no cell behind a cell at a contact node, or it has hanging nodes
   */
  template <int dim>
  MassChange macro_element_mass(const Discretization<dim> &discretization,
                                const ContactStrip<dim>   &strip);
} // namespace signorini

#endif
