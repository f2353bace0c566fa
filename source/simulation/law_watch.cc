// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/diagnostics/friction_excess.h>
#include <signorini/simulation/law_watch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace signorini
{
  namespace
  {
    /** What strains less is compared with the forces of this strain. */
    constexpr double least_strain = 1e-7;

    /** Whether nodes may come to an obstacle past its end, and then be inside of it. */
    template <int dim>
    bool comes_past_ends(const Scene<dim> &scene)
    {
      return scene.motion == ContactMotion::linearised
             && std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [](const auto &named) {
                  return named.shape->has_end();
                });
    }

    /** Whether bodies meet whose gaps are those of the motion: where that finds none, bounds are
     * clipped. */
    template <int dim>
    bool clips_bounds(const Scene<dim> &scene)
    {
      return scene.motion == ContactMotion::follow
             && std::any_of(scene.pairs.begin(), scene.pairs.end(), [](const auto &pair) {
                  return pair.of_two_bodies();
                });
    }
  } // namespace


  template <int dim>
  std::set<Law> proved_laws(const Scene<dim> &scene)
  {
    const SchemeInfo &scheme = scheme_info(scene.time.scheme);
    std::set<Law>     laws   = {Law::no_adhesion};
    // Impulses that stop nodes in contact come after friction has seen the normal forces.
    if (!scheme.projects_velocity)
      laws.insert(Law::coulomb);
    if (scheme.inertia && scheme.own_tolerance.empty())
      laws.insert(Law::energy_identity);
    // A projection in another mass than that of the step may bring energy.
    if (scheme.energy != EnergyLaw::none && !comes_past_ends(scene)
        && scene.time.mass.predictor == PredictorMass::consistent)
      laws.insert(Law::no_gain);
    // A finer mesh sees more of a curved surface, and what is inside then stays there.
    if (!scheme.penetrates && !scene.adaptivity.any() && !comes_past_ends(scene)
        && !clips_bounds(scene))
      laws.insert(Law::no_penetration);
    if (balances_momentum_by_one_force(scheme))
      laws.insert(Law::momentum);
    return laws;
  }


  void heed(const std::vector<std::string> &diagnoses, const GuardAction action, RunLog &log)
  {
    for (const std::string &diagnosis : diagnoses)
      if (action == GuardAction::stop)
        throw RunError(diagnosis);
      else
        log.warning(diagnosis);
  }


  template <int dim>
  LawWatch<dim>::LawWatch(const Scene<dim> &scene)
    : has_inertia(scheme_info(scene.time.scheme).inertia)
    , balance(scheme_info(scene.time.scheme).balance, has_inertia)
    , guard(scene.time.scheme, proved_laws(scene), scene.solver.tolerance)
  {
  }


  template <int dim>
  void LawWatch<dim>::start(MeshedScene<dim>      &new_meshed,
                            const BodyMotion<dim> &motion,
                            const State           &state)
  {
    meshed = &new_meshed;
    masses = motion.masses_of_bodies();
    if (has_inertia)
      courant_number_per_time = meshed->discretization.mesh().courant_number(1.);
    balance.start(meshed->discretization, state, meshed->load(state.time));
  }


  template <int dim>
  double LawWatch<dim>::momentum_residual(const State      &state,
                                          const StepReport &report,
                                          const double      energy_scale)
  {
    const auto &mesh   = meshed->discretization.mesh();
    const auto  forces = balance.step(state, report, meshed->load(state.time));
    double      error = 0., scale = 0.;
    for (std::size_t b = 0; b < forces.size(); ++b)
      {
        double square = 0., force = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          {
            square += std::pow(forces[b].by_multiplier[c] - forces[b].by_momentum[c], 2);
            force += std::pow(forces[b].by_multiplier[c], 2);
          }
        error = std::max(error, std::sqrt(square));
        scale = std::max({scale, std::sqrt(force), forces[b].momentum_scale});
        // The solver answers for a part of the energy of the motion: an error of the velocity that
        // has the energy E moves a body of mass m with the momentum sqrt(2 E m) at most.
        if (has_inertia)
          scale = std::max(scale, std::sqrt(2. * energy_scale * masses[b]) / report.step_size);
        else // forces that squeeze a body may add up to nothing
          scale = std::max(scale, largest_force);
        // Where a trial has strained what then stays at rest, round-off of that is left.
        scale = std::max(scale,
                         least_strain * masses[b] * std::pow(mesh.lowest_frequency(b), 2)
                           * mesh.body_size(b));
      }
    return scale > 0. ? error / scale : 0.;
  }


  namespace
  {
    /** The largest entry in the balance of a step. */
    double flow_of(const EnergyBooking &booking)
    {
      double flow = 0.;
      for (const double work : {booking.contact,
                                booking.predictor,
                                booking.friction,
                                booking.damping,
                                booking.scheme,
                                booking.external,
                                booking.transfer})
        flow = std::max(flow, std::abs(work));
      return flow;
    }
  } // namespace


  template <int dim>
  double LawWatch<dim>::energy_of_round_off() const
  {
    const double speed = std::numeric_limits<double>::epsilon() * courant_number_per_time
                         * meshed->discretization.mesh().body_size();
    return 0.5 * std::accumulate(masses.begin(), masses.end(), 0.) * speed * speed;
  }


  template <int dim>
  LawReading LawWatch<dim>::read(const State          &state,
                                 const StepReport     &report,
                                 const EnergyBooking  &booking,
                                 const ContactSummary &contact,
                                 const double          largest_energy)
  {
    const auto  &mesh         = meshed->discretization.mesh();
    const double energy_scale = std::max(largest_energy, energy_of_round_off());
    largest_force             = std::max(largest_force, contact.largest_node_force);
    largest_flow              = std::max(largest_flow, flow_of(booking));
    const auto over           = [](const double value, const double scale) {
      return scale > 0. ? value / scale : 0.;
    };
    LawReading reading;
    reading.time      = state.time;
    reading.round_off = std::numeric_limits<double>::epsilon()
                        * std::pow(courant_number_per_time * report.step_size, 2);
    reading.violation = {
      {over(booking.contact + booking.predictor + booking.friction, energy_scale),
       over(std::abs(booking.residual), std::max(energy_scale, largest_flow)),
       over(contact.max_tension, largest_force),
       over(friction_excess(meshed->surface, state, mesh.communicator()), largest_force),
       contact.max_penetration / mesh.body_size(),
       momentum_residual(state, report, energy_scale)}};
    return reading;
  }


  template std::set<Law> proved_laws(const Scene<2> &);
  template std::set<Law> proved_laws(const Scene<3> &);
  template class LawWatch<2>;
  template class LawWatch<3>;
} // namespace signorini
