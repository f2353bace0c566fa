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
   * Whether the cycle of geometric multigrid has to compute in double precision for a step of this
   * size: where it is very long, mass is next to nothing, and rotations are nearly free; and where
   * a body carries another one that is so much stiffer in the step that single precision hides its
   * own stiffness. Collective.
   */
  template <int dim>
  bool needs_double_precision(const Discretization<dim> &discretization, double step_size);


  /** What decides about the preconditioner of a step. */
  struct StepCost
  {
    double                          courant_number;        ///< c_p tau / h
    dealii::types::global_dof_index n_dofs;                ///< on all processes
    unsigned int                    matrix_life_time = 1;  ///< steps that will use the matrix
    double                          stiffness_ratio  = 1.; ///< of the stiffest node and the softest
    /** Whether active sets solve the step, and sweeps know its matrix: see RoughSolver. */
    bool solves_roughly = false;
    /** With sweeps so far, per active set; 0: not known yet. */
    double iterations    = 0.;
    bool   with_friction = false;
    double grading       = 0.; ///< Mesh::grading()
    /** Mesh::effective_courant_number(); 0: that above. */
    double effective_courant_number = 0.;
  };

  /** Of the stiffest node and the softest. Collective. */
  template <int dim>
  double ratio_of_stiffness(const ElasticMatrices<dim> &matrices);

  /**
   * What `automatic` means, by measurement (doc/performance.md): sweeps of Gauss and Seidel where
   * they solve by themselves, geometric multigrid where they take too many iterations, or will.
   * Else the diagonal where the step is so small that the mass rules or the matrix will soon be
   * another one, multigrid where the stiffness rules, the incomplete factor in between.
   */
  PreconditionerKind choose_preconditioner(const StepCost &cost);

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
