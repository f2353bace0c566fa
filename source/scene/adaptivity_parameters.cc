// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/scene/sections.h>
#include <signorini/schemes/scheme_table.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  namespace
  {
    constexpr unsigned int highest_level = 15;

    /**
     * The keys but for `Indicator`, with their defaults. A key counts as given if it has another
     * value: `parameters.prm` lists all keys and must be read without complaint.
     */
    const std::vector<std::pair<std::string, std::string>> defaults = {
      {"Goal", name_of(GoalKind::energy)},
      {"Target error", "0"},
      {"Marking", name_of(MarkingKind::fixed_fraction)},
      {"Refine fraction", "0.5"},
      {"Coarsen fraction", "0.02"},
      {"Coarsen ratio", "0"},
      {"Tolerance", "0"},
      {"Hysteresis", "0.1"},
      {"Maximum level", "0"},
      {"Minimum level", "0"},
      {"Maximum cells", "0"},
      {"Steps between remeshings", "0"},
      {"Repetitions", "0"},
      {"Distance", "0"}};

    std::string default_of(const std::string &key)
    {
      return std::find_if(defaults.begin(),
                          defaults.end(),
                          [&](const auto &entry) { return entry.first == key; })
        ->second;
    }

    void refuse_if_given(const SectionReader            &in,
                         const std::vector<std::string> &keys,
                         const std::string              &reason)
    {
      for (const std::string &key : keys)
        if (in.text(key) != default_of(key))
          in.fail(key, reason);
    }

    double fraction(const SectionReader &in,
                    const std::string   &key,
                    const double         largest,
                    const std::string   &meaning)
    {
      const double value = in.number(key);
      if (!(value >= 0. && value <= largest))
        in.fail(key,
                "must lie between 0 and " + std::string(largest == 1. ? "1" : "0.5") + ": "
                  + meaning);
      return value;
    }

    double not_negative(const SectionReader &in, const std::string &key, const std::string &remedy)
    {
      const double value = in.number(key);
      if (!(value >= 0. && value <= std::numeric_limits<double>::max()))
        in.fail(key, "must not be negative. " + remedy);
      return value;
    }

    /**
     * Refuse keys that the chosen indicator and marking do not look at. Without an indicator they
     * may stay, so that it is easily switched off.
     */
    void check_that_keys_fit(const SectionReader &in, const AdaptivityParameters &adaptivity)
    {
      if (adaptivity.indicator == IndicatorKind::distance)
        refuse_if_given(
          in,
          {"Goal", "Marking", "Refine fraction", "Coarsen fraction", "Coarsen ratio", "Tolerance"},
          "belongs to indicators that estimate an error, but Indicator = distance refines by "
          "`Distance` alone. Remove this key.");
      if (adaptivity.has_target())
        refuse_if_given(in,
                        {"Marking", "Refine fraction", "Coarsen fraction", "Tolerance"},
                        "belongs to `Goal = energy`; with Goal = " + in.text("Goal")
                          + " cells get equal shares of `Target error`. Remove this key.");
      else
        refuse_if_given(in,
                        {"Target error"},
                        "is relative to a force or stress, but Goal = energy. Set `Goal = contact "
                        "force`, `contact pressure` or `probe`, or remove this key.");
      if (adaptivity.marking == MarkingKind::tolerance)
        refuse_if_given(in,
                        {"Refine fraction", "Coarsen fraction"},
                        "belongs to `Marking = fixed fraction`, but Marking = tolerance compares "
                        "with `Tolerance`. Remove this key.");
    }

    /** Whoever says that meshes shall stay, may keep the other keys; whoever forgets it, may not.
     */
    void check_that_staying_is_meant(const SectionReader &in)
    {
      if (!in.given("Indicator"))
        refuse_if_given(in,
                        {"Goal", "Maximum level", "Maximum cells", "Tolerance", "Distance"},
                        "has no effect, as no `Indicator` is given: the mesh stays as it is. Set "
                        "`Indicator = residual` (or another one) for a mesh that changes, or "
                        "`Indicator = none`.");
    }

    void check_target(const SectionReader &in, const AdaptivityParameters &adaptivity)
    {
      if (!adaptivity.has_target())
        return;
      if (adaptivity.indicator != IndicatorKind::residual)
        in.fail("Goal",
                "needs the estimate of `Indicator = residual`. Set it, or remove this key.");
      if (adaptivity.target_error == 0.)
        in.fail("Target error",
                "is missing, but Goal = " + in.text("Goal")
                  + " refines until it is met. Give for example 0.01.");
    }

    template <int dim>
    void check_levels(const SectionReader                     &in,
                      const AdaptivityParameters              &adaptivity,
                      const std::vector<BodyDescription<dim>> &bodies)
    {
      const auto &coarsest =
        *std::min_element(bodies.begin(), bodies.end(), [](const auto &a, const auto &b) {
          return a.refinements < b.refinements;
        });
      const std::string initial = "the initial mesh has level "
                                  + std::to_string(coarsest.refinements) + " (`Bodies/"
                                  + coarsest.name + "/Refinements`) or more. ";
      // With a target the error of any mesh can be looked at, uniform ones included.
      if (adaptivity.has_target() && adaptivity.maximum_level < std::max(coarsest.refinements, 1u))
        in.fail("Maximum level",
                "must not be less than the mesh begins with: " + initial
                  + "Give this number to have the mesh judged only, or a larger one.");
      if (!adaptivity.has_target() && adaptivity.maximum_level <= coarsest.refinements)
        in.fail("Maximum level", "leaves nothing to refine: " + initial + "Give a larger number.");
      if (adaptivity.minimum_level >= adaptivity.maximum_level)
        in.fail("Minimum level",
                "must be smaller than `Maximum level` = " + in.text("Maximum level")
                  + ". Reduce it, or remove this key.");
    }

    /** Contact nodes without mass cannot be carried from mesh to mesh. */
    void check_mass(const SectionReader        &in,
                    const AdaptivityParameters &adaptivity,
                    const TimeParameters       &time)
    {
      const bool massless = time.mass.has_massless_contact_nodes();
      if (adaptivity.any() && (massless || !scheme_info(time.scheme).changing_mesh))
        in.fail("Indicator",
                "does not fit Scheme = " + time.scheme + " with Mass = " + name_of(time.mass.kind)
                  + ": contact nodes have no mass, so that on a new mesh their acceleration is not "
                    "defined, and the mass built anew has another kinetic energy of the same "
                    "motion. Set `Indicator = none`, or take `Mass = consistent` and one of the "
                    "schemes "
                  + join(schemes_where([](const SchemeInfo &info) { return info.changing_mesh; }))
                  + ".");
    }
  } // namespace


  namespace
  {
    /** A key with its default. */
    void declare(dealii::ParameterHandler            &prm,
                 const std::string                   &key,
                 const dealii::Patterns::PatternBase &pattern,
                 const std::string                   &text)
    {
      prm.declare_entry(key, default_of(key), pattern, text);
    }


    void declare_goal(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      declare(
        prm,
        "Goal",
        choices_of<GoalKind>(),
        "Of residual: what the mesh is made for. energy: the error of the motion in the "
        "energy norm. contact force: the error of the sum of the contact forces, down to "
        "`Target error`; what no contact force will feel is left coarse. contact pressure: "
        "that, and the error of the pressure on the contact surfaces, L2 in space and time. "
        "probe: that of the force, and the errors of the stress at all `Probes` (the pressure "
        "at probes on contact surfaces).");
      declare(
        prm,
        "Target error",
        Double(),
        "Of goals other than energy: the error that the mesh may cause, relative to the force or "
        "the stress and L2 in time (no unit), between 0 and 1. Estimated; cells get equal shares "
        "of it in units of the largest force or stress so far, or of the force that a slow "
        "approach will soon bring. Steps may cause as much again with Time/Step size control = "
        "goal, on any mesh.");
    }


    void declare_marking(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      prm.declare_entry("Indicator",
                        name_of(IndicatorKind::none),
                        choices_of<IndicatorKind>(),
                        "What tells where the mesh is too coarse or finer than needed. none: the "
                        "mesh stays as it is. residual: estimate of the error of a step in the "
                        "energy norm, from the residual inside of the cells, the jumps of the "
                        "stress between them and the error of the contact condition. kelly: the "
                        "jumps of the stress alone. distance: no estimate; cells of contact "
                        "surfaces are refined that are, or soon will be, closer than `Distance` to "
                        "the other side.");
      declare(
        prm,
        "Marking",
        choices_of<MarkingKind>(),
        "Of residual and kelly. fixed fraction: refine the cells with the largest indicators, as "
        "few as make `Refine fraction` of the whole, and coarsen those with the smallest that make "
        "`Coarsen fraction`. tolerance: refine the cells that have more than their equal share of "
        "`Tolerance`, coarsen those far below it.");
      declare(prm,
              "Refine fraction",
              Double(),
              "Of Marking = fixed fraction: the part of the squared estimate that the cells to be "
              "refined make together (no unit), between 0 (none) and 1 (all).");
      declare(prm,
              "Coarsen fraction",
              Double(),
              "Of Marking = fixed fraction: the part of the squared estimate that the cells to be "
              "coarsened make at most together (no unit), between 0 and 0.5.");
      declare(prm,
              "Coarsen ratio",
              Double(),
              "Of residual and kelly: cells are coarsened only where the squared indicator is "
              "below this part of the threshold of refinement (no unit), between 0 and 1. 0: 1/32 "
              "in 2d, 1/64 in 3d, so that the coarser cell of a smooth solution is not refined "
              "again at once. Fronts that run through a body leave fine cells behind them with "
              "that; give 0.25 to 0.5 there.");
      declare(prm,
              "Tolerance",
              Double(),
              "Of residual and kelly, in units of the root of an energy: nothing is refined as "
              "long as the estimate of the whole mesh is smaller. Must be given for Marking = "
              "tolerance; 0: none.");
      declare(prm,
              "Hysteresis",
              Double(),
              "A mesh that is good enough is kept: it changes only if the cells to be refined make "
              "at least this part of the squared estimate (with distance: if there are any), or "
              "those to be coarsened this part of all cells (no unit), between 0 and 0.5.");
    }


    void declare_limits(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      declare(prm,
              "Maximum level",
              Integer(),
              "Cells of this level are not refined. The level counts refinements of the coarse "
              "mesh, as `Refinements` of a body does. Must be given unless Indicator = none.");
      declare(prm,
              "Minimum level",
              Integer(),
              "Cells of this level are not coarsened. Cells of the initial uniform mesh (level "
              "`Refinements` of their body) never are.");
      declare(prm,
              "Maximum cells",
              Integer(),
              "Refinement stops at about this number of cells of all bodies together, not less "
              "than the run begins with. 0: no limit.");
      declare(prm,
              "Steps between remeshings",
              Integer(),
              "The mesh is judged, and may change, after every so many steps. 0: it changes when "
              "what steps have lost on it amounts to the cost of a change.");
      declare(prm,
              "Repetitions",
              Integer(),
              "How often a step may be repeated on a refined mesh before it is accepted, at most "
              "20. 0: the mesh that a step asks for serves the next one. (With a `Target error` "
              "steps that are far from the target are repeated anyway.)");
      declare(prm,
              "Distance",
              Double(),
              "In units of length: cells are refined that have nodes closer than this to the other "
              "side, and coarsened when they are 2.5 times farther away. With Indicator = distance "
              "0 means three times the size of each cell, so that the mesh becomes finer towards "
              "the contact. With residual and kelly 0 means that contact is refined as the "
              "estimate says; otherwise such cells are refined up to `Maximum level` before they "
              "touch.");
    }
  } // namespace


  void declare_adaptivity(dealii::ParameterHandler &prm)
  {
    declare_goal(prm);
    declare_marking(prm);
    declare_limits(prm);
  }


  template <int dim>
  AdaptivityParameters parse_adaptivity(const SectionReader                     &in,
                                        const TimeParameters                    &time,
                                        const std::vector<BodyDescription<dim>> &bodies)
  {
    AdaptivityParameters adaptivity;
    adaptivity.indicator = in.choice<IndicatorKind>("Indicator");
    adaptivity.goal      = in.choice<GoalKind>("Goal");
    adaptivity.marking   = in.choice<MarkingKind>("Marking");
    if (adaptivity.any())
      check_that_keys_fit(in, adaptivity);
    else
      check_that_staying_is_meant(in);
    check_mass(in, adaptivity, time);
    adaptivity.refine_fraction =
      fraction(in, "Refine fraction", 1., "it is a part of the whole. Give for example 0.5.");
    adaptivity.coarsen_fraction = fraction(
      in, "Coarsen fraction", 0.5, "coarsening must not undo refinement. Give for example 0.02.");
    adaptivity.coarsen_ratio = fraction(
      in,
      "Coarsen ratio",
      1.,
      "it is a part of the threshold of refinement. Give for example 0.25, or 0 for the default.");
    adaptivity.hysteresis = fraction(
      in, "Hysteresis", 0.5, "with more the mesh would hardly ever change. Give for example 0.1.");
    adaptivity.target_error = fraction(
      in, "Target error", 1., "it is a part of the force or stress. Give for example 0.01.");
    adaptivity.tolerance = not_negative(in, "Tolerance", "Give a positive number, or 0 for none.");
    adaptivity.distance  = not_negative(in, "Distance", "Give a length, or 0 for the default.");
    adaptivity.maximum_level = in.integer("Maximum level", 0, highest_level);
    adaptivity.minimum_level = in.integer("Minimum level", 0, highest_level);
    adaptivity.maximum_cells = in.integer("Maximum cells", 0, SectionReader::unlimited);
    adaptivity.steps_between = in.integer("Steps between remeshings", 0, SectionReader::unlimited);
    adaptivity.repetitions   = in.integer("Repetitions", 0, 20);
    if (!adaptivity.any())
      return adaptivity;
    if (adaptivity.marking == MarkingKind::tolerance && adaptivity.tolerance == 0.)
      in.fail("Tolerance",
              "is missing, but Marking = tolerance compares with it. Give a positive number.");
    check_target(in, adaptivity);
    check_levels(in, adaptivity, bodies);
    return adaptivity;
  }


  template <int dim>
  void check_goal(const SectionReader &in, const Scene<dim> &scene)
  {
    if (!scene.adaptivity.has_target())
      return;
    if (scene.pairs.empty())
      in.fail("Goal",
              "makes meshes for the force of a contact and what follows from it, but the scene has "
              "no contact pair. Add one to `Contact/Pairs`, or set `Goal = energy`.");
    if (scene.adaptivity.goal == GoalKind::probe && scene.probes.empty()
        && scene.point_probes.empty())
      in.fail("Goal",
              "aims at the stress at probes, but the scene has none. Add one to `Probes/Names`, or "
              "set another goal.");
  }


  template void                 check_goal(const SectionReader &, const Scene<2> &);
  template void                 check_goal(const SectionReader &, const Scene<3> &);
  template AdaptivityParameters parse_adaptivity(const SectionReader &,
                                                 const TimeParameters &,
                                                 const std::vector<BodyDescription<2>> &);
  template AdaptivityParameters parse_adaptivity(const SectionReader &,
                                                 const TimeParameters &,
                                                 const std::vector<BodyDescription<3>> &);
} // namespace signorini
