// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_preconditioners_h
#define signorini_preconditioners_preconditioners_h

#include <signorini/linear_algebra/incomplete_cholesky.h>
#include <signorini/model/run_parameters.h>
#include <signorini/preconditioners/step_operator.h>

#include <memory>

namespace signorini
{
  /**
   * What `automatic` means, by measurement (doc/performance.md): the diagonal where the step is so
   * small that the mass rules or the matrix will soon be another one, geometric multigrid where the
   * stiffness rules, the incomplete factor in between.
   * @param courant_number   c_p tau / h
   * @param n_dofs           degrees of freedom on all processes
   * @param matrix_life_time number of steps that will use the matrix
   */
  PreconditionerKind choose_preconditioner(double                          courant_number,
                                           dealii::types::global_dof_index n_dofs,
                                           unsigned int                    matrix_life_time);

  /**
   * The masked preconditioner for a M + b A in contact coordinates. @param kind neither automatic
   * nor multigrid
   */
  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_preconditioner(PreconditionerKind             kind,
                      const ElasticMatrices<dim>    &matrices,
                      const ContactCoordinates<dim> &coordinates,
                      const MatrixSum               &sum);

  /**
   * The masked preconditioner for A in contact coordinates, of a static problem. `automatic` is
   * geometric multigrid in double precision: its number of iterations depends neither on the mesh
   * nor on how slender the bodies are, and it knows what contact holds. Where a body is 1e6 times
   * as stiff as another one it is algebraic multigrid, contact around it.
   * @param mass_factors see Multilevel
   */
  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_static_preconditioner(PreconditionerKind             kind,
                             const Discretization<dim>     &discretization,
                             const ContactCoordinates<dim> &coordinates,
                             const std::vector<double>     &mass_factors);

  /** Incomplete factor of the block-scalar mass. */
  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_mass_preconditioner(const ElasticMatrices<dim>    &matrices,
                           const ContactCoordinates<dim> &coordinates);
} // namespace signorini

#endif
