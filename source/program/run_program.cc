// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/command_line.h>
#include <signorini/base/failure.h>
#include <signorini/program/print_information.h>
#include <signorini/program/run_program.h>
#include <signorini/program/run_scene.h>
#include <signorini/scene/read_scene.h>

#include <deal.II/base/exceptions.h>

namespace signorini
{
  int run_program(const std::vector<std::string> &arguments, const MPI_Comm comm)
  {
    dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
    dealii::deal_II_exceptions::disable_abort_on_exception();
    const FailureReporter reporter(comm);

    CommandLine  options;
    unsigned int dimension = 0;
    const int    status    = reporter.separately([&] {
      options = parse_command_line(arguments);
      if (options.runs_a_scene())
        dimension = read_dimension(options.scene_file, options.overrides);
      else if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
        print_information(options);
    });
    if (status != 0 || !options.runs_a_scene())
      return status;
    return dimension == 2 ? run_scene<2>(options, comm, reporter)
                          : run_scene<3>(options, comm, reporter);
  }
} // namespace signorini
