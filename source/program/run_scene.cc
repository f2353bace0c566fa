// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/program/run_scene.h>
#include <signorini/scene/output_directory.h>
#include <signorini/scene/read_scene.h>
#include <signorini/simulation/simulation.h>

#include <iostream>

namespace signorini
{
  template <int dim>
  int run_scene(const CommandLine &options, const MPI_Comm comm, const FailureReporter &reporter)
  {
    const bool first = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
    Scene<dim> scene;
    const int  status = reporter.separately([&] {
      scene = read_scene<dim>(options.scene_file, options.overrides);
      if (first)
        check_output_directory(scene.output_directory);
    });
    if (status != 0)
      return status;

    return reporter.together([&] {
      naming_file<UserError>(scene.file_name, [&] {
        Simulation<dim> simulation(scene, comm, options.quiet);
        if (options.validate)
          {
            const std::string text = simulation.validate(options.as_json);
            if (first)
              std::cout << text << std::flush;
          }
        else if (options.resume)
          simulation.resume();
        else
          simulation.run();
      });
    });
  }

  template int run_scene<2>(const CommandLine &, MPI_Comm, const FailureReporter &);
  template int run_scene<3>(const CommandLine &, MPI_Comm, const FailureReporter &);
} // namespace signorini
