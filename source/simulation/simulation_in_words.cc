// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What a simulation says about itself before its first step.

#include <signorini/base/spelling.h>
#include <signorini/setup/setup_output.h>
#include <signorini/simulation/element_warnings.h>
#include <signorini/simulation/preflight.h>
#include <signorini/simulation/simulation.h>
#include <signorini/simulation/usual_mistakes.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** What several processes, or no inertia, keep from being solved for contact nodes alone. */
    template <int dim>
    std::string note_about_condensation(const Scene<dim>       &scene,
                                        const MeshedScene<dim> &meshed,
                                        const unsigned int      mesh_life_time)
    {
      const auto        &discretization = meshed.discretization;
      const unsigned int n = Utilities::MPI::n_mpi_processes(discretization.communicator());
      const bool         has_inertia = scheme_info(scene.time.scheme).inertia;
      if (scene.solver.condensation == CondensationKind::always && (n > 1 || !has_inertia))
        return "`Solver/Condensation = always` has no effect "
               + (n > 1 ? "on several processes" : "with `Time/Scheme = " + scene.time.scheme + "`")
               + ": iterations solve it";
      if (n > 1 && has_inertia
          && would_condense_alone(
            scene.solver.condensation,
            scene.solver.preconditioner,
            discretization,
            meshed.coordinates,
            {scene.time.step_size, mesh_life_time, has_friction(scene.pairs)}))
        return "on one process the steps of this scene would be solved for the contact nodes alone "
               "(`Solver/Condensation`), which may be faster than "
               + std::to_string(n) + " processes";
      return "";
    }
  } // namespace


  template <int dim>
  std::string Simulation<dim>::validate(const bool for_programs)
  {
    prepare();
    Preflight forecast = preflight(scene, *meshed, impacts);
    forecast.notes     = notes();
    forecast.warnings  = warnings();
    for (const std::string &mistake : usual_mistakes(scene, forecast))
      forecast.warnings.push_back(mistake);
    if (for_programs)
      return as_json(forecast);
    std::string text =
      scene.file_name + ": the scene is in order.\n" + description() + in_words(forecast);
    if (scene.output.vtu)
      {
        const bool has_picture =
          write_setup(scene.output_directory, meshed->discretization, scene.pairs, scene.obstacles);
        text += "  set-up            " + scene.output_directory + "/setup.pvd"
                + (has_picture ? " and setup.svg" : "") + "\n";
      }
    return text;
  }


  template <int dim>
  std::string Simulation<dim>::description() const
  {
    std::ostringstream text;
    text << "  scheme            " << scene.time.scheme << ", ";
    if (scene.step_sizes.is_variable())
      text << "steps by " << name_of(scene.step_sizes.control) << ", the first of ";
    else
      text << scene.time.n_steps() << " steps of ";
    text << scene.time.step_size << "\n";
    if (automatic_damping != nullptr && automatic_damping->spectral_radius() < 1.)
      text << "  spectral radius   " << automatic_damping->spectral_radius()
           << ", because the smallest cells are much faster than a step"
           << (mesh_control.any() ? "; follows the mesh\n" : "\n");
    if (scene.time.start == StartKind::equilibrium)
      text << "  start             equilibrium, found with " << equilibrium.n_products
           << " products with A\n";
    if (!equilibrium.unheld.empty())
      text << "  not held          " << equilibrium.unheld
           << ": begins to move, as neither Dirichlet conditions nor contact hold it against "
              "its loads\n";
    if (!meshed->mass_note.empty())
      text << "  mass              " << meshed->mass_note << "\n";
    text << "  bodies            " << scene.bodies.size() << ", "
         << mesh.triangulation().n_global_active_cells() << " cells, "
         << meshed->discretization.dof_handler().n_dofs() << " degrees of freedom"
         << "\n  contact nodes     " << meshed->surface.n_global_nodes();
    const double courant_number = mesh.courant_number(scene.time.step_size);
    if (scheme_info(scene.time.scheme).inertia)
      text << "\n  Courant number    " << courant_number;
    text << "\n  processes         " << Utilities::MPI::n_mpi_processes(mesh.communicator())
         << "\n";
    for (const std::string &note : notes())
      text << "  note: " << note << "\n";
    return text.str();
  }


  template <int dim>
  std::vector<std::string> Simulation<dim>::notes() const
  {
    std::vector<std::string> result;
    const auto               note = [&](const auto &...parts) {
      std::ostringstream text;
      (text << ... << parts);
      result.push_back(text.str());
    };
    if (meshed->surface.n_left_to_dirichlet_conditions() > 0)
      note(meshed->surface.n_left_to_dirichlet_conditions(),
           " nodes of the contact surface have a prescribed normal displacement, and take no part "
           "in contact");
    if (const double end = scene.time.n_steps() * scene.time.step_size;
        !scene.step_sizes.is_variable()
        && std::abs(end - scene.time.end_time) > 1e-9 * scene.time.end_time)
      note("the run ends at ",
           end,
           ", the multiple of `Step size` next to `End time` = ",
           scene.time.end_time);
    for (const BodyDescription<dim> &body : scene.bodies)
      for (const std::string &clause : body.shape->notes())
        note("the mesh of '", body.name, "': ", clause);
    if (!scene.why_linearised.empty())
      note("contact is linearised about the initial configuration: ", scene.why_linearised);
    constexpr unsigned int smooth = 4; // measured, see doc/adaptivity.md
    for (const BodyDescription<dim> &body : scene.bodies)
      if (scene.adaptivity.has_target() && body.shape->is_round() && body.refinements < smooth)
        note("however fine the mesh becomes, '",
             body.name,
             "' keeps the surface of its first mesh, parabolas with small kinks between them: the "
             "pressure of a contact that is small beside these is wrong by per cents, its force by "
             "less; `Refinements = 4` is smooth enough");
    if (const std::string text =
          note_about_condensation(scene, *meshed, mesh_control.mesh_life_time());
        !text.empty())
      note(text);
    if (perturbation_of_velocities() != 0.)
      note("SIGNORINI_PERTURB changes the initial velocities by ",
           perturbation_of_velocities(),
           " of themselves");
    for (const auto *sentences : {&meshed->surface.notes(), &start_remarks.notes, &expected.notes})
      result.insert(result.end(), sentences->begin(), sentences->end());
    return result;
  }


  template <int dim>
  std::vector<std::string> Simulation<dim>::warnings() const
  {
    std::vector<std::string> result = start_remarks.warnings;
    result.insert(result.end(), expected.warnings.begin(), expected.warnings.end());
    for (const auto &sentences :
         {element_warnings(mesh), stiff_slaves(scene, mesh.courant_number(scene.time.step_size))})
      result.insert(result.end(), sentences.begin(), sentences.end());
    if (!scene.pairs.empty() && meshed->surface.n_global_nodes() == 0)
      result.push_back("Contact/Pairs names a pair, but no node can come into contact: none faces "
                       "its obstacle, or all of them are prescribed.");
    if (mesh_control.any() && scene.mapping != CellGeometry::curved
        && std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto &body) {
             return body.shape->is_round();
           }))
      result.push_back("On a mesh that changes, a round body keeps the facets of its initial "
                       "`Refinements`, however fine the mesh becomes. Set `Mapping = curved`, or "
                       "leave the choice to `Mapping = automatic`.");
    // Its weights are those of the shear modulus, and pressures are not those of shear there.
    constexpr double nearly_incompressible = 0.45;
    for (const auto &body : scene.bodies)
      if (scene.adaptivity.has_target() && body.material.poissons_ratio > nearly_incompressible)
        result.push_back(
          "Adaptivity/Goal = " + std::string(name_of(scene.adaptivity.goal)) + ": the body '"
          + body.name
          + "' is nearly incompressible, and the estimate of the error of the force "
            "is not made for that (it was wrong by 5 with Poisson's ratio 0.49, and "
            "by 60 with 0.4999). Compare with another mesh, or set `Goal = energy`.");
    return result;
  }


  template std::string              Simulation<2>::validate(bool);
  template std::string              Simulation<3>::validate(bool);
  template std::string              Simulation<2>::description() const;
  template std::string              Simulation<3>::description() const;
  template std::vector<std::string> Simulation<2>::notes() const;
  template std::vector<std::string> Simulation<3>::notes() const;
  template std::vector<std::string> Simulation<2>::warnings() const;
  template std::vector<std::string> Simulation<3>::warnings() const;
} // namespace signorini
