// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_program_run_program_h
#define signorini_program_run_program_h

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace signorini
{
  /**
   * What the program does between start and end of MPI: understand the command line, then read,
   * check and simulate the scene. Collective. What goes wrong is printed once, in one line.
   *
   * @param arguments of the command line, without the name of the program
   * @return the exit status of the program
   */
  int run_program(const std::vector<std::string> &arguments, MPI_Comm comm);
} // namespace signorini

#endif
