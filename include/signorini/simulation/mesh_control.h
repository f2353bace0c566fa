// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_mesh_control_h
#define signorini_simulation_mesh_control_h

#include <signorini/adaptivity/error_indicator.h>
#include <signorini/adaptivity/mark_cells.h>
#include <signorini/adaptivity/remeshing_rule.h>
#include <signorini/base/archive.h>
#include <signorini/contact/unseen_contact.h>
#include <signorini/goals/contact_ahead.h>
#include <signorini/goals/mesh_goal.h>
#include <signorini/simulation/meshed_scene.h>

namespace signorini
{
  /** Judges the mesh after each step by an indicator, and flags the cells that should change. */
  template <int dim>
  class MeshControl
  {
  public:
    /** Both have to live longer than it. */
    MeshControl(Mesh<dim> &mesh, const Scene<dim> &scene, const TimeIntegration &time);

    /** Whether the mesh may change at all. */
    bool any() const { return parameters.any(); }

    /** @throws UserError if the mesh that the run begins with has more cells than allowed */
    void check_first_mesh() const;

    /**
     * Flag cells by a step that was made on the present mesh; without any flag the mesh is good
     * enough. Collective.
     */
    MeshChange judge(const MeshedScene<dim> &meshed, const StepRecord &step);

    /**
     * Whether the mesh may have to be judged after a step. In flight that depends on what the step
     * brings, see is_due().
     */
    bool may_be_due(unsigned int step) const
    {
      return any()
             && (rule.is_due(step) || (goal && (goal->is_expectant() || goal->is_in_flight())));
    }

    /**
     * Whether it is to be judged after a step that may_be_due(), by the state at its end: the
     * indicator is evaluated only then. What ends a flight has not been expected. Collective.
     */
    bool is_due(const MeshedScene<dim> &meshed, const State &state)
    {
      return rule.is_due(state.step) || (goal && goal->is_expectant())
             || state.contact_force.linfty_norm() > 0. || look_between_nodes(meshed, state);
    }

    /**
     * Whether the step that was judged is to be repeated on the mesh that its change makes: as
     * often as the scene allows, and while it is far from what the mesh aims at.
     */
    bool repeats_step(const MeshChange &change, unsigned int repetition) const;

    /**
     * The mesh is going to change after a step. What is built on the next one is told to expect
     * the same life.
     */
    void mesh_changes(unsigned int step);

    /** The mesh is made anew as it is: nothing that was built on it is left. */
    void mesh_is_made_anew();

    /** When the mesh was judged and changed. */
    void archive(Archive &archive)
    {
      archive(life_time, last_change);
      rule.archive(archive);
      if (goal)
        goal->archive(archive);
    }

    /** Number of steps that will probably be made on the mesh that is built next. */
    unsigned int mesh_life_time() const { return life_time; }

    /** The latest indicators by active_cell_index; empty on a mesh that was not yet judged. */
    const dealii::Vector<double> &indicators() const { return latest; }

    /** Of the goal of the mesh, for the end of the run; empty if there is none. */
    std::string summary() const;

  private:
    Mesh<dim>                           &mesh;
    const Scene<dim>                    &scene;
    const AdaptivityParameters          &parameters;
    const TimeIntegration                time;
    RemeshingRule                        rule;
    std::optional<MeshGoal<dim>>         goal;     ///< if there is one
    Stresses<dim>                        stresses; ///< of the goal, on the present mesh
    unsigned int                         life_time;
    std::unique_ptr<ErrorIndicator<dim>> indicator; ///< of the present mesh
    dealii::Vector<double>               latest;
    unsigned int                         last_change = 0;     ///< after which step
    bool                                 is_far_off  = false; ///< the latest step from the goal
    std::optional<UnseenContact<dim>>    unseen_contact;      ///< on the present mesh
    std::vector<bool>                    between_nodes;       ///< cells with it, as last looked for

    /**
     * Find the cells that may be refined where something comes in between their nodes: what it does
     * before a node sees it stays. With a goal only. Collective. @return whether there are any
     */
    bool look_between_nodes(const MeshedScene<dim> &meshed, const State &state);

    /** Cells by what contact is, or is about to be. */
    struct ContactWishes
    {
      std::vector<bool> to_keep, to_refine;
    };
    ContactWishes contact_wishes(const MeshedScene<dim>  &meshed,
                                 const StepRecord        &step,
                                 const std::vector<bool> &in_contact) const;

    /**
     * From which value of the indicator of distance cells are refined. If one has to become finer,
     * so do all that soon will, if there is room for them: contact that travels would change the
     * mesh in every step.
     * @param far_enough see ContactAhead
     * @param n_too_close, n_close cells that are coarse, on all processes
     */
    double
    close_enough_to_refine(double far_enough, unsigned int n_too_close, unsigned int n_close) const;
  };
} // namespace signorini

#endif
