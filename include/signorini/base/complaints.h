// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_complaints_h
#define signorini_base_complaints_h

#include <deal.II/base/mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /**
   * How bad something is that a process has found in its part of the scene, and the message to the
   * user.
   */
  using Complaint = std::pair<double, std::string>;

  /**
   * Throw the worst complaint of all processes on all of them, so that they end alike; among
   * equally bad ones the first in the alphabet, so that the number of processes does not matter.
   * Collective.
   * @throws UserError if there is any complaint
   */
  void throw_worst(const std::vector<Complaint> &complaints, MPI_Comm communicator);

  /**
   * What the expressions of a scene give at a time of the run must be numbers: ends the run alike
   * on all processes. Collective.
   * @param not_numbers keys whose values on this process are not finite
   * @throws RunError naming one of them, the same on all processes, and the time
   */
  void throw_if_any_is_no_number(const std::vector<std::string> &not_numbers,
                                 double                          time,
                                 MPI_Comm                        communicator);
} // namespace signorini

#endif
