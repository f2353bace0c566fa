// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/graded_mesh.h>
#include <signorini/preconditioners/preconditioner_choice.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  template <int dim>
  double ratio_of_stiffness(const ElasticMatrices<dim> &matrices)
  {
    const NodePattern &pattern = matrices.pattern;
    double             largest = 0., smallest = std::numeric_limits<double>::max();
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (!pattern.is_empty(node))
        {
          const double stiffness = matrices.stiffness[pattern.row_start[node]][0];
          largest                = std::max(largest, stiffness);
          smallest               = std::min(smallest, stiffness);
        }
    const MPI_Comm communicator = pattern.partitioner->get_mpi_communicator();
    return dealii::Utilities::MPI::max(largest, communicator)
           / dealii::Utilities::MPI::min(smallest, communicator);
  }


  template <int dim>
  bool needs_double_precision(const Discretization<dim> &discretization, const double step_size)
  {
    constexpr double longest_step = 3000., most_of_stiffness = 3e4;
    const double     courant_number = discretization.mesh().courant_number(step_size);
    if (courant_number > longest_step)
      return true;
    // Mass makes stiff bodies and soft ones alike in short steps.
    return courant_number * courant_number > most_of_stiffness
           && ratio_of_stiffness(discretization.matrices()) > most_of_stiffness;
  }


  template <int dim>
  StepCost cost_of_step(const Discretization<dim> &discretization, const double step_size)
  {
    const Mesh<dim> &mesh = discretization.mesh();
    StepCost         cost;
    cost.courant_number           = mesh.courant_number(step_size);
    cost.effective_courant_number = effective_courant_number(mesh, step_size);
    cost.grading                  = grading(mesh);
    cost.n_dofs                   = discretization.dof_handler().n_dofs();
    cost.stiffness_ratio          = ratio_of_stiffness(discretization.matrices());
    return cost;
  }


  PreconditionerKind choose_preconditioner(const StepCost &cost)
  {
    const double courant_number = cost.courant_number;
    if (cost.solves_roughly)
      {
        // An iteration with multigrid takes six times as long, and five of them make a solution; on
        // graded meshes each is dearer. With friction there are more linear systems, and each asks
        // for less.
        const double dear            = 1. + 0.8 * cost.grading;
        const double most_iterations = dear * (cost.with_friction ? 17. : 33.);
        const double too_large       = dear * std::min(100., 50. * (1. + 5000. / cost.n_dofs));
        if (cost.iterations > 0. ? cost.iterations <= most_iterations
                                 : cost.effective_courant_number <= too_large)
          return PreconditionerKind::symmetric_gauss_seidel;
        return cost.stiffness_ratio > most_for_multigrid ? PreconditionerKind::incomplete_cholesky
                                                         : PreconditionerKind::multigrid;
      }
    // A factor costs about as much as it saves in 40 steps at Courant number 1, in 8 at 5. Where
    // the stiffness rules the diagonal is too poor in any case: the accuracy of a solution is
    // judged in its norm.
    if (courant_number < 0.3
        || (courant_number < 10. && cost.matrix_life_time * courant_number < 40.))
      return PreconditionerKind::jacobi;
    // With the incomplete factor iterations grow with the Courant number, with multigrid they do
    // not, but each is dearer, and most on small meshes.
    const double multigrid_pays = std::min(100., 12. * (1. + 30000. / cost.n_dofs));
    return courant_number > multigrid_pays && cost.stiffness_ratio <= most_for_multigrid
             ? PreconditionerKind::multigrid
             : PreconditionerKind::incomplete_cholesky;
  }


#define INSTANTIATE(dim)                                                                           \
  template double   ratio_of_stiffness(const ElasticMatrices<dim> &);                              \
  template bool     needs_double_precision(const Discretization<dim> &, double);                   \
  template StepCost cost_of_step(const Discretization<dim> &, double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
