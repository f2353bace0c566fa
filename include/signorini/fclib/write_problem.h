// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_fclib_write_problem_h
#define signorini_fclib_write_problem_h

#include <signorini/fclib/frictional_problem.h>

#include <string>

namespace signorini
{
  /**
   * Write a file of FCLIB (format of its version 3): the groups `fclib_global`, `fclib_local` if
   * the problem is small enough, and `solution`. Readers of FCLIB find what they ask for; numbers
   * of the step are attributes of the file.
   * @throws RunError naming the file if it cannot be written
   */
  void write_problem(const std::string &path, const FrictionalProblem &problem);
} // namespace signorini

#endif
