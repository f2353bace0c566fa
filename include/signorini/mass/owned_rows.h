// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_owned_rows_h
#define signorini_mass_owned_rows_h

#include <signorini/discretization/mass_change.h>

namespace signorini
{
  /**
   * Sums of the contributions of all processes in the rows that this one owns. Collective; every
   * process sees all contributions, which come from the contact surface alone.
   */
  template <int dim>
  MassChange sum_of_owned_rows(const MassChange                          &contributions,
                               const dealii::Utilities::MPI::Partitioner &partitioner);
} // namespace signorini

#endif
