// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_pair_condition_h
#define signorini_contact_pair_condition_h

#include <signorini/contact/contact_node.h>

#include <cmath>

namespace signorini
{
  /** What a node of a slave surface faces in a step, and the condition that it sets. */
  template <int dim>
  struct PairCondition
  {
    ContactNode<dim>       geometry;     ///< in the middle of the motion
    dealii::Tensor<1, dim> displacement; ///< [u] at the start of the step
    /**
     * b of nu.[d] <= b: such that a motion like the one whose normals these are keeps the condition
     * exactly if the true gap at its end is not negative. Not negative: a bound that pushes would
     * bring energy.
     */
    double bound        = 0.;
    double gap_at_start = 0.;    ///< by the geometry in the middle
    bool   is_clipped   = false; ///< the bound is zero instead of negative
    /** Of the motion that was looked at last. */
    dealii::Tensor<1, dim> motion;     ///< [d]
    double                 gap_at_end; ///< true gap; NaN if nothing is opposite then

    double missed_before = 0.; ///< missed() of the motion that was looked at before that one

    /** What the condition takes for the gap at the end of that motion. */
    double linear_gap() const { return bound - geometry.normal() * motion; }
    /** By how much the true gap is larger; 0 if nothing is opposite. */
    double missed() const { return std::isnan(gap_at_end) ? 0. : gap_at_end - linear_gap(); }
  };
} // namespace signorini

#endif
