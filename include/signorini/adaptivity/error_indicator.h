// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_error_indicator_h
#define signorini_adaptivity_error_indicator_h

#include <signorini/contact/contact_surface.h>
#include <signorini/model/adaptivity_parameters.h>
#include <signorini/time/time_scheme.h>

namespace signorini
{
  /** What an estimate of the error of a step has to know of the time integration. */
  struct TimeIntegration
  {
    StepBalance balance        = StepBalance::middle; ///< of the forces of a step
    double      step_size      = 0.;                  ///< of the first step
    bool        starts_at_rest = false;               ///< in equilibrium with its contact forces
  };

  /**
   * A step that was just made, both states on the present mesh. Before the first step both are the
   * initial one and the step size is 0.
   */
  struct StepRecord
  {
    const State &start;
    const State &end; ///< its contact_force holds the nodal forces of the step
    double       step_size;
    /** Of the scheme: its elastic forces are those of the mean displacement + this (u_new - u). */
    double stiffness_damping = 0.;
  };

  /**
   * Tells where the mesh is too coarse, or finer than needed. Refers to one mesh: build another
   * one when the mesh has changed.
   */
  template <int dim>
  class ErrorIndicator
  {
  public:
    virtual ~ErrorIndicator() = default;

    /**
     * eta_T >= 0 per active cell of this process, by active_cell_index; zero for cells of others.
     * Collective. The root of the sum of squares over all processes is the estimate of the whole
     * mesh; all zero means that there is nothing to be seen but round-off.
     */
    virtual dealii::Vector<double> evaluate(const StepRecord &step) const = 0;
  };

  /** The indicator that is asked for; null for none. What is of a mesh must outlive it. */
  template <int dim>
  std::unique_ptr<ErrorIndicator<dim>>
  make_error_indicator(const AdaptivityParameters     &parameters,
                       const TimeIntegration          &time,
                       const Discretization<dim>      &discretization,
                       const ContactSurface<dim>      &surface,
                       const DirichletConditions<dim> &dirichlet);

  /**
   * Put indicators to zero if all of them together are round-off compared with the energy of the
   * motion. Collective.
   */
  void remove_round_off(const State &state, dealii::Vector<double> &indicator);
} // namespace signorini

#endif
