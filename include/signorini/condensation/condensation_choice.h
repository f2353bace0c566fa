// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_condensation_condensation_choice_h
#define signorini_condensation_condensation_choice_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/model/condensation_kind.h>
#include <signorini/model/run_parameters.h>

namespace signorini
{
  /** The steps that a matrix is for. */
  struct StepsOfMatrix
  {
    double       step_size;
    unsigned int steps; ///< that are expected
    bool         with_friction;
  };

  /** What decides whether steps are solved for the contact nodes alone. */
  struct CondensationCost
  {
    unsigned int                    dim;
    dealii::types::global_dof_index n_dofs;
    double                          courant_number;
    StepsOfMatrix                   use;
    unsigned int                    n_contact_entries; ///< of nodes that may touch, and of partners
    /** Bodies that nothing couples: iterations leave out those to which nothing happens. */
    unsigned int n_parts = 1;
  };

  /** Whether a direct factor saves more than it costs (doc/performance.md). */
  bool condensation_pays(const CondensationCost &cost);

  /**
   * Whether steps are condensed: on one process, if that is asked for, or if it pays and no
   * preconditioner is asked for.
   */
  template <int dim>
  bool condenses(CondensationKind               kind,
                 PreconditionerKind             preconditioner,
                 const Discretization<dim>     &discretization,
                 const ContactCoordinates<dim> &coordinates,
                 const StepsOfMatrix           &use);

  /**
   * Whether steps would be condensed without being asked for if there were one process. Collective.
   */
  template <int dim>
  bool would_condense_alone(CondensationKind               kind,
                            PreconditionerKind             preconditioner,
                            const Discretization<dim>     &discretization,
                            const ContactCoordinates<dim> &coordinates,
                            const StepsOfMatrix           &use);

  /** Bytes that a factor takes in the plane, by a line through measured sizes. */
  double memory_of_factor(dealii::types::global_dof_index n_dofs);
} // namespace signorini

#endif
