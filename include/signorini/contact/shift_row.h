// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_shift_row_h
#define signorini_contact_shift_row_h

#include <signorini/contact/contact_node.h>

namespace signorini
{
  /**
   * Shift the row of P of a node along the surface so that its position relative to its partners is
   * along its normal; see FacingPair. The gap follows. Where that would change a weight by more
   * than its half, the row stays.
   * @param position    of the node, in the configuration of its gap
   * @param of_partners their positions, in the order of the row
   * @param are_slaves  likewise, 1 in the first component for nodes of the slave surface
   */
  template <int dim>
  void shift_row(ContactNode<dim>             &node,
                 const dealii::Tensor<1, dim> &position,
                 const dealii::Tensor<1, dim> *of_partners,
                 const dealii::Tensor<1, dim> *are_slaves);
} // namespace signorini

#endif
