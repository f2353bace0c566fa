// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A program of your own: signorini with the parts of this example built in, so that scenes need no
// plug-in. Its command line is that of signorini.

#include "parts.h"

#include <signorini/program/run_program.h>

#include <deal.II/base/mpi.h>

int main(int argc, char **argv)
{
  int                                      only_the_name = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(only_the_name, argv, 1);
  add_washboard();
  add_ring();
  add_damped_scheme();
  add_alloy();
  return signorini::run_program(std::vector<std::string>(argv + 1, argv + argc), MPI_COMM_WORLD);
}
