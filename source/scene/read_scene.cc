// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/spelling.h>
#include <signorini/prm/apply_statements.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/prm/plugins.h>
#include <signorini/prm/repeatable_text.h>
#include <signorini/scene/read_scene.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace signorini
{
  namespace
  {
    const std::string dimension_remedy = "must be 2 (plane strain) or 3.";

    template <int dim>
    void check_top_level(const SectionReader &in)
    {
      if (in.text("Dimension") != std::to_string(dim))
        in.fail("Dimension", "this scene was asked for in dimension " + std::to_string(dim) + ".");
      if (in.text("Output directory").empty())
        in.fail("Output directory",
                "is empty. Name a folder for the results, for example output/ball.");
    }

    template <int dim>
    void
    parse_probes(const SectionReader &in, const std::vector<std::string> &names, Scene<dim> &scene)
    {
      for (const std::string &name : names)
        parse_probe(in.section(name), name, scene);
    }

    /**
     * An equilibrium is found from the undeformed bodies, and a displacement would be lost without
     * a word.
     */
    template <int dim>
    void check_start(const SectionReader &in, const Scene<dim> &scene)
    {
      if (scene.time.start != StartKind::equilibrium)
        return;
      for (const BodyDescription<dim> &body : scene.bodies)
        for (const std::string &expression : body.initial_displacement)
          if (constant_value(expression) != 0.)
            in.section(body.name).fail("Initial displacement",
                                       "does not fit `Time/Start = equilibrium`, where the loads "
                                       "determine the displacement. Remove this key, or set "
                                       "`Time/Start = given`.");
    }

    template <int dim>
    void check_initial_velocities(const SectionReader &in, const Scene<dim> &scene)
    {
      if (scheme_info(scene.time.scheme).inertia)
        return;
      for (const BodyDescription<dim> &body : scene.bodies)
        for (const std::string &expression : body.initial_velocity)
          if (constant_value(expression) != 0.)
            in.section(body.name).fail("Initial velocity",
                                       "has no effect with `Time/Scheme = " + scene.time.scheme
                                         + "`, which has no inertia. Remove this key, or take a "
                                           "scheme that moves masses.");
    }

    template <int dim>
    void check_damping(const SectionReader &in, const Scene<dim> &scene)
    {
      // Forces of damping 1e5 times as large as those of the strains leave five digits of these.
      constexpr double most     = 1e5;
      const bool       is_known = scheme_info(scene.time.scheme).damping;
      for (const BodyDescription<dim> &body : scene.bodies)
        {
          const RayleighDamping &damping = body.material.damping;
          if (!is_known && damping.any())
            in.section(body.name).fail(
              "Damping",
              "is not known to `Time/Scheme = " + scene.time.scheme
                + "`. Set `Damping = 0, 0`, or "
                  "take one of "
                + join(schemes_where([](const SchemeInfo &info) { return info.damping; }), ", ")
                + ".");
          if (std::max(damping.mass * scene.time.step_size,
                       damping.stiffness / scene.time.step_size)
              > most)
            in.section(body.name).fail(
              "Damping",
              "stops every motion within a step, and its round-off is seen in the energy. Give a "
              "at most 1e5 / `Step size`, and b at most 1e5 * `Step size`; what shall not move can "
              "be held by `Dirichlet`.");
        }
    }

    template <int dim>
    void check_dirichlet(const SectionReader &in, const Scene<dim> &scene)
    {
      if (scheme_info(scene.time.scheme).moving_dirichlet)
        return;
      for (const BodyDescription<dim> &body : scene.bodies)
        for (const BoundaryCondition<dim> &condition : body.dirichlet)
          if (has_time(condition.expressions))
            in.section(body.name).fail("Dirichlet",
                                       "does not fit `Time/Scheme = " + scene.time.scheme
                                         + "`, which does not follow prescribed displacements that "
                                           "change in time. Take another scheme for contact nodes "
                                           "without mass, with a small step size.");
    }

    template <int dim>
    CellGeometry cell_geometry(const MappingChoice choice, const Scene<dim> &scene)
    {
      const bool needs_curves =
        scene.adaptivity.any()
        && std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto &body) {
             return body.shape->is_round();
           });
      if (choice == MappingChoice::curved || (choice == MappingChoice::automatic && needs_curves))
        return CellGeometry::curved;
      return CellGeometry::linear;
    }

    /** A mesh that a scene names. */
    struct NamedMesh
    {
      std::vector<std::string> section; ///< of its key `File`
      std::string              path;    ///< from the root of the file system
    };


    template <int dim>
    std::vector<NamedMesh> meshes_of(const Scene<dim> &scene)
    {
      const auto whole = [](const std::string &path) {
        return std::filesystem::absolute(path).lexically_normal().string();
      };
      std::vector<NamedMesh> meshes;
      for (const BodyDescription<dim> &body : scene.bodies)
        if (const std::string path = body.shape->file(); !path.empty())
          meshes.push_back({{"Bodies", body.name}, whole(path)});
      for (const NamedObstacle<dim> &obstacle : scene.obstacles)
        if (const std::string path = obstacle.shape->file(); !path.empty())
          meshes.push_back({{"Obstacles", obstacle.name}, whole(path)});
      return meshes;
    }


    /**
     * All keys as a .prm. It will lie in another folder, so the paths of meshes must not depend on
     * where it lies. Where the command line has chosen, keys that lost their effect keep their
     * values, and are no mistake.
     */
    std::string print_all(const SceneText              &text,
                          dealii::ParameterHandler     &prm,
                          const std::vector<NamedMesh> &meshes)
    {
      prm.set(key_of_plugins, join(plugins_of(text), ", "));
      for (const NamedMesh &mesh : meshes)
        {
          prm.enter_subsection(mesh.section[0]);
          prm.enter_subsection(mesh.section[1]);
          prm.set("File", mesh.path);
          prm.leave_subsection();
          prm.leave_subsection();
        }
      std::ostringstream all;
      if (std::any_of(text.statements.begin(), text.statements.end(), [](const Statement &said) {
            return said.is_override;
          }))
        all << beyond_the_file << '\n';
      prm.print_parameters(
        all, dealii::ParameterHandler::ShortText | dealii::ParameterHandler::KeepDeclarationOrder);
      return all.str();
    }


    /** What the command line said, and where meshes lie that the scene names by its own folder. */
    std::vector<Statement> statements_beyond_the_file(const SceneText              &text,
                                                      const std::vector<NamedMesh> &meshes)
    {
      std::vector<Statement> later(text.statements.end() - text.n_overrides, text.statements.end());
      for (const NamedMesh &mesh : meshes)
        if (text.find(mesh.section, "File")->value != mesh.path)
          later.push_back({mesh.section, "File", mesh.path, ""});
      if (const std::string plugins = join(plugins_of(text), ", ");
          !plugins.empty() && text.find({}, key_of_plugins)->value != plugins)
        later.push_back({{}, key_of_plugins, plugins, ""});
      return later;
    }
  } // namespace

  unsigned int read_dimension(const std::string &file_name, const std::vector<Override> &overrides)
  {
    const SceneText                text = read_scene_text(file_name, overrides);
    const dealii::ParameterHandler no_values;
    const Statement               *statement = text.find({}, "Dimension");
    if (statement == nullptr)
      return 3;
    if (statement->value != "2" && statement->value != "3")
      SectionReader(no_values, text).fail("Dimension", dimension_remedy);
    return statement->value == "2" ? 2 : 3;
  }

  template <int dim>
  Scene<dim> read_scene(const std::string &file_name, const std::vector<Override> &overrides)
  {
    SceneText text = read_scene_text(file_name, overrides);
    load_plugins(text);
    const SceneNames         names = read_scene_names(text);
    dealii::ParameterHandler prm;
    declare_scene<dim>(prm, names);
    apply_statements(text, prm);

    const SectionReader in(prm, text);
    check_top_level<dim>(in);
    Scene<dim> scene;
    scene.file_name        = file_name;
    scene.output_directory = in.text("Output directory");
    scene.time             = parse_time(in.section("Time"));
    scene.step_sizes       = parse_step_sizes(in.section("Time"), scene.time);
    for (const std::string &name : names.bodies)
      scene.bodies.push_back(parse_body<dim>(in.section("Bodies").section(name), name));
    check_start(in.section("Bodies"), scene);
    check_initial_velocities(in.section("Bodies"), scene);
    for (const std::string &name : names.obstacles)
      scene.obstacles.push_back(
        parse_obstacle<dim>(in.section("Obstacles").section(name), name, scene.time));
    scene.pairs = parse_pairs(in.section("Contact"), names.pairs, scene);
    check_damping(in.section("Bodies"), scene);
    check_dirichlet(in.section("Bodies"), scene);
    scene.adaptivity = parse_adaptivity(in.section("Adaptivity"), scene.time, scene.bodies);
    set_goal_of_steps(
      in.section("Time"), !scene.pairs.empty(), scene.adaptivity.target_error, scene.step_sizes);
    parse_contact_motion(in.section("Contact"), scene);
    scene.mapping = cell_geometry(in.choice<MappingChoice>("Mapping"), scene);
    parse_probes(in.section("Probes"), names.probes, scene);
    check_goal(in.section("Adaptivity"), scene);
    scene.exact_solution = parse_exact_solution<dim>(in.section("Exact solution"), scene.bodies);
    scene.solver         = parse_solver(in.section("Solver"), has_friction(scene.pairs));
    scene.output         = parse_output(in.section("Output"));
    check_fclib(in.section("Output"), scene);
    scene.checkpoint = parse_checkpoint(in.section("Checkpoint"));

    const auto meshes = meshes_of(scene);
    for (const NamedMesh &mesh : meshes)
      scene.input_files[join(mesh.section, "/") + "/File"] = mesh.path;
    for (const std::string &plugin : plugins_of(text))
      scene.input_files[key_of_plugins + (" " + plugin)] = plugin;
    scene.overrides      = overrides;
    scene.original_text  = repeatable_text(text, statements_beyond_the_file(text, meshes));
    scene.all_parameters = print_all(text, prm, meshes);
    return scene;
  }

  template Scene<2> read_scene<2>(const std::string &, const std::vector<Override> &);
  template Scene<3> read_scene<3>(const std::string &, const std::vector<Override> &);
} // namespace signorini
