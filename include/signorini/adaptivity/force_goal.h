// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_force_goal_h
#define signorini_adaptivity_force_goal_h

#include <signorini/adaptivity/base_levels.h>
#include <signorini/adaptivity/error_indicator.h>
#include <signorini/adaptivity/force_error.h>
#include <signorini/adaptivity/mark_cells.h>

namespace signorini
{
  /**
   * `Goal = contact force`: the mesh is as fine as the target for the error of the contact force
   * needs, where it needs it. Weighs the indicators of a step by what the force feels of them, says
   * what is tolerated, which cells have to be finer whatever their indicator is, and whether a step
   * has to be repeated.
   */
  template <int dim>
  class ForceGoal
  {
  public:
    ForceGoal(const Mesh<dim>            &mesh,
              const AdaptivityParameters &parameters,
              const TimeIntegration      &time);

    /**
     * A step is judged. Collective.
     * @param in_contact cells of this process by active_cell_index
     * @param indicator  at rest (ResidualIndicator with this goal), becomes the weighed one
     */
    void see(const Discretization<dim> &discretization,
             const ContactSurface<dim> &surface,
             const StepRecord          &step,
             const std::vector<bool>   &in_contact,
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

    /** For the end of the run: entries of the summary. */
    std::string summary() const { return force_error.summary(); }

    void archive(Archive &archive)
    {
      force_error.archive(archive);
      base_levels.archive(archive);
      archive(awaits_contact);
    }

  private:
    const Mesh<dim>           &mesh;
    const AdaptivityParameters parameters;
    const bool                 starts_at_rest;
    const double               step_size; ///< the first one
    ForceError                 force_error;
    BaseLevels<dim>            base_levels;
    bool                       awaits_contact = true; ///< or has it
  };

  /** Up to which level cells are refined that are about to touch something. */
  struct ContactAhead
  {
    double                    distance; ///< what is closer is about to touch; 0: nothing
    std::vector<unsigned int> levels;   ///< of bodies
  };

  /**
   * Contact that grows meets cells as fine as the finest that are in contact. Collective.
   * @param in_contact cells of this process by active_cell_index
   */
  template <int dim>
  ContactAhead contact_ahead(const Mesh<dim> &mesh, const std::vector<bool> &in_contact);
} // namespace signorini

#endif
