// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/diagnostics/body_motion.h>
#include <signorini/diagnostics/expected_impact.h>
#include <signorini/diagnostics/resolution.h>
#include <signorini/simulation/expectations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

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
    Collider collider(const BodyDescription<dim>  &body,
                      const double                 mass,
                      const std::array<double, 3> &normal)
    {
      const double nu = body.material.poissons_ratio;
      return {is_held(body, normal) ? infinite : mass,
              mass / body.material.density,
              body.material.youngs_modulus / (1. - nu * nu),
              body.material.pressure_wave_speed(),
              body.material.density};
    }


    /** In the words of the summary, which judges the same after the run. */
    std::vector<std::string> doubts(const std::string    &pair,
                                    const ExpectedImpact &impact,
                                    const double          n_steps,
                                    const bool            is_round,
                                    const unsigned int    enough_nodes)
    {
      std::vector<std::string> result;
      const auto               say = [&](const auto &...parts) {
        std::ostringstream text;
        text.precision(2);
        text << "the first impact of the pair '" << pair << "' is expected to ";
        (text << ... << parts);
        result.push_back(text.str());
      };
      if (is_round && impact.n_nodes < enough_nodes)
        say("be carried by ",
            impact.n_nodes < 1.5 ? "a single node"
                                 : std::to_string(std::lround(impact.n_nodes)) + " nodes",
            ". Force and duration of such a contact may be wrong by 30 %: refine the "
            "mesh where the bodies touch (`Local refinements`, section Adaptivity).");
      // A plane wave is the shortest contact that there is: what bulges sideways comes back later.
      if (n_steps < (is_round ? few_steps : few_steps / 2))
        say(
          "last ", n_steps, " steps. Force and impulse need some twenty: reduce `Time/Step size`.");
      if (impact.strain > large_strain)
        say("strain a body by ",
            100. * impact.strain,
            " %. Strains are linear, and so is Hooke's law: the error is about as large.");
      return result;
    }

    /**
     * Contact of bodies that follows the motion sees no farther than a step; the straight way to
     * the other body is that of linearised contact.
     */
    template <int dim>
    std::vector<FirstTouch>
    all_first_touches(const Scene<dim> &scene, const MeshedScene<dim> &meshed, const State &state)
    {
      const MPI_Comm communicator = meshed.discretization.communicator();
      auto           touches =
        first_touches(meshed.surface, state.displacement, state.velocity, communicator);
      if (!meshed.surface.follows())
        return touches;
      for (std::size_t p = 0; p < touches.size(); ++p)
        if (const PairDescription &pair = meshed.surface.pairs()[p];
            pair.of_two_bodies() && pair.slave != pair.master)
          try
            {
              const ContactSurface<dim> ahead(
                meshed.discretization, meshed.dirichlet, scene.obstacles, {pair});
              touches[p] =
                first_touches(ahead, state.displacement, state.velocity, communicator)[0];
            }
          catch (const UserError &)
            {
              // They do not look at each other now, and may do so later; what else forbids
              // contact that is linearised here is no matter of expectations.
            }
      return touches;
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
  } // namespace


  template <int dim>
  Remarks expectations(const Scene<dim> &scene, const MeshedScene<dim> &meshed, const State &state)
  {
    Remarks                   remarks;
    const auto               &bodies = meshed.discretization.mesh().bodies();
    const std::vector<double> masses = BodyMotion<dim>(meshed.discretization).masses_of_bodies();
    const Collider            rigid{infinite, infinite, infinite, infinite, infinite};
    // A mesh that changes refines what touches before it does.
    const unsigned int enough_nodes = scene.adaptivity.any() ? 0 : few_nodes(dim);
    const auto         touches      = all_first_touches(scene, meshed, state);
    for (std::size_t p = 0; p < touches.size(); ++p)
      {
        const FirstTouch &touch = touches[p];
        if (!touch.is_smooth || state.time + touch.time >= scene.time.end_time)
          continue;
        if (third_body_is_hit_before(touches, p, meshed))
          continue; // which changes the motion that would have led there
        const PairDescription &pair = meshed.surface.pairs()[p];
        const auto             side = [&](const unsigned int body) {
          return collider(bodies[body], masses[body], touch.normal);
        };
        const ExpectedImpact impact = expected_impact<dim>(
          touch, side(pair.slave), pair.of_two_bodies() ? side(pair.master) : rigid);
        if (!std::isfinite(impact.duration))
          continue; // nothing can give way
        // What touches at the start does so up to round-off.
        const double time =
          state.time + (touch.time < 1e-9 * scene.time.end_time ? 0. : touch.time);
        const double n_steps =
          scene.step_sizes.is_variable() ? infinite : impact.duration / scene.time.step_size;
        const bool         is_round = touch.curvature > 0.;
        std::ostringstream text;
        text.precision(3);
        text << "expected of the first impact of '" << pair.name << "', at time " << time
             << " with speed " << touch.speed << ": force " << impact.force << ", contact for "
             << impact.duration;
        if (std::isfinite(n_steps))
          text << " (" << n_steps << " steps)";
        text << " on " << std::round(impact.n_nodes) << " nodes, strain " << 100. * impact.strain
             << " % (" << (is_round ? "Hertz" : "a plane wave") << ", without other forces)";
        remarks.notes.push_back(text.str());
        for (const std::string &doubt : doubts(pair.name, impact, n_steps, is_round, enough_nodes))
          remarks.warnings.push_back(doubt);
      }
    return remarks;
  }


  template Remarks expectations(const Scene<2> &, const MeshedScene<2> &, const State &);
  template Remarks expectations(const Scene<3> &, const MeshedScene<3> &, const State &);
} // namespace signorini
