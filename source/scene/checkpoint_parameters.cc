// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
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
