// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_program_standard_output_h
#define signorini_program_standard_output_h

#include <iostream>

namespace signorini
{
  /**
   * The exit status of a program that has printed: what is lost, on a full disk for example, is
   * told on the standard error and makes a program fail that had not.
   */
  inline int with_standard_output(const int status)
  {
    std::cout.flush();
    if (std::cout)
      return status;
    std::cerr << "signorini: the standard output cannot be written; is the disk full? What a run "
                 "has computed, and its log, is in its output directory.\n";
    return status == 0 ? 1 : status;
  }
} // namespace signorini

#endif
