// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_adaptivity_parameters_h
#define signorini_model_adaptivity_parameters_h

#include <signorini/base/enum_names.h>

namespace signorini
{
  /** What tells where the mesh is too coarse or too fine. */
  enum class IndicatorKind
  {
    none, ///< the mesh stays as it is
    residual,
    kelly,
    distance
  };

  template <>
  struct EnumNames<IndicatorKind>
  {
    static constexpr EnumName<IndicatorKind> table[] = {{IndicatorKind::none, "none"},
                                                        {IndicatorKind::residual, "residual"},
                                                        {IndicatorKind::kelly, "kelly"},
                                                        {IndicatorKind::distance, "distance"}};
  };

  /** What the mesh is made for. */
  enum class GoalKind
  {
    energy,           ///< the error of the motion in the energy norm, everywhere
    contact_force,    ///< the error of the sum of the contact forces
    contact_pressure, ///< and of their distribution over the contact surface
    probe             ///< and of the stress at all probes
  };

  template <>
  struct EnumNames<GoalKind>
  {
    static constexpr EnumName<GoalKind> table[] = {{GoalKind::energy, "energy"},
                                                   {GoalKind::contact_force, "contact force"},
                                                   {GoalKind::contact_pressure, "contact pressure"},
                                                   {GoalKind::probe, "probe"}};
  };

  /** Which cells an estimate of the error has changed; of no use with the indicator `distance`. */
  enum class MarkingKind
  {
    fixed_fraction,
    tolerance
  };

  template <>
  struct EnumNames<MarkingKind>
  {
    static constexpr EnumName<MarkingKind> table[] = {
      {MarkingKind::fixed_fraction, "fixed fraction"},
      {MarkingKind::tolerance, "tolerance"}};
  };

  /**
   * Section `Adaptivity`: how the mesh follows the motion. Levels count refinements of the coarse
   * mesh, as `Refinements` of a body does.
   */
  struct AdaptivityParameters
  {
    IndicatorKind indicator = IndicatorKind::none;
    GoalKind      goal      = GoalKind::energy;
    MarkingKind   marking   = MarkingKind::fixed_fraction;

    /**
     * Relative, of the goal, which is not the energy then: cells get equal shares of it. On a mesh
     * that stays it may be that of the steps, of the contact force.
     */
    double target_error = 0.;

    double refine_fraction  = 0.5;  ///< of the squared estimate, fixed fraction
    double coarsen_fraction = 0.02; ///< of the squared estimate, fixed fraction
    /** Of thresholds for squared indicators; 0: what smooth solutions allow. */
    double coarsen_ratio = 0.;
    double tolerance     = 0.; ///< root of an energy; below, nothing is refined. 0: none
    /** Part of the squared estimate or of the cells that is worth a change. */
    double       hysteresis    = 0.1;
    unsigned int maximum_level = 0; ///< cells of this level are not refined
    /** Cells of this level are not coarsened, nor those of the initial mesh. */
    unsigned int minimum_level = 0;
    unsigned int maximum_cells = 0; ///< about; 0: no limit
    unsigned int steps_between = 0; ///< the mesh may change after so many steps; 0: when it pays
    unsigned int repetitions   = 0; ///< of a step on a refined mesh, before it is accepted
    /** Of the indicator; 0: three times the size of each cell. Of others: see refines_contact(). */
    double distance = 0.;

    /** Steps until the mesh is judged again, at most, if it changes when that pays. */
    unsigned int longest_wait() const { return goal == GoalKind::energy ? 2 : 5; }

    /** Whether the mesh may change at all. */
    bool any() const { return indicator != IndicatorKind::none; }

    /** Whether cells matter by what they do to something else than the energy. */
    bool has_target() const { return any() && goal != GoalKind::energy; }

    /**
     * Whether cells closer to contact than `distance` are refined whatever the estimate of an
     * error says.
     */
    bool refines_contact() const
    {
      return any() && indicator != IndicatorKind::distance && distance > 0.;
    }
  };
} // namespace signorini

#endif
