// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/simulation/mesh_control.h>

namespace signorini
{
  template <int dim>
  MeshChange MeshControl<dim>::judge(const MeshedScene<dim> &meshed, const StepRecord &step)
  {
    if (!indicator)
      indicator = make_error_indicator(discretization, meshed.surface, meshed.supports);
    latest         = indicator->evaluate(step);
    last_judgement = step.end.step;
    return mark_cells(discretization.triangulation,
                      discretization.scene,
                      latest,
                      cells_in_contact(discretization, meshed.surface, step.end.contact_force));
  }


  template <int dim>
  void MeshControl<dim>::mesh_changes(const unsigned int step)
  {
    discretization.mesh_life_time = std::max(discretization.scene.adaptivity.steps_between, step - last_change);
    last_change                   = step;
    indicator.reset();
    latest.reinit(0);
  }


  template class MeshControl<2>;
  template class MeshControl<3>;
} // namespace signorini
