// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>
#include <signorini/base/command_line.h>
#include <signorini/base/user_error.h>
#include <signorini/prm/new_scene.h>
#include <signorini/prm/plugins.h>
#include <signorini/scene/explain_key.h>
#include <signorini/scene/read_scene.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/run_program.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <iostream>

namespace
{
  using namespace signorini;

  void print_information(const CommandLine &options)
  {
    load_plugins(options.scene_file.empty()
                   ? plugins_without_a_scene(options.overrides)
                   : read_scene_text(options.scene_file, options.overrides));
    if (options.help)
      std::cout << help();
    else if (options.version)
      std::cout << version_and_commit();
    else if (options.new_scene)
      std::cout << write_new_scene(*options.new_scene);
    else if (!options.explain.empty())
      explain_key(options.explain, std::cout);
    else if (options.print_parameters)
      print_parameters(std::cout);
    else if (options.print_schemes)
      (options.as_json ? print_schemes_as_json : print_schemes)(std::cout);
    else
      std::cout << short_help();
  }

  /** The rank in a run that a launcher has started, before MPI knows; none: started alone. */
  const char *rank_by_launcher()
  {
    for (const char *name :
         {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "MPI_LOCALRANKID", "SLURM_PROCID"})
      if (const char *rank = std::getenv(name))
        return rank;
    return nullptr;
  }

  /** What needs no MPI, whose start takes longer, is printed without. @return whether it was */
  bool print_at_once(const std::vector<std::string> &arguments)
  {
    try
      {
        const CommandLine options = parse_command_line(arguments);
        if (!options.scene_file.empty() && !options.asks_for_information_only())
          return false;
        const char *rank = rank_by_launcher();
        if (rank == nullptr || std::string(rank) == "0")
          print_information(options);
        return true;
      }
    catch (const UserError &)
      {
        return false; // to be reported by all processes together
      }
  }
} // namespace

int main(int argc, char **argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (print_at_once(arguments))
    return 0;
  // A process that was started alone would make OpenMPI start a daemon, which serves to start
  // more processes only, and takes a quarter of a second.
  if (rank_by_launcher() == nullptr)
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  // deal.II would hand the options on to other libraries, and PETSc comments on what it does not
  // know.
  int                                      only_the_name = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(only_the_name, argv, 1);
  return run_program(arguments, MPI_COMM_WORLD);
}
