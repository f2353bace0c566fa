// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/command_line.h>
#include <signorini/base/failure.h>
#include <signorini/prm/new_scene.h>
#include <signorini/prm/plugins.h>
#include <signorini/scene/explain_key.h>
#include <signorini/scene/read_scene.h>
#include <signorini/simulation/run_program.h>
#include <signorini/simulation/run_scene.h>

#include <deal.II/base/exceptions.h>

#include <iostream>

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
      if (options.scene_file.empty())
        load_plugins(plugins_without_a_scene(options.overrides));
      if (options.new_scene) // written without MPI, unless that is not possible
        write_new_scene(*options.new_scene);
      if (!options.explain.empty()) // it is printed without MPI, unless there is no such key
        explain_key(options.explain, std::cout);
      dimension = read_dimension(options.scene_file, options.overrides);
    });
    if (status != 0)
      return status;
    return dimension == 2 ? run_scene<2>(options, comm, reporter)
                          : run_scene<3>(options, comm, reporter);
  }
} // namespace signorini
