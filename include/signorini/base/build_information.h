// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_build_information_h
#define signorini_base_build_information_h

#include <string>

namespace signorini
{
  /**
   * The commit of the sources that this program was built from, with "-modified" behind it if they
   * differed from it; "unknown" without a repository.
   */
  std::string commit();

  /** Name and version of the program, and the version of deal.II: one line. */
  std::string version();

  /** The same with the commit. */
  std::string version_and_commit();

  /** The libraries whose versions may change results, and the MPI that the program runs with. */
  std::string libraries();

  /** The compiler, its kind of build, and the options of the project. */
  std::string compiler();
} // namespace signorini

#endif
