// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/finite_elements/largest_strains.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/observation.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace signorini
{
  namespace
  {
    template <typename Described>
    std::vector<std::string> names_of(const std::vector<Described> &descriptions)
    {
      std::vector<std::string> names;
      for (const Described &description : descriptions)
        names.push_back(description.name);
      return names;
    }

    /** Of the speed of the motion: what is slower is at rest. */
    constexpr double round_off_of_speed = 1e-6;

    std::string remedy_for_coarse_surfaces(const AdaptivityParameters &adaptivity)
    {
      if (adaptivity.any() && adaptivity.has_target())
        return "Allow finer cells there: `Adaptivity/Maximum level`, `Maximum cells`.";
      return "Refine the body there (`Refinements`), or let `Adaptivity/Target error` do it.";
    }
  } // namespace


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
    , ledger([this](const State &state) { return body_motion.elastic_energy(state); })
    , errors(scene.exact_solution)
    , run_summary({has_friction(scene.pairs),
                   scene.time.mass.has_massless_contact_nodes(),
                   scheme_info(scene.time.scheme).own_tolerance,
                   dim,
                   scheme_info(scene.time.scheme).inertia,
                   scheme_info(scene.time.scheme).energy == EnergyLaw::none,
                   force_before_end(scheme_info(scene.time.scheme), scene.time.parameters),
                   scene.adaptivity.target_error,
                   scene.step_sizes.control == StepSizeControl::goal,
                   scheme_info(scene.time.scheme).has_parameter("Spectral radius")})
    , law_watch(scene)
    , body_motion(meshed.discretization)
    , tables(scene, meshed.discretization.communicator())
    , validity(names_of(scene.bodies),
               names_of(scene.pairs),
               scene.motion == ContactMotion::follow,
               schemes_where([](const SchemeInfo &info) { return info.projects_velocity; }).front(),
               scene.how_to_follow)
    , missing_pairs(scene.bodies.size(), scene.obstacles, scene.pairs)
    , unseen_overlap(scene.pairs.size(), remedy_for_coarse_surfaces(scene.adaptivity))
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
    initial_momentum = momentum_of(state);
    unseen_overlap.use_mesh(meshed->discretization, meshed->surface);
    tables.use_mesh(*meshed, body_motion, state);
    law_watch.start(*meshed, body_motion, state);
    const HistoryRow row = evaluate(state, report_of_start(state), EnergyBooking());
    run_summary.start(row);
    write(row, true);
  }


  template <int dim>
  StepReport Observation<dim>::report_of_start(const State &state)
  {
    StepReport report;
    if (scene.time.start != StartKind::equilibrium)
      return report;
    Vector forces = state.internal_force;
    forces -= state.contact_force;
    if (const Vector *load = meshed->load(state.time))
      forces -= *load;
    report.support_force = dirichlet_part(meshed->system, forces);
    return report;
  }


  template <int dim>
  void Observation<dim>::change_mesh(MeshedScene<dim> &new_meshed, const State &state)
  {
    use(new_meshed, state);
    ledger.transfer(state, meshed->load(state.time));
    run_summary.change_mesh(meshed->discretization.mesh().triangulation().n_global_active_cells());
  }


  template <int dim>
  void Observation<dim>::use(MeshedScene<dim> &new_meshed, const State &state)
  {
    meshed      = &new_meshed;
    body_motion = BodyMotion<dim>(meshed->discretization);
    unseen_overlap.use_mesh(meshed->discretization, meshed->surface);
    alternation.forget();
    of_prescribed.forget();
    probes = make_probes(scene, *meshed);
    tables.use_mesh(*meshed, body_motion, state);
    law_watch.start(*meshed, body_motion, state);
  }


  template <int dim>
  void Observation<dim>::go_on(MeshedScene<dim> &new_meshed, const State &state)
  {
    use(new_meshed, state);
    ledger.go_on(state, meshed->load(state.time));
  }


  template <int dim>
  void Observation<dim>::archive(Archive &archive)
  {
    history.archive(archive);
    tables.archive(archive);
    ledger.archive(archive);
    errors.archive(archive);
    run_summary.archive(archive);
    validity.archive(archive);
    missing_pairs.archive(archive);
    unseen_overlap.archive(archive);
    alternation.archive(archive);
    of_prescribed.archive(archive);
    law_watch.archive(archive);
    turning_normals.archive(archive, meshed->discretization.communicator());
    double time = earlier_time + clock.wall_time();
    archive(initial_momentum, strains, energy_of_strains, velocity_zigzags, products_before, time);
    if (archive.reads())
      earlier_time = time;
  }


  template <int dim>
  std::vector<std::string>
  Observation<dim>::observe(const State &state, const StepReport &report, const bool is_last)
  {
    // Obstacles are where the latest step that was tried has put them.
    meshed->surface.move_obstacles(std::max(0., state.time - report.step_size), state.time);
    const EnergyBooking booking = ledger.book(state, report, meshed->load(state.time));
    if (!std::isfinite(ledger.current().total()))
      throw RunError("The energy at time " + std::to_string(state.time)
                     + " is not a finite number. Check the loads, velocities and material "
                       "constants of the scene.");
    const HistoryRow row = evaluate(state, report, booking);
    run_summary.add(row);
    broken =
      law_watch.judge(law_watch.read(state, report, booking, contact_now, run_summary.scale()));
    write(row, is_last || !broken.empty());
    std::vector<std::string> news = validity.judge(validity_reading(state));
    for (const std::string &overlap :
         missing_pairs.judge(meshed->discretization, state.displacement, state.time, is_last))
      news.push_back(overlap);
    for (const std::string &overlap : unseen_overlap.judge(state, is_last))
      news.push_back(overlap);
    return news;
  }


  template <int dim>
  ValidityReading Observation<dim>::validity_reading(const State &state)
  {
    const auto     &discretization = meshed->discretization;
    ValidityReading reading;
    reading.time     = state.time;
    reading.rotation = body_motion.rotation(state.displacement);
    reading.sliding  = contact_now.slidings;
    for (unsigned int body = 0; body < scene.bodies.size(); ++body)
      reading.depth.push_back(contact_now.depths[body] / discretization.mesh().body_size(body));
    // All cells are visited only when the strain may have grown by a tenth.
    if (const double elastic = ledger.current().elastic; elastic > 1.2 * energy_of_strains)
      {
        strains           = largest_strains(discretization, state.displacement);
        energy_of_strains = elastic;
      }
    reading.strain = strains;
    const double typical_speed =
      std::sqrt(2. * run_summary.largest_energy_of_motion() / body_motion.mass());
    reading.alternation = alternation.add(normal_velocities(meshed->surface, state.velocity),
                                          typical_speed,
                                          scene.bodies.size(),
                                          discretization.communicator());
    if (meshed->dirichlet.any())
      reading.prescribed =
        of_prescribed.add(prescribed_velocities(meshed->dirichlet, state.velocity),
                          round_off_of_speed * typical_speed,
                          scene.bodies.size(),
                          discretization.communicator());
    const SchemeInfo &scheme = scheme_info(scene.time.scheme);
    if (meshed->surface.follows() && scheme.predictor && !scheme.projects_velocity)
      reading.turning = turning_normals.add(
        meshed->surface, state.contact_force, scene.bodies.size(), discretization.communicator());
    return reading;
  }


  template <int dim>
  double Observation<dim>::standard_kinetic_energy(const State &state) const
  {
    if (!scene.time.mass.has_massless_contact_nodes())
      return ledger.current().kinetic;
    Vector momentum = meshed->discretization.make_vector();
    meshed->discretization.matrices().apply_standard_mass(momentum, state.velocity);
    return 0.5 * (state.velocity * momentum);
  }


  template <int dim>
  Momentum Observation<dim>::momentum_of(const State &state) const
  {
    return momentum(
      meshed->discretization, state, meshed->surface.follows() ? &state.displacement : nullptr);
  }


  template <int dim>
  HistoryRow Observation<dim>::evaluate(const State         &state,
                                        const StepReport    &report,
                                        const EnergyBooking &booking)
  {
    const ProductCount products       = products_of_step();
    const auto        &discretization = meshed->discretization;
    contact_now                       = contact_summary(meshed->surface, discretization, state);
    if (scene.exact_solution.given)
      latest_errors = errors.evaluate(discretization, state, report.step_size);
    const Momentum momentum_now = momentum_of(state);
    double         drift_square = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      drift_square += std::pow(momentum_now.angular[c] - initial_momentum.angular[c], 2);
    return {state,
            discretization.mesh().triangulation().n_global_active_cells(),
            discretization.dof_handler().n_dofs(),
            ledger.current(),
            standard_kinetic_energy(state),
            booking,
            momentum_now,
            std::sqrt(drift_square),
            contact_now,
            report,
            products,
            earlier_time + clock.wall_time(),
            latest_errors};
  }


  template <int dim>
  void Observation<dim>::write(const HistoryRow &row, const bool always)
  {
    const State &state  = row.state;
    const bool   is_due = always || state.step % scene.output.history_every == 0;
    history.write(row, is_due);
    tables.write(state, row.report, is_due);
    for (unsigned int p = 0; p < probes.size(); ++p)
      {
        const ProbeReading reading = probes[p].read(state);
        velocity_zigzags[p].add(reading.normal_velocity, reading.normal_force > 0.);
        history.write_probe(p, state.time, reading, is_due);
      }
    products_before = meshed->discretization.matrices().products();
  }


  template <int dim>
  void Observation<dim>::finish()
  {
    history.finish();
    tables.finish();
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
  std::string Observation<dim>::summary() const
  {
    std::ostringstream text;
    text << std::setprecision(4) << run_summary.text();
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


  template <int dim>
  std::vector<std::string> Observation<dim>::warnings() const
  {
    std::vector<std::string> result = run_summary.warnings();
    for (const std::string &sentence : validity.summary())
      result.push_back(sentence);
    return result;
  }


  template class Observation<2>;
  template class Observation<3>;
} // namespace signorini
