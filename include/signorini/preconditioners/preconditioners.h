// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_preconditioners_h
#define signorini_preconditioners_preconditioners_h

#include <signorini/discretization/discretization.h>
#include <signorini/model/run_parameters.h>
#include <signorini/preconditioners/step_operator.h>
#include <signorini/sweeps/sweep_order.h>

#include <memory>

namespace signorini
{
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
   * geometric multigrid: its number of iterations depends neither on the mesh nor on how slender
   * the bodies are, and it knows what contact holds. Where a body is 1e6 times as stiff as another
   * one it is algebraic multigrid, contact around it.
   * @param mass_factors        see Multilevel
   * @param in_double_precision of the geometric multigrid
   */
  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_static_preconditioner(PreconditionerKind             kind,
                             const Discretization<dim>     &discretization,
                             const ContactCoordinates<dim> &coordinates,
                             const std::vector<double>     &mass_factors,
                             bool                           in_double_precision);

  /** Sweeps with the block-scalar mass, or its incomplete factor where two bodies meet. */
  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_mass_preconditioner(const ElasticMatrices<dim>    &matrices,
                           const ContactCoordinates<dim> &coordinates);

  /** Sweeps over the nodes of an order; at others corrections are zero. Where no bodies meet. */
  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_mass_preconditioner(const ElasticMatrices<dim>    &matrices,
                           const ContactCoordinates<dim> &coordinates,
                           SweepOrder                     order);
} // namespace signorini

#endif
