// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_program_print_information_h
#define signorini_program_print_information_h

#include <signorini/base/command_line.h>

namespace signorini
{
  /**
   * Answer to options that ask for information only, and to no scene at all. Needs no MPI.
   * @throws UserError if there is no such key, scene to start from, or plug-in
   */
  void print_information(const CommandLine &options);
} // namespace signorini

#endif
