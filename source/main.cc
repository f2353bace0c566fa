// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/command_line.h>
#include <signorini/base/failure.h>
#include <signorini/scene/read_scene.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/run_scene.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <iostream>

namespace
{
  using namespace signorini;

  void print_information(const CommandLine &options)
  {
    if (options.help)
      std::cout << help();
    else if (options.version)
      std::cout << version();
    else if (options.print_parameters)
      print_parameters(std::cout);
    else if (options.print_schemes)
      (options.as_json ? print_schemes_as_json : print_schemes)(std::cout);
    else
      std::cout << short_help();
  }
} // namespace

int main(int argc, char **argv)
{
  // deal.II would hand the options on to other libraries, and PETSc comments on what it does not
  // know.
  int                                      only_the_name = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(only_the_name, argv, 1);
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const MPI_Comm        comm = MPI_COMM_WORLD;
  const FailureReporter reporter(comm);

  CommandLine  options;
  unsigned int dimension = 0;
  const int    status    = reporter.separately([&] {
    options = parse_command_line({argv + 1, argv + argc});
    if (options.help || options.version || options.print_parameters || options.print_schemes)
      options.scene_file.clear();
    if (!options.scene_file.empty())
      dimension = read_dimension(options.scene_file, options.overrides);
  });
  if (status != 0)
    return status;

  if (dimension == 2)
    return run_scene<2>(options, comm, reporter);
  if (dimension == 3)
    return run_scene<3>(options, comm, reporter);
  if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
    print_information(options);
  return 0;
}
