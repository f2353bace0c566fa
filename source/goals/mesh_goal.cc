// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/marking.h>
#include <signorini/base/spelling.h>
#include <signorini/goals/bodies_in_touch.h>
#include <signorini/goals/mesh_goal.h>
#include <signorini/goals/slow_approach.h>
#include <signorini/goals/weigh_waves.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Times the tolerance: the next step must not begin with this error. */
    constexpr double far_off = 2.;

    /** Times the target: an error that is told. */
    constexpr double missed = 1.5;

    /** Of the indicators of bodies that touch nothing: their vibration should not be lost. */
    constexpr double of_free_bodies = 1. / 4.;
  } // namespace


  template <int dim>
  MeshGoal<dim>::MeshGoal(const Mesh<dim>            &mesh,
                          const AdaptivityParameters &parameters,
                          const TimeIntegration      &time)
    : mesh(mesh)
    , parameters(parameters)
    , starts_at_rest(time.starts_at_rest)
    , step_size(time.step_size)
    , masses(body_masses(mesh))
    , force_error(parameters.target_error, dim)
    , base_levels(mesh)
    , has_touched(mesh.bodies().size(), false)
  {
  }


  template <int dim>
  void MeshGoal<dim>::see(const Discretization<dim> &discretization,
                          const ContactSurface<dim> &surface,
                          const StepRecord          &step,
                          const std::vector<bool>   &in_contact,
                          const Stresses<dim>       &stresses,
                          dealii::Vector<double>    &indicator)
  {
    dealii::Vector<double> squares = indicator;
    squares.scale(indicator);
    // Steps that follow the motion may become longer, or short again.
    const double      step_length = std::max(step_size, step.step_size);
    const double      soon        = (parameters.longest_wait() + 1) * step_length;
    std::vector<bool> matters     = bodies_in_touch(discretization, surface, step.end, soon);
    awaits_contact = std::find(matters.begin(), matters.end(), true) != matters.end();
    const ContactZones<dim> zones(mesh, in_contact);
    bool                    lasts = false; // what contact has brought about
    for (unsigned int body = 0; body < matters.size(); ++body)
      {
        has_touched[body] = has_touched[body] || zones.touches(body);
        for (const auto &stress : stresses)
          if (has_touched[body] && stress->lasts_in(body))
            matters[body] = lasts = true;
      }
    in_flight           = !awaits_contact && !lasts && parameters.distance == 0.;
    unsigned int n_free = 0;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && !matters[cell->material_id()])
        {
          indicator(cell->active_cell_index()) *= of_free_bodies;
          ++n_free;
        }
    const double n_near = weigh_waves(mesh, zones, indicator);
    if (step.step_size > 0. || starts_at_rest)
      {
        ForceReading reading =
          force_reading(discretization, surface, step, indicator, parameters.maximum_level);
        if (reading.force > 0.)
          reading.of_approach =
            energy_of_slow_approach(discretization, surface, step.end, masses, reading.force);
        reading.n_near = n_near;
        reading.n_free = dealii::Utilities::MPI::sum(n_free, mesh.communicator());
        force_error.see(reading);
      }
    if (!stresses.empty() && force_error.has_seen_contact())
      add_stresses(step, zones, stresses, squares, indicator);
    // A contact that is about to end is not worth a finer body.
    const double tolerated = force_error.is_high() || lasts
                               ? std::pow(tolerance(), 2)
                               : std::numeric_limits<double>::infinity();
    base_levels.see(indicator, tolerated, matters);
  }


  template <int dim>
  void MeshGoal<dim>::add_stresses(const StepRecord             &step,
                                   const ContactZones<dim>      &zones,
                                   const Stresses<dim>          &stresses,
                                   const dealii::Vector<double> &squares,
                                   dealii::Vector<double>       &indicator)
  {
    stress_errors.resize(stresses.size(), StressError<dim>(parameters.target_error));
    indicator /= force_error.tolerance();
    indicator.scale(indicator);
    for (unsigned int k = 0; k < stresses.size(); ++k)
      stress_errors[k].see(
        *stresses[k], mesh, step, zones, squares, parameters.maximum_level, indicator);
    for (double &value : indicator)
      value = std::sqrt(value);
  }


  template <int dim>
  AdaptivityParameters MeshGoal<dim>::marking() const
  {
    AdaptivityParameters now = parameters;
    now.marking              = MarkingKind::tolerance;
    now.tolerance            = tolerance();
    if (now.coarsen_ratio == 0.)
      now.coarsen_ratio = force_error.least_part_of_tolerance() * smooth_coarsen_ratio<dim>();
    return now;
  }


  template <int dim>
  bool MeshGoal<dim>::is_far_off(const MeshChange &change) const
  {
    return change.refines() && change.estimate > far_off * tolerance();
  }


  template <int dim>
  std::string MeshGoal<dim>::summary() const
  {
    std::ostringstream text;
    text << force_error.summary();
    text.precision(2);
    const double of_force = force_error.relative_error();
    double       largest  = of_force;
    for (const StressError<dim> &stress : stress_errors)
      {
        text << "  error of stress   ";
        if (!stress.has_seen_stress())
          {
            text << "none of " << stress.name() << ", as there was none\n";
            continue;
          }
        const double error = std::hypot(stress.relative_error(), of_force);
        largest            = std::max(largest, error);
        text << about_per_cent(error) << " of " << stress.name()
             << " by the mesh (estimated; L2 in time)\n";
      }
    if (largest > missed * parameters.target_error)
      text << "                    the target was " << 100. * parameters.target_error
           << " %: give a larger `Adaptivity/Maximum level` or `Maximum cells`, or finer "
              "bodies to begin with\n";
    return text.str();
  }


  template class MeshGoal<2>;
  template class MeshGoal<3>;
} // namespace signorini
