// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/observation.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace signorini
{
  template <int dim>
  Observation<dim>::Observation(const Scene<dim> &scene, MeshedScene<dim> &meshed)
    : scene(scene)
    , meshed(&meshed)
    , probes(make_probes(scene, meshed))
    , history(scene.output_directory,
              scene.exact_solution.given,
              has_friction(scene.pairs),
              probes,
              meshed.discretization.communicator())
    , errors(scene.exact_solution)
    , velocity_zigzags(probes.size())
    , clock(meshed.discretization.communicator(), false)
  {
  }


  template <int dim>
  std::vector<Probe<dim>> Observation<dim>::make_probes(const Scene<dim>       &scene,
                                                        const MeshedScene<dim> &meshed)
  {
    std::vector<Probe<dim>> probes;
    for (const auto &description : scene.probes)
      probes.emplace_back(description, meshed.surface, meshed.discretization.communicator());
    return probes;
  }


  template <int dim>
  void Observation<dim>::start(const State &state)
  {
    ledger.open(state, meshed->load(state.time));
    largest_energy = energy_of_motion();
    fewest_cells   = most_cells =
      meshed->discretization.mesh().triangulation().n_global_active_cells();
    write(state, StepReport(), EnergyBooking());
  }


  template <int dim>
  void Observation<dim>::change_mesh(MeshedScene<dim> &new_meshed, const State &state)
  {
    meshed = &new_meshed;
    probes = make_probes(scene, *meshed);
    ledger.transfer(state, meshed->load(state.time));
    ++n_mesh_changes;
    const unsigned long cells =
      meshed->discretization.mesh().triangulation().n_global_active_cells();
    fewest_cells = std::min(fewest_cells, cells);
    most_cells   = std::max(most_cells, cells);
  }


  template <int dim>
  void Observation<dim>::observe(const State &state, const StepReport &report)
  {
    const EnergyBooking booking = ledger.book(state, report, meshed->load(state.time));
    if (!std::isfinite(ledger.current().total()))
      throw RunError("The energy at time " + std::to_string(state.time)
                     + " is not a finite number. Check the loads, velocities and material "
                       "constants of the scene.");
    largest_energy   = std::max(largest_energy, energy_of_motion());
    largest_residual = std::max(largest_residual, std::abs(booking.residual));
    write(state, report, booking);

    n_impulse_solves += report.impulse_iterations > 0;
    n_impulse_iterations += report.impulse_iterations;
    n_common_impulses += report.common_impulses;
    impulse += report.step_size * contact_now.normal_force;
    work_friction += booking.friction;
    transferred += booking.transfer;
    most_sticking       = std::max(most_sticking, contact_now.n_stick);
    most_slipping       = std::max(most_slipping, contact_now.n_slip);
    largest_penetration = std::max(largest_penetration, contact_now.max_penetration);
    deepest             = std::max(deepest, contact_now.geometric_penetration);
    farthest_sliding    = std::max(farthest_sliding, contact_now.sliding);
    largest_change = std::max(largest_change, ledger.current().total() - ledger.initial().total());
    force_variation.add(contact_now.normal_force);
    if (contact_now.n_active > 0)
      {
        if (first_contact < 0.)
          first_contact = state.time;
        last_contact = state.time;
      }
  }


  template <int dim>
  void Observation<dim>::write(const State         &state,
                               const StepReport    &report,
                               const EnergyBooking &booking)
  {
    const ProductCount products       = products_of_step();
    const auto        &discretization = meshed->discretization;
    contact_now                       = contact_summary(meshed->surface, discretization, state);
    if (scene.exact_solution.given)
      latest_errors = errors.evaluate(discretization, state, report.step_size);
    double standard_kinetic = ledger.current().kinetic;
    if (scene.time.mass.has_massless_contact_nodes())
      {
        Vector momentum = discretization.make_vector();
        discretization.matrices().apply_standard_mass(momentum, state.velocity);
        standard_kinetic = 0.5 * (state.velocity * momentum);
      }
    standard_change = standard_kinetic - ledger.current().kinetic + ledger.current().total()
                      - ledger.initial().total();
    const Momentum momentum_now = momentum(discretization, state);
    if (state.step == 0)
      initial_momentum = momentum_now;
    double drift_square = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      drift_square += std::pow(momentum_now.angular[c] - initial_momentum.angular[c], 2);
    const bool write_row = state.step % scene.output.history_every == 0;
    if (write_row)
      history.write({state,
                     discretization.mesh().triangulation().n_global_active_cells(),
                     discretization.dof_handler().n_dofs(),
                     ledger.current(),
                     standard_kinetic,
                     booking,
                     momentum_now,
                     std::sqrt(drift_square),
                     contact_now,
                     report,
                     products,
                     clock.wall_time(),
                     latest_errors});
    for (unsigned int p = 0; p < probes.size(); ++p)
      {
        const ProbeReading reading = probes[p].read(state);
        velocity_zigzags[p].add(reading.normal_velocity, reading.normal_force > 0.);
        if (write_row)
          history.write_probe(p, state.time, reading);
      }
    products_before = discretization.matrices().products();
  }


  template <int dim>
  ProductCount Observation<dim>::products_of_step() const
  {
    const ProductCount &now = meshed->discretization.matrices().products();
    return {now.stiffness - products_before.stiffness,
            now.mass - products_before.mass,
            now.combined - products_before.combined};
  }


  template <int dim>
  double Observation<dim>::relative_energy_change() const
  {
    const double scale = relative_scale();
    return scale > 0. ? (ledger.current().total() - ledger.initial().total()) / scale : 0.;
  }


  template <int dim>
  double Observation<dim>::relative_scale() const
  {
    // Bodies that start at rest bring hardly any energy of their own; then the largest energy of
    // the motion is the measure.
    const double initial = std::abs(ledger.initial().total());
    return initial > 1e-3 * largest_energy ? initial : largest_energy;
  }


  template <int dim>
  std::string Observation<dim>::warnings() const
  {
    std::ostringstream text;
    text << std::setprecision(4);
    const std::string &own_tolerance = scheme_info(scene.time.scheme).own_tolerance;
    if (largest_residual > 1e-6 * largest_energy)
      text << "  warning: a step changed the energy by " << largest_residual / largest_energy
           << " of it without an explanation. "
           << (own_tolerance.empty()
                 ? "The solver was not accurate enough, or the\n"
                   "           scheme is at fault: do not trust this run, and report it.\n"
                 : "Reduce `" + own_tolerance + "` or the step size.\n");
    if (deepest > 1e-2 * meshed->discretization.mesh().body_size())
      text << "  warning: by the true geometry a contact node was " << deepest
           << " deep in an obstacle. Contact is linearised about the\n"
           << "           initial configuration, with one obstacle per node: do not trust motion "
              "along a curved obstacle or in a corner.\n";
    if (farthest_sliding > 1.)
      text << "  warning: bodies in contact slid along each other by " << farthest_sliding
           << " times the size of a face. The faces that meet are\n"
           << "           chosen once, in the initial configuration: do not trust the places where "
              "forces act after that.\n";
    return text.str();
  }


  template <int dim>
  std::string Observation<dim>::summary() const
  {
    std::ostringstream text;
    text << std::setprecision(4) << "  energy            changed by "
         << 100. * relative_energy_change() << " % ("
         << (relative_scale() > 0. ? 100. * largest_change / relative_scale() : 0.)
         << " % at most); largest unexplained part of a step "
         << (largest_energy > 0. ? largest_residual / largest_energy : 0.) << " of the energy\n";
    if (n_mesh_changes > 0)
      text << "  mesh              changed " << n_mesh_changes << " times, between " << fewest_cells
           << " and " << most_cells << " cells; this changed the energy by "
           << (relative_scale() > 0. ? 100. * transferred / relative_scale() : 0.) << " %\n";
    if (scene.time.mass.has_massless_contact_nodes())
      text << "                    (with the mass of the scheme; with the consistent one it "
              "changed by "
           << (relative_scale() > 0. ? 100. * standard_change / relative_scale() : 0.) << " %)\n";
    if (first_contact >= 0.)
      text << "  contact           from " << first_contact << " to " << last_contact
           << ", largest force " << force_variation.largest() << ", impulse " << impulse << "\n"
           << "  oscillation       total variation of the force over twice its maximum: "
           << force_variation.measure() << "\n"
           << "  penetration       " << largest_penetration << " at most\n";
    else
      text << "  contact           none\n";
    if (has_friction(scene.pairs))
      text << "  friction          dissipated " << -work_friction + 0. << ", at most "
           << most_sticking << " nodes sticking, " << most_slipping
           << " slipping, largest accumulated slip " << contact_now.max_slip << "\n";
    if (n_impulse_solves > 0)
      text << "  impulses          of single nodes in " << n_impulse_solves << " steps, "
           << static_cast<double>(n_impulse_iterations) / n_impulse_solves << " iterations each\n";
    if (n_common_impulses > 0)
      text << "  warning: in " << n_common_impulses
           << " of these steps the equations of the single nodes were not solved; the common "
              "factor of\n"
           << "           `Time/Impulses = common` was taken instead. The energy is right, the "
              "share of each node is not.\n";
    text << warnings();
    for (unsigned int p = 0; p < probes.size(); ++p)
      text << "  probe " << probes[p].name() << " at (" << probes[p].position()
           << "): zigzag of the normal velocity in contact " << velocity_zigzags[p].amplitude()
           << "\n";
    if (scene.exact_solution.given)
      text << "  errors            displacement " << 100. * latest_errors.relative_displacement
           << " %, velocity " << 100. * latest_errors.relative_velocity
           << " % (relative, in space and time)\n";
    return text.str();
  }


  template class Observation<2>;
  template class Observation<3>;
} // namespace signorini
