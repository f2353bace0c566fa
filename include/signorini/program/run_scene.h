// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_program_run_scene_h
#define signorini_program_run_scene_h

#include <signorini/base/command_line.h>
#include <signorini/base/failure.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  /**
   * Read the scene that the user named, and simulate it or only check it (`--validate`). Every
   * process reads the scene; only the first one tries the output folder.
   *
   * @param reporter what goes wrong is printed once, by it
   * @return the exit status of the program
   */
  template <int dim>
  int run_scene(const CommandLine &options, MPI_Comm comm, const FailureReporter &reporter);
} // namespace signorini

#endif
