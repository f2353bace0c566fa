// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_sections_h
#define signorini_scene_sections_h

#include <signorini/prm/section_reader.h>
#include <signorini/scene/scene.h>
#include <signorini/scene/scene_names.h>

namespace dealii
{
  class ParameterHandler;
}

namespace signorini
{
  // A declare_ and a parse_ function per section, in the order in which a scene tells its story.
  // declare_ says which keys exist, with default, pattern and description; parse_ checks what a
  // pattern cannot and returns plain data. The handler is inside of the section when declare_ is
  // called, and the reader when parse_ is called.

  void           declare_time(dealii::ParameterHandler &prm);
  TimeParameters parse_time(const SectionReader &in);

  // More keys of the section Time.
  void declare_scheme_parameters(dealii::ParameterHandler &prm);
  /** Needs the name of the scheme. */
  void               parse_scheme_parameters(const SectionReader &in, TimeParameters &time);
  void               declare_step_sizes(dealii::ParameterHandler &prm);
  StepSizeParameters parse_step_sizes(const SectionReader &in, const TimeParameters &time);
  /** `Step size control = force` needs pairs, and the tolerance of `goal` is the target. */
  void set_goal_of_steps(const SectionReader &in,
                         bool                 any_pairs,
                         double               target_error,
                         StepSizeParameters  &sizes);

  template <int dim>
  void declare_body(dealii::ParameterHandler &prm);
  template <int dim>
  BodyDescription<dim> parse_body(const SectionReader &in, const std::string &name);

  // The parts of a body's section.
  template <int dim>
  void declare_shape(dealii::ParameterHandler &prm);
  template <int dim>
  void parse_shape(const SectionReader &in, BodyDescription<dim> &body);
  template <int dim>
  void declare_placement(dealii::ParameterHandler &prm);
  /** Needs the shape of the body. */
  template <int dim>
  Placement<dim> parse_placement(const SectionReader &in, const BodyDescription<dim> &body);
  void           declare_material(dealii::ParameterHandler &prm);
  Material       parse_material(const SectionReader &in);
  template <int dim>
  void declare_conditions(dealii::ParameterHandler &prm);
  template <int dim>
  void parse_conditions(const SectionReader &in, BodyDescription<dim> &body);

  template <int dim>
  void declare_obstacle(dealii::ParameterHandler &prm);
  template <int dim>
  NamedObstacle<dim>
  parse_obstacle(const SectionReader &in, const std::string &name, const TimeParameters &time);

  // The part of a pair's section; expressions are tried at points of the slave.
  void declare_friction(dealii::ParameterHandler &prm);
  template <int dim>
  FrictionDescription parse_friction(const SectionReader                   &in,
                                     const std::string                     &scheme,
                                     const std::vector<dealii::Point<dim>> &points);

  void declare_pair(dealii::ParameterHandler &prm);
  template <int dim>
  std::vector<PairDescription>
  parse_pairs(const SectionReader &in, const std::vector<PairName> &names, const Scene<dim> &scene);

  void declare_contact_motion(dealii::ParameterHandler &prm);
  /** Needs all that contact depends on: schemes, bodies, pairs, adaptivity. */
  template <int dim>
  void parse_contact_motion(const SectionReader &in, Scene<dim> &scene);

  void declare_adaptivity(dealii::ParameterHandler &prm);
  template <int dim>
  AdaptivityParameters parse_adaptivity(const SectionReader                     &in,
                                        const TimeParameters                    &time,
                                        const std::vector<BodyDescription<dim>> &bodies);
  /** The goal of the meshes needs pairs, and probes if it is their stress. */
  template <int dim>
  void check_goal(const SectionReader &in, const Scene<dim> &scene);

  template <int dim>
  void declare_probe(dealii::ParameterHandler &prm);
  /** Adds the probe to the scene, which knows its bodies and pairs. */
  template <int dim>
  void parse_probe(const SectionReader &in, const std::string &name, Scene<dim> &scene);

  template <int dim>
  void declare_exact_solution(dealii::ParameterHandler &prm);
  template <int dim>
  ExactSolutionDescription<dim>
  parse_exact_solution(const SectionReader &in, const std::vector<BodyDescription<dim>> &bodies);

  void             declare_solver(dealii::ParameterHandler &prm);
  SolverParameters parse_solver(const SectionReader &in, bool with_friction);

  void             declare_output(dealii::ParameterHandler &prm);
  OutputParameters parse_output(const SectionReader &in);
  /** Whether FCLIB has words for the problems of the steps. @throws UserError */
  template <int dim>
  void check_fclib(const SectionReader &in, const Scene<dim> &scene);

  void                 declare_checkpoint(dealii::ParameterHandler &prm);
  CheckpointParameters parse_checkpoint(const SectionReader &in);

  /** All of it: the top level, every section, and one subsection for each of the names. */
  template <int dim>
  void declare_scene(dealii::ParameterHandler &prm, const SceneNames &names);
} // namespace signorini

#endif
