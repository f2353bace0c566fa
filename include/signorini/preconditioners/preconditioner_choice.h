// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_preconditioner_choice_h
#define signorini_preconditioners_preconditioner_choice_h

#include <signorini/discretization/discretization.h>
#include <signorini/model/run_parameters.h>

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
    double iterations               = 0.;
    bool   with_friction            = false;
    double grading                  = 0.; ///< of the mesh
    double effective_courant_number = 0.; ///< of its cells
  };

  /** What the mesh and the step size decide of it. Collective. */
  template <int dim>
  StepCost cost_of_step(const Discretization<dim> &discretization, double step_size);

  /** Of the stiffest node and the softest. Collective. */
  template <int dim>
  double ratio_of_stiffness(const ElasticMatrices<dim> &matrices);

  /** Beyond it the coarse levels keep more of what is held than a soft body has. */
  constexpr double most_for_multigrid = 1e6;

  /**
   * What `automatic` means, by measurement (doc/performance.md): sweeps of Gauss and Seidel where
   * they solve by themselves, geometric multigrid where they take too many iterations, or will.
   * Else the diagonal where the step is so small that the mass rules or the matrix will soon be
   * another one, multigrid where the stiffness rules, the incomplete factor in between.
   */
  PreconditionerKind choose_preconditioner(const StepCost &cost);
} // namespace signorini

#endif
