// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_mesh_goal_h
#define signorini_goals_mesh_goal_h

#include <signorini/adaptivity/error_indicator.h>
#include <signorini/adaptivity/mark_cells.h>
#include <signorini/goals/base_levels.h>
#include <signorini/goals/force_error.h>
#include <signorini/goals/stress_error.h>

namespace signorini
{
  /**
   * A `Goal` with a `Target error`: the mesh is as fine as that needs, where it needs it. Of the
   * contact force in any case, and of stresses if the goal is one: they follow from what the force
   * is, and from the cells near their place. Weighs the indicators of a step by what the goal feels
   * of them, says what is tolerated, which cells have to be finer whatever their indicator is, and
   * whether a step has to be repeated.
   */
  template <int dim>
  class MeshGoal
  {
  public:
    MeshGoal(const Mesh<dim>            &mesh,
             const AdaptivityParameters &parameters,
             const TimeIntegration      &time);

    /**
     * A step is judged. Collective.
     * @param in_contact cells of this process by active_cell_index
     * @param stresses   the same ones each time, on the present mesh; none if the goal is the force
     * @param indicator  at rest (ResidualIndicator with this goal), becomes the weighed one
     */
    void see(const Discretization<dim> &discretization,
             const ContactSurface<dim> &surface,
             const StepRecord          &step,
             const std::vector<bool>   &in_contact,
             const Stresses<dim>       &stresses,
             dealii::Vector<double>    &indicator);

    /** For mark_cells() after the step that was seen. */
    AdaptivityParameters marking() const;

    /** Whether cells of this level have to be refined, whatever their indicators are. */
    bool refines(const unsigned int body, const unsigned int level) const
    {
      return level < base_levels[body];
    }

    /** Whether they must not be coarsened. Before the first contact nothing is known. */
    bool keeps(const unsigned int body, const unsigned int level) const
    {
      return !force_error.has_seen_contact() || level <= base_levels[body];
    }

    /** Whether the step that was seen is so far from the target that it should be repeated. */
    bool is_far_off(const MeshChange &change) const;

    /**
     * Whether the next step has to be judged: there is contact to come, or a force that rises. What
     * begins on cells that are too coarse is not mended later.
     */
    bool is_expectant() const { return awaits_contact && !force_error.is_settled(); }

    /**
     * Whether nothing that the goal asks for happens: nothing touched anything in the step that was
     * seen, nor seemed to be about to, and no stress is left. (With a given `Distance` cells are
     * refined before they touch, so that flights are looked at as closely as contact.) The first
     * step with contact has to be judged then.
     */
    bool is_in_flight() const { return in_flight; }

    /** Steps until the mesh is judged again, at most: longer in flight, which contact ends. */
    unsigned int longest_wait() const { return in_flight ? 15 : parameters.longest_wait(); }

    /** For the end of the run: entries of the summary. */
    std::string summary() const;

    void archive(Archive &archive)
    {
      force_error.archive(archive);
      base_levels.archive(archive);
      std::size_t n_stresses = stress_errors.size();
      archive(awaits_contact, in_flight, has_touched, n_stresses);
      stress_errors.resize(n_stresses, StressError<dim>(parameters.target_error));
      for (StressError<dim> &error : stress_errors)
        error.archive(archive);
    }

  private:
    const Mesh<dim>              &mesh;
    const AdaptivityParameters    parameters;
    const bool                    starts_at_rest;
    const double                  step_size; ///< the first one
    const std::vector<double>     masses;    ///< of bodies
    ForceError                    force_error;
    BaseLevels<dim>               base_levels;
    bool                          awaits_contact = true; ///< or has it
    bool                          in_flight      = false;
    std::vector<char>             has_touched; ///< bodies, so far
    std::vector<StressError<dim>> stress_errors;

    /** Of the indicators of the step that was seen, for mark_cells(). */
    double tolerance() const { return stress_errors.empty() ? force_error.tolerance() : 1.; }

    /** Indicators in units of what they may amount to together: of the force and all stresses. */
    void add_stresses(const StepRecord             &step,
                      const ContactZones<dim>      &zones,
                      const Stresses<dim>          &stresses,
                      const dealii::Vector<double> &squares,
                      dealii::Vector<double>       &indicator);
  };
} // namespace signorini

#endif
