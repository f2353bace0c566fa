// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/command_line.h>
#include <signorini/base/failure.h>
#include <signorini/base/start_of_mpi.h>
#include <signorini/base/user_error.h>
#include <signorini/program/print_information.h>
#include <signorini/program/program.h>
#include <signorini/program/run_program.h>
#include <signorini/program/standard_output.h>

#include <deal.II/base/mpi.h>

#include <optional>

namespace signorini
{
  namespace
  {
    /**
     * What needs no MPI, whose start takes longer, is printed without, by the first process.
     * @return the exit status; none: that is for all processes together
     */
    std::optional<int> print_without_mpi(const std::vector<std::string> &arguments)
    {
      CommandLine options;
      try
        {
          options = parse_command_line(arguments);
        }
      catch (const UserError &)
        {
          return {};
        }
      if (options.runs_a_scene())
        return {};
      const std::string rank = launched_rank();
      if (!rank.empty() && rank != "0")
        return 0;
      const Failure failure = attempt([&] { print_information(options); });
      if (failure.status != 0)
        report(failure);
      return failure.status;
    }
  } // namespace
} // namespace signorini


int signorini_program(int argc, char **argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (const std::optional<int> status = signorini::print_without_mpi(arguments))
    return signorini::with_standard_output(*status);
  signorini::make_mpi_start_quickly();
  // deal.II would hand the options on to other libraries, and PETSc comments on what it does not
  // know.
  int                                      only_the_name = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(only_the_name, argv, 1);
  return signorini::with_standard_output(signorini::run_program(arguments, MPI_COMM_WORLD));
}
