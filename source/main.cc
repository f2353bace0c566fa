// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>
#include <signorini/base/command_line.h>
#include <signorini/base/start_of_mpi.h>
#include <signorini/base/user_error.h>
#include <signorini/program/standard_output.h>

#include <dlfcn.h>

#include <iostream>

namespace
{
  using namespace signorini;

  /** What is the same for all scenes and plug-ins. @return whether it was asked for */
  bool print_at_once(const std::vector<std::string> &arguments)
  {
    try
      {
        const CommandLine options = parse_command_line(arguments);
        if (!options.overrides.empty() || !(arguments.empty() || options.help || options.version))
          return false;
        const std::string rank = launched_rank();
        if (rank.empty() || rank == "0")
          std::cout << (options.help      ? help()
                        : options.version ? version_and_commit()
                                          : short_help());
        return true;
      }
    catch (const UserError &)
      {
        return false; // to be reported by all processes together
      }
  }
} // namespace

/**
 * The linker takes a quarter of a second to load the library with all that deal.II brings, so it is
 * loaded only to do something.
 */
int main(int argc, char **argv)
{
  if (print_at_once(std::vector<std::string>(argv + 1, argv + argc)))
    return with_standard_output(0);
  void *const library = dlopen(SIGNORINI_LIBRARY, RTLD_LAZY | RTLD_GLOBAL);
  void *const program = library ? dlsym(library, "signorini_program") : nullptr;
  if (!program)
    {
      std::cerr << "signorini: its library is missing or damaged. Install or build it anew. "
                << dlerror() << "\n";
      return 1;
    }
  return reinterpret_cast<int (*)(int, char **)>(program)(argc, argv);
}
