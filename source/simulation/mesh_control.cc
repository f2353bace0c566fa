// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/bodies_in_touch.h>
#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/adaptivity/marking.h>
#include <signorini/adaptivity/weigh_waves.h>
#include <signorini/base/user_error.h>
#include <signorini/simulation/mesh_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** Times the tolerance: the next step must not begin with this error. */
    constexpr double far_off = 2.;

    /** Of the indicators of bodies that touch nothing: their vibration should not be lost. */
    constexpr double of_free_bodies = 1. / 4.;

    /** Of a step that is far off. */
    constexpr unsigned int most_attempts = 8;

    /**
     * For each body the level of its finest cells among those in contact, 0 if there are none.
     * Collective.
     * @param distance receives a quarter of the size of the finest of all; 0 if there are none
     */
    template <int dim>
    std::vector<unsigned int>
    finest_levels(const Mesh<dim> &mesh, const std::vector<bool> &in_contact, double &distance)
    {
      std::vector<unsigned int> levels(mesh.bodies().size(), 0);
      double                    smallest = std::numeric_limits<double>::max();
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned() && in_contact[cell->active_cell_index()])
          {
            unsigned int &level = levels[cell->material_id()];
            level               = std::max(level, static_cast<unsigned int>(cell->level()));
            smallest            = std::min(smallest, cell->diameter() / std::sqrt(double(dim)));
          }
      dealii::Utilities::MPI::max(levels, mesh.communicator(), levels);
      smallest = dealii::Utilities::MPI::min(smallest, mesh.communicator());
      distance = smallest < std::numeric_limits<double>::max() ? 0.25 * smallest : 0.;
      return levels;
    }
  } // namespace


  template <int dim>
  MeshControl<dim>::MeshControl(Mesh<dim>                  &mesh,
                                const AdaptivityParameters &parameters,
                                const TimeIntegration      &time,
                                const unsigned int          n_steps)
    : mesh(mesh)
    , parameters(parameters)
    , time(time)
    , rule(parameters)
    , force_error(parameters.target_error, dim)
    , base_levels(mesh)
    , life_time(n_steps)
  {
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
    AdaptivityParameters now = parameters;
    if (parameters.aims_at_force())
      {
        weigh_by_force(meshed, step);
        now.tolerance = force_error.tolerance();
        if (now.coarsen_ratio == 0.)
          now.coarsen_ratio = force_error.least_part_of_tolerance() * smooth_coarsen_ratio<dim>();
      }
    else
      latest = indicator->evaluate(step);
    const ContactWishes wishes = contact_wishes(meshed, step);
    MeshChange          change = mark_cells(mesh, now, latest, wishes.to_keep, wishes.to_refine);
    is_far_off =
      parameters.aims_at_force() && change.refines() && change.estimate > far_off * now.tolerance;
    change.is_urgent = change.is_urgent || is_far_off;
    if (rule.pays(change, step.end.step))
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
  void MeshControl<dim>::weigh_by_force(const MeshedScene<dim> &meshed, const StepRecord &step)
  {
    const std::vector<bool> matters =
      bodies_in_touch(meshed.discretization, meshed.surface, step.end);
    latest = indicator->evaluate(step);
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && !matters[cell->material_id()])
        latest(cell->active_cell_index()) *= of_free_bodies;
    weigh_waves(meshed.discretization,
                cells_in_contact(meshed.discretization, meshed.surface, step.end.contact_force),
                latest);
    if (step.step_size > 0. || time.starts_at_rest)
      force_error.see(force_reading(
        meshed.discretization, meshed.surface, step.end, latest, parameters.maximum_level));
    // A contact that is about to end is not worth a finer body.
    base_levels.see(latest,
                    force_error.is_high() ? std::pow(force_error.tolerance(), 2)
                                          : std::numeric_limits<double>::infinity(),
                    matters);
  }


  template <int dim>
  typename MeshControl<dim>::ContactWishes
  MeshControl<dim>::contact_wishes(const MeshedScene<dim> &meshed, const StepRecord &step) const
  {
    const Discretization<dim> &discretization = meshed.discretization;
    ContactWishes              wishes;
    wishes.to_keep = cells_in_contact(discretization, meshed.surface, step.end.contact_force);
    AdaptivityParameters      near = parameters;
    std::vector<unsigned int> finest(mesh.bodies().size(), parameters.maximum_level);
    if (parameters.aims_at_force())
      {
        if (parameters.distance == 0.)
          finest = finest_levels(mesh, wishes.to_keep, near.distance);
        wishes.to_refine.resize(wishes.to_keep.size());
        for (const auto &cell : mesh.active_cells())
          if (cell->is_locally_owned())
            {
              const unsigned int base = base_levels[cell->material_id()], level = cell->level();
              const unsigned int i = cell->active_cell_index();
              wishes.to_keep[i]    = wishes.to_keep[i] || level <= base;
              wishes.to_refine[i]  = level < base;
            }
      }
    if (!near.refines_contact())
      return wishes;
    // An estimate sees contact when it is there; nodes that come into contact on coarse cells
    // would give a blow.
    const auto closeness =
      DistanceIndicator<dim>(discretization, meshed.surface, near, time.step_size).evaluate(step);
    wishes.to_refine.resize(wishes.to_keep.size());
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          const unsigned int i    = cell->active_cell_index();
          const unsigned int body = cell->material_id(), level = cell->level();
          wishes.to_keep[i] =
            wishes.to_keep[i] || closeness(i) >= DistanceIndicator<dim>::far_enough;
          wishes.to_refine[i] =
            wishes.to_refine[i]
            || (closeness(i) >= DistanceIndicator<dim>::too_close && level < finest[body]);
        }
    return wishes;
  }


  template <int dim>
  std::string MeshControl<dim>::summary() const
  {
    return force_error.summary();
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
    latest.reinit(0);
  }


  template class MeshControl<2>;
  template class MeshControl<3>;
} // namespace signorini
