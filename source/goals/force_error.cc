// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/base/spelling.h>
#include <signorini/base/sum_of_magnitudes.h>
#include <signorini/contact/own_forces.h>
#include <signorini/goals/force_error.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Its square can be computed. */
    constexpr double beyond_bounds = 1e150;

    /** Of relative errors. */
    constexpr double most_credible = 0.3;
    /** Elastic energy before contact that is worth a line, as part of the largest one. */
    constexpr double noticed_before_contact = 1e-3;

    double elastic_energy(const State &state)
    {
      return 0.5 * (state.displacement * state.internal_force);
    }

    /** As round-off does at a body that rests without load: that is no contact yet. */
    bool hardly_presses(const double force, const State &state, const double size)
    {
      const double energy = 0.5 * (state.velocity * state.momentum) + elastic_energy(state);
      return force <= unnoticed_force * energy / size;
    }
  } // namespace


  template <int dim>
  ForceReading force_reading(const Discretization<dim>    &discretization,
                             const ContactSurface<dim>    &surface,
                             const StepRecord             &step,
                             const dealii::Vector<double> &indicator,
                             const unsigned int            maximum_level)
  {
    const double size  = discretization.mesh().body_size();
    const auto  &cells = discretization.mesh().triangulation();
    ForceReading reading;
    reading.time           = step.end.time;
    reading.step_size      = step.step_size;
    reading.elastic_energy = elastic_energy(step.end);
    if (step.start.velocity.linfty_norm() > 0.
        && hardly_presses(sum_of_magnitudes(step.start.contact_force, dim), step.start, size))
      reading.energy_before_contact = elastic_energy(step.start);
    const Vector own = own_forces(surface, step.end.contact_force);
    for (const ContactNode<dim> &node : surface.nodes())
      reading.force += node.transmission * std::abs(node.normal_force(own));
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        {
          const double square = std::pow(indicator(cell->active_cell_index()), 2);
          reading.squared_error += square;
          if (static_cast<unsigned int>(cell->level()) >= maximum_level)
            reading.at_limit += square;
          reading.of_uniform_mesh += std::exp2(2 * cell->level()) * square;
        }
    for (double *sum :
         {&reading.force, &reading.squared_error, &reading.at_limit, &reading.of_uniform_mesh})
      *sum = dealii::Utilities::MPI::sum(*sum, discretization.communicator());
    if (hardly_presses(reading.force, step.end, size))
      reading.force = 0.;
    reading.n_cells    = cells.n_global_active_cells();
    reading.n_coarsest = cells.n_cells(0);
    return reading;
  }


  double ForceReading::expected_force() const
  {
    return elastic_energy > 0. ? force * std::min(2., std::sqrt(1. + of_approach / elastic_energy))
                               : force;
  }


  ForceError::ForceError(const double target, const unsigned int dim)
    : target(target)
    , dim(dim)
  {
  }


  void ForceError::see(const ForceReading &reading)
  {
    if (history.begin(reading.time, reading.time))
      {
        previous_force    = latest.force;
        n_contacts_before = n_contacts;
      }
    n_contacts = n_contacts_before + (reading.force > 0. && previous_force <= 0. ? 1 : 0);
    if (n_contacts_before == 0)
      energy_before_contact = std::max(energy_before_contact, reading.energy_before_contact);
    if (n_contacts > 0)
      largest_energy = std::max(largest_energy, reading.elastic_energy);
    if (latest.force <= 0.)
      tolerances.clear();
    latest        = reading;
    largest_force = std::max(largest_force, reading.force);
    if (reading.force <= 0. || reading.elastic_energy <= 0.)
      return;
    const double force_per_error = reading.force / (effectivity(dim) * 2. * reading.elastic_energy);
    Sums        &sums            = history.sums;
    // What ends a flight is judged at once, and the flight had no error.
    const double interval = previous_force > 0. || reading.step_size == 0.
                              ? history.length()
                              : std::min(history.length(), reading.step_size);
    sums.force += interval * std::pow(reading.force, 2);
    sums.error += interval * std::pow(force_per_error * reading.squared_error, 2);
    sums.of_uniform_mesh += interval * std::pow(force_per_error * reading.of_uniform_mesh, 2);
    sums.time += interval;
    sums.cells += interval * reading.n_cells;
    sums.near += interval * reading.n_near;
    sums.free += interval * reading.n_free;
    sums.n_coarsest   = reading.n_coarsest;
    largest_tolerance = std::max(largest_tolerance, tolerance());
    tolerances.push_back({reading.time, tolerance()});
  }


  double ForceError::tolerance() const
  {
    if (latest.force <= 0. || latest.elastic_energy <= 0.)
      return largest_tolerance > 0. ? largest_tolerance : beyond_bounds;
    const double of_target = target * effectivity(dim) * 2. * latest.elastic_energy
                             * std::max(largest_force, latest.expected_force()) / latest.force;
    return std::sqrt(std::max(of_target, 2. * latest.at_limit));
  }


  double ForceError::least_part_of_tolerance() const
  {
    if (latest.force <= 0. || tolerances.empty())
      return 1.;
    constexpr double least     = 1. / 16.;
    constexpr double forgotten = 1. / 4.; // of the time in contact
    const double     began     = tolerances.front().time;
    const double     since     = began + forgotten * (latest.time - began);
    double           smallest  = tolerance();
    for (const Tolerance &one : tolerances)
      if (one.time >= since)
        smallest = std::min(smallest, one.value);
    return std::max(least, std::pow(smallest / tolerance(), 2));
  }


  double ForceError::relative_error() const
  {
    return history.sums.force > 0. ? std::sqrt(history.sums.error / history.sums.force) : 0.;
  }


  double ForceError::uniform_level() const
  {
    // Squared errors of linear elements are divided by 4 from level to level.
    return history.sums.error > 0. ? std::max(
             0., 0.5 * std::log2(std::sqrt(history.sums.of_uniform_mesh / history.sums.error)))
                                   : 0.;
  }


  double ForceError::uniform_cells() const
  {
    return history.sums.n_coarsest * std::exp2(dim * uniform_level());
  }


  double ForceError::mean_cells() const
  {
    return history.sums.time > 0. ? history.sums.cells / history.sums.time : 0.;
  }


  std::string ForceError::summary() const
  {
    if (history.sums.force == 0.)
      return "  error of force    none, as there was no contact\n";
    const auto percent = [this](const double number) {
      return std::lround(100. * number / history.sums.cells);
    };
    std::ostringstream text;
    text.precision(2);
    text << "  error of force    " << about_per_cent(relative_error())
         << " by the mesh (estimated; L2 in time)\n                    a uniform mesh of level "
         << uniform_level() << " would have it with " << uniform_cells() / mean_cells()
         << " times the cells\n                    cells in contact: " << percent(history.sums.near)
         << " % near it, " << percent(history.sums.cells - history.sums.near - history.sums.free)
         << " % for waves, " << percent(history.sums.free) << " % in bodies that touch nothing\n";
    if (energy_before_contact > noticed_before_contact * largest_energy)
      text
        << "                    without what the mesh did to vibrations before contact, which had "
        << 100. * energy_before_contact / largest_energy << " % of the elastic energy\n";
    if (n_contacts > 1)
      text << "                    of each of " << n_contacts
           << " contacts alone: what was wrong with earlier ones makes later ones wrong, too\n";
    if (relative_error() > most_credible)
      text << "                    that is no more than a sign of a mesh that is much too coarse\n";
    return text.str();
  }


  template ForceReading force_reading(const Discretization<2> &,
                                      const ContactSurface<2> &,
                                      const StepRecord &,
                                      const dealii::Vector<double> &,
                                      unsigned int);
  template ForceReading force_reading(const Discretization<3> &,
                                      const ContactSurface<3> &,
                                      const StepRecord &,
                                      const dealii::Vector<double> &,
                                      unsigned int);
} // namespace signorini
