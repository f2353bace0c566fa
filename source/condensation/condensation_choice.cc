// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/condensation/condensation_choice.h>
#include <signorini/linear_algebra/separate_parts.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  bool condensation_pays(const CondensationCost &cost)
  {
    // In space a factor fills up: at 10 000 degrees of freedom a solution takes ten iterations'
    // time. In the plane it is faster than iterations from the first steps with a wave through a
    // few cells on. What the factor costs comes back after some solutions: fewer where they are
    // dearer, in long steps and with friction.
    constexpr double least_courant_number = 1.5;
    // By then a run takes 9 GB.
    constexpr double most_dofs = 3e6;
    // What is left is a full matrix, with a factor for each set of closed nodes. The rim of a disc
    // has 2.5 n^(1/2) entries, of which few are closed.
    const double most_contact_entries =
      std::max(1200., 3. * std::sqrt(static_cast<double>(cost.n_dofs)));
    if (cost.dim != 2 || cost.courant_number < least_courant_number || cost.n_dofs > most_dofs
        || cost.n_contact_entries > most_contact_entries || cost.n_parts > 1)
      return false;
    // The factor takes longer, too, compared with iterations, the larger the mesh is.
    const double dear = cost.use.with_friction ? 2.5 : 1.;
    return cost.use.steps > 40. / (dear * std::max(1., cost.courant_number / 2.))
                              + 1.5 * std::sqrt(cost.n_dofs / 1e4);
  }


  template <int dim>
  bool condenses(const CondensationKind         kind,
                 const PreconditionerKind       preconditioner,
                 const Discretization<dim>     &discretization,
                 const ContactCoordinates<dim> &coordinates,
                 const StepsOfMatrix           &use)
  {
    if (kind == CondensationKind::never
        || dealii::Utilities::MPI::n_mpi_processes(discretization.communicator()) > 1)
      return false;
    return kind == CondensationKind::always
           || would_condense_alone(kind, preconditioner, discretization, coordinates, use);
  }


  template <int dim>
  bool would_condense_alone(const CondensationKind         kind,
                            const PreconditionerKind       preconditioner,
                            const Discretization<dim>     &discretization,
                            const ContactCoordinates<dim> &coordinates,
                            const StepsOfMatrix           &use)
  {
    if (dim == 3 || kind != CondensationKind::automatic
        || preconditioner != PreconditionerKind::automatic)
      return false;
    const auto        &coupling = coordinates.coupling();
    const unsigned int n_nodes  = dealii::Utilities::MPI::sum(coordinates.surface_nodes().size()
                                                               + coupling.owned_partners().size(),
                                                             discretization.communicator());
    return condensation_pays(
      {dim,
       discretization.dof_handler().n_dofs(),
       discretization.mesh().courant_number(use.step_size),
       use,
       dim * n_nodes,
       coupling.any() ? 1 : SeparateParts::of<dim>(discretization.matrices().pattern).n});
  }


  double memory_of_factor(const dealii::types::global_dof_index n_dofs)
  {
    // With the full matrices from which panels come, which are there for a moment.
    constexpr double bytes_per_number = 12., of_the_matrix = 25.;
    const double     per_row = 8.5 * std::log2(static_cast<double>(n_dofs)) - 57.;
    return bytes_per_number * n_dofs * (std::max(0., per_row) + of_the_matrix);
  }


#define INSTANTIATE(dim)                                                                           \
  template bool condenses(CondensationKind,                                                        \
                          PreconditionerKind,                                                      \
                          const Discretization<dim> &,                                             \
                          const ContactCoordinates<dim> &,                                         \
                          const StepsOfMatrix &);                                                  \
  template bool would_condense_alone(CondensationKind,                                             \
                                     PreconditionerKind,                                           \
                                     const Discretization<dim> &,                                  \
                                     const ContactCoordinates<dim> &,                              \
                                     const StepsOfMatrix &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
