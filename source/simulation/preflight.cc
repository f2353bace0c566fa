// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/resolution.h>
#include <signorini/simulation/preflight.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    constexpr double infinite_time = std::numeric_limits<double>::infinity();

    /** Steps that force and impulse of a contact want. */
    constexpr double enough_steps = 20.;


    /** What contact does to the energy and the gaps of a scheme. */
    std::string law_of(const SchemeInfo &scheme)
    {
      std::string law;
      switch (scheme.energy)
        {
        case EnergyLaw::dissipates:
          law = "contact never adds energy";
          break;
        case EnergyLaw::conserves:
          law = "contact neither takes nor adds energy";
          break;
        case EnergyLaw::none:
          law = scheme.inertia ? "contact may add energy" : "equilibrium at the end of each step";
          break;
        }
      return law
             + (scheme.penetrates ? ", and nodes may penetrate"
                                  : ", and the gaps of its steps never become negative");
    }


    template <int dim>
    std::vector<BodyForecast> forecasts(const Mesh<dim> &mesh)
    {
      std::vector<BodyForecast> result;
      for (unsigned int b = 0; b < mesh.bodies().size(); ++b)
        {
          const Material &material = mesh.bodies()[b].material;
          BodyForecast    body;
          body.name                = mesh.bodies()[b].name;
          body.pressure_wave_speed = material.pressure_wave_speed();
          body.shear_wave_speed    = std::sqrt(material.mu() / material.density);
          body.transit_time        = mesh.body_size(b) / body.pressure_wave_speed;
          body.vibration_period =
            2. * mesh.body_size(b) / std::sqrt(material.youngs_modulus / material.density);
          result.push_back(body);
        }
      return result;
    }


    template <int dim>
    ImpactForecast forecast(const FirstImpact &first, const Scene<dim> &scene)
    {
      ImpactForecast result;
      result.pair  = scene.pairs[first.pair].name;
      result.first = first;
      if (!first.is_known)
        return result;
      result.n_steps               = first.impact.duration / scene.time.step_size;
      result.recommended_step_size = first.impact.duration / enough_steps;
      // Twice the nodes in each direction of those below which there is a warning.
      if (first.is_round)
        result.recommended_node_spacing =
          0.5 * first.node_spacing
          * std::pow(first.impact.n_nodes / few_nodes(dim), 1. / (dim - 1));
      return result;
    }


    double recommended_step_size(const Preflight &preflight)
    {
      double shortest = infinite_time;
      for (const ImpactForecast &impact : preflight.impacts)
        if (impact.first.is_known)
          shortest = std::min(shortest, impact.recommended_step_size);
      if (std::isfinite(shortest))
        return shortest;
      for (const BodyForecast &body : preflight.bodies)
        shortest = std::min(shortest, body.transit_time / enough_steps);
      return shortest;
    }


    template <int dim>
    std::vector<std::string> what_is_skipped(const Scene<dim> &scene)
    {
      const OutputParameters  &output = scene.output;
      std::vector<std::string> skipped;
      const auto               skip = [&](const bool does, const std::string &what) {
        if (does)
          skipped.push_back(what);
      };
      skip(scene.pairs.empty(), "contact: `Contact/Pairs` is empty");
      skip(!scene.why_linearised.empty(),
           "contact that follows the motion: " + scene.why_linearised);
      skip(!scene.pairs.empty() && !has_friction(scene.pairs),
           "friction: no pair has a coefficient");
      skip(!scene.adaptivity.any(), "changes of the mesh: `Adaptivity/Indicator = none`");
      skip(!output.vtu, "fields: `Output/VTU = false`");
      skip(output.history_every > 1,
           "rows of tables but for every " + std::to_string(output.history_every)
             + "th step: `Output/History every`");
      skip(!output.pairs && !scene.pairs.empty(), "pairs.csv: `Output/Pairs = false`");
      skip(!output.bodies, "bodies.csv: `Output/Bodies = false`");
      const bool any_held = std::any_of(scene.bodies.begin(),
                                        scene.bodies.end(),
                                        [](const auto &body) { return !body.dirichlet.empty(); });
      skip(!output.supports && any_held, "supports.csv: `Output/Supports = false`");
      return skipped;
    }
  } // namespace


  template <int dim>
  Preflight preflight(const Scene<dim>               &scene,
                      const MeshedScene<dim>         &meshed,
                      const std::vector<FirstImpact> &impacts)
  {
    const Mesh<dim>  &mesh   = meshed.discretization.mesh();
    const SchemeInfo &scheme = scheme_info(scene.time.scheme);
    Preflight         result;
    result.scene          = scene.file_name;
    result.scheme         = scheme.name;
    result.law            = law_of(scheme);
    result.dimension      = dim;
    result.n_processes    = dealii::Utilities::MPI::n_mpi_processes(mesh.communicator());
    result.step_size      = scene.time.step_size;
    result.end_time       = scene.time.end_time;
    result.has_inertia    = scheme.inertia;
    result.variable_steps = scene.step_sizes.is_variable();
    result.n_steps        = scene.time.n_steps();
    result.contact_nodes  = meshed.surface.n_global_nodes();
    result.cells          = mesh.triangulation().n_global_active_cells();
    result.dofs           = meshed.discretization.dof_handler().n_dofs();
    result.courant_number = mesh.courant_number(scene.time.step_size);
    result.memory         = memory_estimate(scene, meshed);
    result.bodies         = forecasts(mesh);
    for (const FirstImpact &first : impacts)
      result.impacts.push_back(forecast(first, scene));
    result.recommended_step_size = recommended_step_size(result);
    result.skipped               = what_is_skipped(scene);
    return result;
  }


  template Preflight
  preflight(const Scene<2> &, const MeshedScene<2> &, const std::vector<FirstImpact> &);
  template Preflight
  preflight(const Scene<3> &, const MeshedScene<3> &, const std::vector<FirstImpact> &);
} // namespace signorini
