// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/prm/plugins.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  namespace
  {
    template <typename Declare>
    void section(dealii::ParameterHandler &prm, const std::string &name, const Declare &declare)
    {
      prm.enter_subsection(name);
      declare(prm);
      prm.leave_subsection();
    }

    void declare_names(dealii::ParameterHandler &prm, const std::string &of_what)
    {
      prm.declare_entry("Names",
                        "",
                        dealii::Patterns::Anything(),
                        "Names of the " + of_what
                          + ", separated by commas. Each has a subsection of this name.");
    }

    /** A section with a list of names and a subsection for each. */
    template <typename Declare>
    void named_sections(dealii::ParameterHandler       &prm,
                        const std::string              &name,
                        const std::string              &of_what,
                        const std::vector<std::string> &names,
                        const Declare                  &declare)
    {
      section(prm, name, [&](auto &) {
        declare_names(prm, of_what);
        for (const std::string &inner : names)
          section(prm, inner, declare);
      });
    }

    void declare_top_level(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      prm.declare_entry(
        "Dimension", "3", Selection("2|3"), "Space dimension, 2 (plane strain) or 3.");
      prm.declare_entry(
        "Output directory",
        "output",
        Anything(),
        "Folder for all results, relative to the current one. It is made if it does not exist.");
      prm.declare_entry(
        key_of_plugins,
        "",
        Anything(),
        "Plug-ins that add schemes, obstacles, shapes or materials: shared libraries, separated by "
        "commas, absolute or relative to the folder of the scene.");
      prm.declare_entry("Mapping",
                        name_of(MappingChoice::automatic),
                        choices_of<MappingChoice>(),
                        "linear: cells with straight edges, isoparametric; curved: quadratic "
                        "cells, which follow round shapes more closely; automatic: curved if a "
                        "body is round and the mesh changes, as cells with straight edges keep the "
                        "facets of the first mesh, however fine they become; else linear.");
    }

    void declare_contact(dealii::ParameterHandler &prm, const std::vector<PairName> &pairs)
    {
      prm.declare_entry(
        "Pairs",
        "",
        dealii::Patterns::Anything(),
        "What may touch: `body : obstacle`, or `slave : master` for two bodies; with boundary ids, "
        "`body[0,2] : other[3]`, only those parts of the boundary count; names of groups in a mesh "
        "file can stand for ids, `hammer[face] : anvil[top]`. Separated by commas. The "
        "nodes of the slave may not enter the master: take the finer or the curved surface as "
        "slave. Each pair may have a subsection of its name.");
      declare_contact_motion(prm);
      for (const PairName &pair : pairs)
        section(prm, pair.text(), declare_pair);
    }
  } // namespace

  template <int dim>
  void declare_scene(dealii::ParameterHandler &prm, const SceneNames &names)
  {
    declare_top_level(prm);
    section(prm, "Time", declare_time);
    named_sections(prm, "Bodies", "elastic bodies", names.bodies, declare_body<dim>);
    named_sections(prm, "Obstacles", "rigid obstacles", names.obstacles, declare_obstacle<dim>);
    section(prm, "Contact", [&](auto &) { declare_contact(prm, names.pairs); });
    section(prm, "Adaptivity", declare_adaptivity);
    named_sections(prm, "Probes", "probes", names.probes, declare_probe<dim>);
    section(prm, "Exact solution", declare_exact_solution<dim>);
    section(prm, "Solver", declare_solver);
    section(prm, "Output", declare_output);
    section(prm, "Checkpoint", declare_checkpoint);
  }

  template void declare_scene<2>(dealii::ParameterHandler &, const SceneNames &);
  template void declare_scene<3>(dealii::ParameterHandler &, const SceneNames &);
} // namespace signorini
