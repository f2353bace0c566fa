// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/diagnostics/body_motion.h>
#include <signorini/diagnostics/rigid_flight.h>
#include <signorini/simulation/first_impacts.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();

    /** Whether any boundary of a body has a prescribed displacement along the normal of a touch. */
    template <int dim>
    bool is_held(const BodyDescription<dim> &body, const std::array<double, 3> &normal)
    {
      constexpr double oblique = 0.3; // components below this part hold little
      for (const auto &condition : body.dirichlet)
        for (unsigned int c = 0; c < dim; ++c)
          if (!condition.expressions[c].empty() && std::abs(normal[c]) > oblique)
            return true;
      return false;
    }


    /** A body as a side of an impact; one that is held does not give way. */
    template <int dim>
    Collider collider(const Mesh<dim>             &mesh,
                      const unsigned int           number,
                      const double                 mass,
                      const std::array<double, 3> &normal)
    {
      const BodyDescription<dim> &body = mesh.bodies()[number];
      const double                nu   = body.material.poissons_ratio;
      dealii::Tensor<1, dim>      along;
      for (unsigned int c = 0; c < dim; ++c)
        along[c] = normal[c];
      return {is_held(body, normal) ? infinite : mass,
              mass / body.material.density,
              body.material.youngs_modulus / (1. - nu * nu),
              body.material.pressure_wave_speed(),
              body.material.density,
              mesh.extent(number, along)};
    }


    /** Whether the way of the first node of a touch leads through a box. */
    template <int dim>
    bool leads_through(const FirstTouch &touch, const dealii::BoundingBox<dim> &box)
    {
      // Corners of a box around a round body are empty.
      constexpr double filled = 0.8;
      double           begin = 0., end = touch.distance;
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double from = touch.position[c] - box.center()[c],
                       half = 0.5 * filled * box.side_length(c), way = touch.normal[c];
          if (std::abs(way) < 1e-12)
            {
              if (std::abs(from) >= half)
                return false;
              continue;
            }
          begin = std::max(begin, (-from - std::copysign(half, way)) / way);
          end   = std::min(end, (-from + std::copysign(half, way)) / way);
        }
      return begin < end;
    }


    /** The sides of a pair, bodies first: an obstacle counts behind the bodies. */
    std::array<std::size_t, 2> sides(const PairDescription &pair, const std::size_t n_bodies)
    {
      return {{pair.slave, pair.of_two_bodies() ? pair.master : n_bodies + pair.obstacle}};
    }


    /** Whether a third body is between the sides of a pair, and meets one of them before. */
    template <int dim>
    bool third_body_is_hit_before(const std::vector<FirstTouch> &touches,
                                  const std::size_t              p,
                                  const MeshedScene<dim>        &meshed)
    {
      const auto &pairs  = meshed.surface.pairs();
      const auto &mesh   = meshed.discretization.mesh();
      const auto  of_p   = sides(pairs[p], mesh.bodies().size());
      const auto  is_one = [&](const std::size_t side) {
        return side == of_p[0] || side == of_p[1];
      };
      for (std::size_t q = 0; q < touches.size(); ++q)
        if (touches[q].time < touches[p].time)
          for (unsigned int one = 0; one < 2; ++one)
            {
              const auto of_q  = sides(pairs[q], mesh.bodies().size());
              const auto third = of_q[1 - one];
              if (is_one(of_q[one]) && !is_one(third) && third < mesh.bodies().size()
                  && leads_through<dim>(touches[p], mesh.bounding_box(third)))
                return true;
            }
      return false;
    }

    /** Which bodies nothing keeps from falling: neither conditions, equilibrium, nor a touch. */
    template <int dim>
    std::vector<bool>
    what_falls(const Scene<dim> &scene, const MeshedScene<dim> &meshed, const State &state)
    {
      std::vector<bool> falls;
      for (const BodyDescription<dim> &body : scene.bodies)
        falls.push_back(body.dirichlet.empty() && scene.time.start != StartKind::equilibrium);
      const double size      = meshed.discretization.mesh().body_size();
      const auto   distances = distances_of_pairs(
        meshed.surface, state.displacement, 1e-2 * size, meshed.discretization.communicator());
      for (std::size_t p = 0; p < distances.size(); ++p)
        if (distances[p] < 1e-6 * size)
          for (const std::size_t side : sides(scene.pairs[p], scene.bodies.size()))
            if (side < scene.bodies.size())
              falls[side] = false;
      return falls;
    }


    /** Velocities relative to an obstacle that moves, at a time of the scene. */
    template <int dim>
    void make_relative(const NamedObstacle<dim>  &obstacle,
                       const double               time,
                       const double               step_size,
                       const Discretization<dim> &discretization,
                       const Vector              &displacement,
                       Vector                    &velocity)
    {
      if (!obstacle.motion)
        return;
      const double             interval = 1e-3 * step_size;
      const ObstaclePlace<dim> now      = obstacle.motion->place(time),
                               next     = obstacle.motion->place(time + interval);
      const unsigned int n_owned        = discretization.matrices().pattern.n_owned;
      for (unsigned int node = 0; node < n_owned; ++node)
        {
          dealii::Point<dim> x = discretization.node_positions()[node];
          for (unsigned int c = 0; c < dim; ++c)
            x[c] += displacement.local_element(dim * node + c);
          const dealii::Tensor<1, dim> motion = next.forth(now.back(x)) - x;
          for (unsigned int c = 0; c < dim; ++c)
            velocity.local_element(dim * node + c) -= motion[c] / interval;
        }
    }


    /** How the surfaces of a pair meet that have flown for a time, and nearly touch. */
    template <int dim>
    FirstTouch touch_after(const unsigned int      pair,
                           const double            time,
                           const RigidFlight<dim> &flight,
                           const Scene<dim>       &scene,
                           MeshedScene<dim>       &meshed,
                           const State            &state)
    {
      const MPI_Comm         communicator = meshed.discretization.communicator();
      const Vector           displacement = flight.displacement(time);
      Vector                 velocity     = flight.velocity(time);
      const PairDescription &description  = meshed.surface.pairs()[pair];
      const bool             of_two       = description.of_two_bodies();
      if (!of_two)
        make_relative(scene.obstacles[description.obstacle],
                      state.time + time,
                      scene.time.step_size,
                      meshed.discretization,
                      displacement,
                      velocity);
      MovingContact *following = meshed.system.capabilities().moving_contact;
      if (following == nullptr || (of_two && description.slave == description.master))
        return first_touches(meshed.surface, displacement, velocity, communicator)[pair];
      if (of_two)
        try
          {
            // Contact of bodies that follows the motion sees no farther than a step; the surfaces
            // as a whole are those of linearised contact.
            const ContactSurface<dim> ahead(
              meshed.discretization, meshed.dirichlet, scene.obstacles, {description});
            return first_touches(ahead, displacement, velocity, communicator)[0];
          }
        catch (const UserError &)
          {
            // They do not look at each other at the start; what else forbids contact that is
            // linearised there is no matter of expectations.
            return {};
          }
      following->arrive(displacement, state.time + time);
      const FirstTouch touch =
        first_touches(meshed.surface, displacement, velocity, communicator)[pair];
      following->arrive(state.displacement, state.time);
      return touch;
    }


    /** See times_of_meeting(). */
    template <int dim>
    std::vector<double> meetings(const Scene<dim>       &scene,
                                 MeshedScene<dim>       &meshed,
                                 const State            &state,
                                 const RigidFlight<dim> &flight)
    {
      const bool obstacles_move =
        std::any_of(scene.obstacles.begin(),
                    scene.obstacles.end(),
                    [](const NamedObstacle<dim> &obstacle) { return obstacle.motion != nullptr; });
      return times_of_meeting(meshed.surface,
                              meshed.discretization,
                              flight,
                              state.time,
                              scene.time.end_time - state.time,
                              obstacles_move);
    }


    /** Until a wave is back from the other end of a body of the pair. */
    template <int dim>
    double wave_transit(const PairDescription &pair, const Mesh<dim> &mesh)
    {
      const auto there_and_back = [&](const unsigned int body) {
        return 2. * mesh.body_size(body) / mesh.bodies()[body].material.pressure_wave_speed();
      };
      const double of_slave = there_and_back(pair.slave);
      return pair.of_two_bodies() ? std::min(of_slave, there_and_back(pair.master)) : of_slave;
    }


    /** What comes of a touch, if there is a theory of it. */
    template <int dim>
    void expect(const FirstTouch          &touch,
                const PairDescription     &pair,
                const MeshedScene<dim>    &meshed,
                const std::vector<double> &masses,
                FirstImpact               &first)
    {
      const Collider rigid{infinite, infinite, infinite, infinite, infinite, infinite};
      const auto    &mesh = meshed.discretization.mesh();
      const auto     side = [&](const unsigned int body) {
        return collider(mesh, body, masses[body], touch.normal);
      };
      first.node_spacing = touch.node_spacing;
      first.is_round     = touch.curvature > 0.;
      first.impact       = expected_impact<dim>(
        touch, side(pair.slave), pair.of_two_bodies() ? side(pair.master) : rigid);
      first.is_known = std::isfinite(first.impact.duration); // something can give way
    }
  } // namespace


  template <int dim>
  std::vector<FirstImpact>
  first_impacts(const Scene<dim> &scene, MeshedScene<dim> &meshed, const State &state)
  {
    if (!scheme_info(scene.time.scheme).inertia)
      return {}; // nothing flies
    const std::vector<double> masses = BodyMotion<dim>(meshed.discretization).masses_of_bodies();
    const RigidFlight<dim>    flight(meshed.discretization,
                                  state,
                                  meshed.load(state.time),
                                  masses,
                                  what_falls(scene, meshed, state));
    const std::vector<double> times = meetings(scene, meshed, state, flight);
    std::vector<FirstTouch>   touches(times.size());
    for (unsigned int p = 0; p < times.size(); ++p)
      if (std::isfinite(times[p]))
        {
          touches[p] = touch_after(p, times[p], flight, scene, meshed, state);
          touches[p].time += times[p];
        }
    std::vector<FirstImpact> impacts;
    for (unsigned int p = 0; p < touches.size(); ++p)
      {
        const FirstTouch &touch  = touches[p];
        const bool        grazes = !std::isfinite(touch.time);
        const double      time   = grazes ? times[p] : touch.time;
        if (!(state.time + time < scene.time.end_time))
          continue;
        FirstImpact first;
        first.pair = p;
        // What touches at the start does so up to round-off.
        first.time  = state.time + (time < 1e-9 * scene.time.end_time ? 0. : time);
        first.speed = grazes ? 0. : touch.speed;
        // A body that is hit before changes the motion that would have led there.
        if (!grazes && touch.is_smooth && !third_body_is_hit_before(touches, p, meshed))
          expect(touch, meshed.surface.pairs()[p], meshed, masses, first);
        if (!first.is_known)
          first.wave_transit =
            wave_transit(meshed.surface.pairs()[p], meshed.discretization.mesh());
        impacts.push_back(first);
      }
    return impacts;
  }


  template std::vector<FirstImpact>
  first_impacts(const Scene<2> &, MeshedScene<2> &, const State &);
  template std::vector<FirstImpact>
  first_impacts(const Scene<3> &, MeshedScene<3> &, const State &);
} // namespace signorini
