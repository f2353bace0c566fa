// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_whole_file_h
#define signorini_output_whole_file_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <ostream>
#include <string>

namespace signorini
{
  /**
   * Write a file under a temporary name and rename it when it is complete: whoever looks finds the
   * old file or the new one, never half of it. Not collective.
   * @throws RunError naming the file if it cannot be written, for example on a full disk
   */
  void write_whole_file(const std::string &path, const std::function<void(std::ostream &)> &write);

  /**
   * "cannot write `path`: No space left on device", as an exception. @param error_number an errno,
   * or 0 if unknown.
   */
  [[noreturn]] void throw_write_error(const std::string &path, int error_number);

  /**
   * Do something without communication, and let all processes agree on how it ended. Collective. An
   * action that is not meant for a process is simply empty there.
   * @throws RunError on all processes, with the message of the first one that failed
   */
  void succeed_together(MPI_Comm communicator, const std::function<void()> &action);
} // namespace signorini

#endif
