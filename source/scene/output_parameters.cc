// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>
#include <signorini/schemes/scheme_table.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  namespace
  {
    void declare_tables(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      prm.declare_entry(
        "Supports",
        "true",
        Bool(),
        "Write supports.csv: the force on the body, support_<body>_<id>_x, ..., of "
        "each boundary with a Dirichlet condition. Momentum changes in a step by its "
        "size times the sum of loads, contact and supports, as the scheme applies "
        "them (doc/output.md). A component of a node that two boundaries prescribe "
        "counts for the one that `Dirichlet` names first.");
      prm.declare_entry(
        "Pairs",
        "true",
        Bool(),
        "Write pairs.csv: force on the slave, its moment about the origin, normal "
        "force, friction force, active nodes, smallest gap and penetration of each "
        "contact pair, pair_<k>_..., k = 0, 1, ... in the order of `Contact/Pairs`.");
      prm.declare_entry(
        "Forces",
        "true",
        Bool(),
        "Write forces.csv, if there are pairs: the contact force on each body by the "
        "multipliers, by the stress at its boundary and by the change of its "
        "momentum, force_<body>_..., and their relative spread.");
      prm.declare_entry("Bodies",
                        "true",
                        Bool(),
                        "Write bodies.csv: kinetic and elastic energy, momentum, angular momentum "
                        "about the centroid, centroid and mean velocity of each body, "
                        "body_<name>_....");
    }
  } // namespace


  void declare_output(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("VTU", "true", Bool(), "Write fields for ParaView or VisIt at all.");
    prm.declare_entry("VTU every",
                      "0",
                      Integer(),
                      "Write fields every so many steps; 0: as often as `VTU states` says.");
    prm.declare_entry("VTU states",
                      "20",
                      Integer(),
                      "Without `VTU every`: write fields of so many states, evenly spread over the "
                      "time of the run, besides the initial one; 1: of the last one only.");
    prm.declare_entry(
      "Obstacles",
      "true",
      Bool(),
      "With `VTU`: write the surfaces of the obstacles, as far as they are near the "
      "bodies: those that rest once to obstacles.vtu, those that move with the fields to "
      "obstacles.pvd.");
    prm.declare_entry("History every",
                      "1",
                      Integer(),
                      "Write a row of history.csv and of the other tables every so many steps, and "
                      "one for the last step. Works, iterations and products of the steps between "
                      "are summed into the next row.");
    prm.declare_entry(
      "FCLIB every",
      "0",
      Integer(),
      "Write the contact problem of every so many steps, and its solution, as a "
      "file of the Frictional Contact Library (FCLIB, HDF5), fclib/step_*.hdf5, if "
      "there is contact in the step; 0: none. On one process. See doc/manual/fclib.md.");
    prm.declare_entry("Guard",
                      "stop",
                      Selection("stop|warn"),
                      "What to do when a step breaks a law that its scheme proves (growth of "
                      "energy, adhesion, Coulomb's bound, penetration, momentum) beyond the "
                      "accuracy of the solvers: stop, with a diagnosis and the state written, or "
                      "warn and go on. See doc/output.md.");
    declare_tables(prm);
  }

  OutputParameters parse_output(const SectionReader &in)
  {
    OutputParameters output;
    output.vtu           = in.flag("VTU");
    output.vtu_every     = in.integer("VTU every", 0, SectionReader::unlimited);
    output.vtu_states    = in.integer("VTU states", 1, SectionReader::unlimited);
    output.history_every = in.integer("History every", 1, SectionReader::unlimited);
    output.obstacles     = in.flag("Obstacles");
    output.supports      = in.flag("Supports");
    output.pairs         = in.flag("Pairs");
    output.bodies        = in.flag("Bodies");
    output.guard         = in.choice<GuardAction>("Guard");
    output.forces        = in.flag("Forces");
    output.fclib_every   = in.integer("FCLIB every", 0, SectionReader::unlimited);
    return output;
  }


  template <int dim>
  void check_fclib(const SectionReader &in, const Scene<dim> &scene)
  {
    if (scene.output.fclib_every == 0)
      return;
    const std::string remedy = " Set `FCLIB every = 0`, or ";
    const SchemeInfo &scheme = scheme_info(scene.time.scheme);
    if (!scheme.variable_step())
      in.fail("FCLIB every",
              "writes the problem with inertia that a step solves, and `Time/Scheme = "
                + scene.time.scheme + "` solves none." + remedy + "take another scheme.");
    if (scene.step_sizes.is_variable())
      in.fail("FCLIB every",
              "does not know which of the steps that `Time/Step size control` tries are taken."
                + remedy + "take steps of one size.");
    for (const PairDescription &pair : scene.pairs)
      if (pair.friction.any && !pair.friction.bound.empty())
        in.fail("FCLIB every",
                "writes problems with the law of Coulomb; FCLIB has no bound as that of the pair "
                "`"
                  + pair.name + "`." + remedy + "give a `Friction coefficient` alone.");
    if (has_friction(scene.pairs) && scheme.projects_velocity)
      in.fail("FCLIB every",
              "writes problems whose friction belongs to their own normal forces; `Time/Scheme = "
                + scene.time.scheme + "` adds those of its predictor." + remedy
                + "take another scheme with friction.");
  }

  template void check_fclib(const SectionReader &, const Scene<2> &);
  template void check_fclib(const SectionReader &, const Scene<3> &);


  void declare_checkpoint(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry(
      "Every steps",
      "0",
      Integer(),
      "Write a checkpoint every so many steps, from which `signorini --resume` goes "
      "on; 0: not by steps. On as many processes a resumed run gives the numbers of "
      "the one that was not interrupted, to the last bit.");
    prm.declare_entry("Every minutes",
                      "0",
                      Double(),
                      "Write a checkpoint after so many minutes of wall time; 0: not by time. What "
                      "solvers remember is dropped there, so that results depend on the clock in "
                      "the digits that `Solver/Tolerance` leaves open.");
  }

  CheckpointParameters parse_checkpoint(const SectionReader &in)
  {
    CheckpointParameters checkpoint;
    checkpoint.every_steps   = in.integer("Every steps", 0, SectionReader::unlimited);
    checkpoint.every_minutes = in.number("Every minutes");
    if (checkpoint.every_minutes < 0.)
      in.fail("Every minutes", "is negative. Give minutes, or 0 for no checkpoints by time.");
    return checkpoint;
  }
} // namespace signorini
