// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/bodies_in_touch.h>
#include <signorini/adaptivity/force_goal.h>
#include <signorini/adaptivity/marking.h>
#include <signorini/adaptivity/weigh_waves.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** Times the tolerance: the next step must not begin with this error. */
    constexpr double far_off = 2.;

    /** Of the finest cell in contact: what is closer is about to touch. */
    constexpr double near = 0.25;

    /** Of the indicators of bodies that touch nothing: their vibration should not be lost. */
    constexpr double of_free_bodies = 1. / 4.;
  } // namespace


  template <int dim>
  ForceGoal<dim>::ForceGoal(const Mesh<dim>            &mesh,
                            const AdaptivityParameters &parameters,
                            const TimeIntegration      &time)
    : mesh(mesh)
    , parameters(parameters)
    , starts_at_rest(time.starts_at_rest)
    , step_size(time.step_size)
    , force_error(parameters.target_error, dim)
    , base_levels(mesh)
  {
  }


  template <int dim>
  void ForceGoal<dim>::see(const Discretization<dim> &discretization,
                           const ContactSurface<dim> &surface,
                           const StepRecord          &step,
                           const std::vector<bool>   &in_contact,
                           dealii::Vector<double>    &indicator)
  {
    const double            soon    = (parameters.longest_wait() + 1) * step_size;
    const std::vector<bool> matters = bodies_in_touch(discretization, surface, step.end, soon);
    awaits_contact      = std::find(matters.begin(), matters.end(), true) != matters.end();
    unsigned int n_free = 0;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && !matters[cell->material_id()])
        {
          indicator(cell->active_cell_index()) *= of_free_bodies;
          ++n_free;
        }
    const double n_near = weigh_waves(discretization, in_contact, indicator);
    if (step.step_size > 0. || starts_at_rest)
      {
        ForceReading reading =
          force_reading(discretization, surface, step.end, indicator, parameters.maximum_level);
        reading.n_near = n_near;
        reading.n_free = dealii::Utilities::MPI::sum(n_free, mesh.communicator());
        force_error.see(reading);
      }
    // A contact that is about to end is not worth a finer body.
    const double tolerated = force_error.is_high() ? std::pow(force_error.tolerance(), 2)
                                                   : std::numeric_limits<double>::infinity();
    base_levels.see(indicator, tolerated, matters);
  }


  template <int dim>
  AdaptivityParameters ForceGoal<dim>::marking() const
  {
    AdaptivityParameters now = parameters;
    now.marking              = MarkingKind::tolerance;
    now.tolerance            = force_error.tolerance();
    if (now.coarsen_ratio == 0.)
      now.coarsen_ratio = force_error.least_part_of_tolerance() * smooth_coarsen_ratio<dim>();
    return now;
  }


  template <int dim>
  bool ForceGoal<dim>::is_far_off(const MeshChange &change) const
  {
    return change.refines() && change.estimate > far_off * force_error.tolerance();
  }


  template <int dim>
  ContactAhead contact_ahead(const Mesh<dim> &mesh, const std::vector<bool> &in_contact)
  {
    constexpr double          none = std::numeric_limits<double>::max();
    std::vector<unsigned int> finest(mesh.bodies().size(), 0);
    double                    size = none;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && in_contact[cell->active_cell_index()])
        {
          unsigned int &level = finest[cell->material_id()];
          level               = std::max(level, static_cast<unsigned int>(cell->level()));
          size                = std::min(size, cell->diameter() / std::sqrt(double(dim)));
        }
    dealii::Utilities::MPI::max(finest, mesh.communicator(), finest);
    size = dealii::Utilities::MPI::min(size, mesh.communicator());
    return {size < none ? near * size : 0., finest};
  }


#define INSTANTIATE(dim)                                                                           \
  template class ForceGoal<dim>;                                                                   \
  template ContactAhead contact_ahead(const Mesh<dim> &, const std::vector<bool> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
