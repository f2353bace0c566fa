// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/simulation/initial_equilibrium.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Times that the equilibrium is found, each with the normals of the last. */
    constexpr unsigned int most_solutions = 40;
    /** Of the first step, in which obstacles show their velocity. */
    constexpr double part_of_step = 1e-2;


    /** Of what contact nodes face; nothing if no obstacle moves. */
    std::optional<Vector>
    velocity_of_obstacles(DynamicalSystem &system, const State &undeformed, const double step_size)
    {
      const double span = part_of_step * step_size;
      system.capabilities().moving_contact->begin_step(undeformed, span, StepNormals::at_end);
      const Vector *const motion = obstacle_motion(system);
      if (motion == nullptr)
        return {};
      Vector result = *motion;
      result /= span;
      return result;
    }


    /** How what bears has moved relative to its other side: parts of the smaller body's size. */
    struct WayToContact
    {
      double longest      = 0.;
      double least_closed = std::numeric_limits<double>::infinity(); ///< of the gap
    };

    /** Of each pair. Collective. */
    template <int dim>
    std::vector<WayToContact> ways_to_contact(const MeshedScene<dim> &meshed, const State &state)
    {
      const auto &surface = meshed.surface;
      const auto &mesh    = meshed.discretization.mesh();
      const auto  of_other_sides =
        meshed.coordinates.coupling().partner_displacement(state.displacement);
      std::vector<WayToContact> ways(surface.pairs().size());
      for (std::size_t k = 0; k < surface.nodes().size(); ++k)
        {
          const ContactNode<dim> &node = surface.nodes()[k];
          const auto             &pair = surface.pairs()[node.pair];
          double                  size = mesh.body_size(pair.slave);
          if (pair.of_two_bodies())
            size = std::min(size, mesh.body_size(pair.master));
          dealii::Tensor<1, dim> way   = -of_other_sides[k];
          double                 force = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            {
              way[c] += state.displacement.local_element(dim * node.node + c);
              force =
                std::max(force, std::abs(state.contact_force.local_element(dim * node.node + c)));
            }
          if (force == 0.)
            continue;
          WayToContact &of_pair = ways[node.pair];
          of_pair.longest       = std::max(of_pair.longest, way.norm() / size);
          of_pair.least_closed  = std::min(of_pair.least_closed, way * node.normal() / size);
        }
      for (WayToContact &way : ways)
        {
          way.longest      = dealii::Utilities::MPI::max(way.longest, mesh.communicator());
          way.least_closed = dealii::Utilities::MPI::min(way.least_closed, mesh.communicator());
        }
      return ways;
    }


    /**
     * Contact is linear about the undeformed bodies: what it holds only after a body has slid or
     * turned by half of its size is no equilibrium. What was apart, and is not a matter of the
     * mesh, is told.
     */
    template <int dim>
    StartReport judged(StartReport report, const MeshedScene<dim> &meshed, const State &state)
    {
      constexpr double too_far = 0.5, told = 0.01;
      const auto       ways = ways_to_contact(meshed, state);
      for (std::size_t pair = 0; pair < ways.size(); ++pair)
        {
          const std::string &name = meshed.surface.pairs()[pair].name;
          if (ways[pair].longest > too_far)
            throw RunError(
              "Time/Start = equilibrium: contact of the pair '" + name
              + "' holds nothing near the undeformed bodies, but only after they have moved along "
                "each other by more than half of the smaller one's size. Hold the body (`Friction "
                "coefficient`, `Dirichlet`), or set `Start = given`.");
          if (std::isfinite(ways[pair].least_closed) && ways[pair].least_closed > told)
            {
              std::ostringstream text;
              text.precision(2);
              text << "Time/Start = equilibrium begins with contact of the pair '" << name
                   << "', which was apart by " << 100. * ways[pair].least_closed
                   << " % of the size of its smaller body: loads press it there. Set `Start = "
                      "given` if it is to fall.";
              report.remarks.push_back(text.str());
            }
        }
      return report;
    }
  } // namespace


  template <int dim>
  StartReport initial_equilibrium(const Scene<dim> &scene, MeshedScene<dim> &meshed, State &state)
  {
    std::optional<Vector> of_obstacles;
    const auto            solve = [&] {
      return start_in_equilibrium(meshed.discretization,
                                  meshed.surface,
                                  meshed.coordinates,
                                  scene.solver,
                                  meshed.load(0.),
                                  of_obstacles ? &*of_obstacles : nullptr,
                                  state);
    };
    MovingContact *const contact = meshed.system.capabilities().moving_contact;
    if (contact == nullptr)
      return judged(solve(), meshed, state);

    State undeformed;
    undeformed.displacement = undeformed.velocity = undeformed.contact_force =
      meshed.discretization.make_vector();
    of_obstacles = velocity_of_obstacles(meshed.system, undeformed, scene.time.step_size);
    contact->begin_step(undeformed, 0., StepNormals::at_end);
    StartReport all;
    for (unsigned int n_solutions = 0; n_solutions < most_solutions; ++n_solutions)
      {
        const StartReport report = solve();
        all.n_products += report.n_products;
        all.unheld = report.unheld;
        meshed.system.expect_contact_as_in(state);
        if (contact->mismatch(state.displacement) <= 1.)
          return judged(all, meshed, state);
        contact->follow(state.displacement);
      }
    throw RunError("Time/Start = equilibrium: no equilibrium was found whose normals of contact "
                   "are its own. Set `Start = given` to begin with undeformed bodies, or `Contact/"
                   "Motion = linearised`.");
  }


  template StartReport initial_equilibrium(const Scene<2> &, MeshedScene<2> &, State &);
  template StartReport initial_equilibrium(const Scene<3> &, MeshedScene<3> &, State &);
} // namespace signorini
