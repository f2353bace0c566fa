// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/base/user_error.h>
#include <signorini/simulation/mesh_control.h>

namespace signorini
{
  template <int dim>
  MeshControl<dim>::MeshControl(Mesh<dim>                  &mesh,
                                const AdaptivityParameters &parameters,
                                const TimeIntegration      &time,
                                const unsigned int          n_steps)
    : mesh(mesh)
    , parameters(parameters)
    , time(time)
    , rule(parameters)
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
    const Discretization<dim> &discretization = meshed.discretization;
    if (!indicator)
      indicator =
        make_error_indicator(parameters, time, discretization, meshed.surface, meshed.dirichlet);
    latest = indicator->evaluate(step);

    std::vector<bool> to_keep =
                        cells_in_contact(discretization, meshed.surface, step.end.contact_force),
                      to_refine;
    if (parameters.refines_contact())
      {
        // An estimate sees contact when it is there; nodes that come into contact on coarse cells
        // would give a blow.
        const auto closeness =
          DistanceIndicator<dim>(discretization, meshed.surface, parameters, time.step_size)
            .evaluate(step);
        to_refine.resize(to_keep.size());
        for (unsigned int cell = 0; cell < to_keep.size(); ++cell)
          {
            to_keep[cell] = to_keep[cell] || closeness(cell) >= DistanceIndicator<dim>::far_enough;
            to_refine[cell] = closeness(cell) >= DistanceIndicator<dim>::too_close;
          }
      }
    const MeshChange change = mark_cells(mesh, parameters, latest, to_keep, to_refine);
    if (rule.pays(change, step.end.step))
      return change;
    clear_flags(mesh);
    return MeshChange();
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
