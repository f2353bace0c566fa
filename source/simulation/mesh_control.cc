// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/base/user_error.h>
#include <signorini/simulation/mesh_control.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** Of a step that is far off. */
    constexpr unsigned int most_attempts = 8;
  } // namespace


  template <int dim>
  MeshControl<dim>::MeshControl(Mesh<dim>             &mesh,
                                const Scene<dim>      &scene,
                                const TimeIntegration &time)
    : mesh(mesh)
    , scene(scene)
    , parameters(scene.adaptivity)
    , time(time)
    , rule(parameters)
    , life_time(scene.time.n_steps()) // of a mesh that does not change
  {
    if (parameters.has_target())
      goal.emplace(mesh, parameters, time);
  }


  template <int dim>
  void MeshControl<dim>::check_first_mesh() const
  {
    const unsigned int most    = parameters.maximum_cells;
    const auto         n_cells = mesh.triangulation().n_global_active_cells();
    if (any() && most > 0 && n_cells > most)
      throw UserError("Adaptivity/Maximum cells = " + std::to_string(most)
                      + " is less than what the run begins with, " + std::to_string(n_cells)
                      + " cells. Give a larger number, or reduce `Refinements` of the bodies.");
  }


  template <int dim>
  MeshChange MeshControl<dim>::judge(const MeshedScene<dim> &meshed, const StepRecord &step)
  {
    if (!indicator)
      indicator = make_error_indicator(
        parameters, time, meshed.discretization, meshed.surface, meshed.dirichlet);
    if (goal && stresses.empty())
      stresses = stresses_of_interest(
        parameters.goal, scene.probes, scene.point_probes, meshed.discretization, meshed.surface);
    latest = indicator->evaluate(step);
    const std::vector<bool> in_contact =
      cells_in_contact(meshed.discretization, meshed.surface, step.end.contact_force);
    if (goal)
      goal->see(meshed.discretization, meshed.surface, step, in_contact, stresses, latest);
    const bool          is_unseen = look_between_nodes(meshed, step.end);
    const ContactWishes wishes    = contact_wishes(meshed, step, in_contact);
    MeshChange          change    = mark_cells(
      mesh, goal ? goal->marking() : parameters, latest, wishes.to_keep, wishes.to_refine);
    is_far_off       = goal && (is_unseen || goal->is_far_off(change));
    change.is_urgent = change.is_urgent || is_far_off;
    if (rule.pays(change, step.end.step, goal ? goal->longest_wait() : parameters.longest_wait()))
      return change;
    clear_flags(mesh);
    return MeshChange();
  }


  template <int dim>
  bool MeshControl<dim>::repeats_step(const MeshChange &change, const unsigned int repetition) const
  {
    return change.refines() && repetition < (is_far_off ? most_attempts : parameters.repetitions);
  }


  template <int dim>
  bool MeshControl<dim>::look_between_nodes(const MeshedScene<dim> &meshed, const State &state)
  {
    if (!goal)
      return false;
    if (!unseen_contact)
      unseen_contact.emplace(meshed.discretization, meshed.surface);
    between_nodes = unseen_contact->find(state.displacement, state.contact_force, state.time).cells;
    bool any      = false;
    for (const auto &cell : mesh.active_cells())
      {
        const unsigned int i = cell->active_cell_index();
        between_nodes[i] =
          between_nodes[i] && cell->level() < static_cast<int>(parameters.maximum_level);
        any = any || between_nodes[i];
      }
    return dealii::Utilities::MPI::logical_or(any, mesh.communicator());
  }


  template <int dim>
  typename MeshControl<dim>::ContactWishes
  MeshControl<dim>::contact_wishes(const MeshedScene<dim>  &meshed,
                                   const StepRecord        &step,
                                   const std::vector<bool> &in_contact) const
  {
    ContactWishes wishes{in_contact, std::vector<bool>(in_contact.size(), false)};
    if (goal)
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned())
          {
            const unsigned int i    = cell->active_cell_index();
            const unsigned int body = cell->material_id(), level = cell->level();
            wishes.to_keep[i]   = wishes.to_keep[i] || goal->keeps(body, level);
            wishes.to_refine[i] = goal->refines(body, level) || between_nodes[i];
          }
    ContactAhead ahead{parameters.distance,
                       std::vector<unsigned int>(mesh.bodies().size(), parameters.maximum_level)};
    if (goal && parameters.distance == 0.)
      ahead = contact_ahead(mesh, in_contact);
    AdaptivityParameters closer_than = parameters;
    closer_than.distance             = ahead.distance;
    if (!closer_than.refines_contact())
      return wishes;
    // An estimate sees contact when it is there; nodes that come into contact on coarse cells
    // would give a blow.
    const auto closeness =
      DistanceIndicator<dim>(
        meshed.discretization, meshed.surface, closer_than, time.step_size, ahead.least_closeness())
        .evaluate(step);
    // What lacks one level is judged as it is, what lacks more sooner.
    const auto coarse_and_close = [&](const auto &cell) {
      const unsigned int lacking = ahead.lacking(cell);
      return lacking == 0 ? 0. : ahead.weigh(closeness(cell->active_cell_index()), lacking - 1);
    };
    unsigned int n_too_close = 0, n_close = 0;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          n_too_close += coarse_and_close(cell) >= DistanceIndicator<dim>::too_close;
          n_close += coarse_and_close(cell) >= ahead.far_enough;
        }
    const double threshold =
      close_enough_to_refine(ahead.far_enough,
                             dealii::Utilities::MPI::sum(n_too_close, mesh.communicator()),
                             dealii::Utilities::MPI::sum(n_close, mesh.communicator()));
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          const unsigned int i = cell->active_cell_index();
          wishes.to_keep[i] =
            wishes.to_keep[i] || ahead.weigh(closeness(i), ahead.lacking(cell)) >= ahead.far_enough;
          wishes.to_refine[i] = wishes.to_refine[i] || coarse_and_close(cell) >= threshold;
        }
    return wishes;
  }


  template <int dim>
  double MeshControl<dim>::close_enough_to_refine(const double       far_enough,
                                                  const unsigned int n_too_close,
                                                  const unsigned int n_close) const
  {
    return n_too_close > 0 && n_close <= room_to_refine(mesh, parameters)
             ? far_enough
             : DistanceIndicator<dim>::too_close;
  }


  template <int dim>
  std::string MeshControl<dim>::summary() const
  {
    return goal ? goal->summary() : "";
  }


  template <int dim>
  void MeshControl<dim>::mesh_changes(const unsigned int step)
  {
    life_time   = std::max(parameters.steps_between, step - last_change);
    last_change = step;
    rule.mesh_changes(step);
    mesh_is_made_anew();
  }


  template <int dim>
  void MeshControl<dim>::mesh_is_made_anew()
  {
    indicator.reset();
    unseen_contact.reset();
    stresses.clear();
    latest.reinit(0);
  }


  template class MeshControl<2>;
  template class MeshControl<3>;
} // namespace signorini
