// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_user_error_h
#define signorini_base_user_error_h

#include <stdexcept>
#include <string>

namespace signorini
{
  /**
   * A mistake in the command line or in the scene. The message names key, value and remedy; what
   * reads or runs a scene adds the name of its file, see naming_file(). main() prints it once (rank
   * 0) and exits with status 2.
   */
  class UserError : public std::runtime_error
  {
  public:
    explicit UserError(const std::string &message)
      : std::runtime_error(message)
    {
    }
  };

  /**
   * The run failed although the scene is in order (a solver did not converge, a file could not be
   * written). main() prints the message once and exits with status 1; what was written before stays
   * whole.
   */
  class RunError : public std::runtime_error
  {
  public:
    explicit RunError(const std::string &message)
      : std::runtime_error(message)
    {
    }
  };

  /**
   * A step could not be solved from its state with its size; another size may do. All processes
   * throw it together, so that what leads the steps can try again.
   */
  class StepError : public RunError
  {
  public:
    using RunError::RunError;
  };

  /**
   * Call a function, and put the name of a file in front of the message of an error that leaves
   * it.
   */
  template <typename Error, typename Action>
  auto naming_file(const std::string &file_name, const Action &action)
  {
    try
      {
        return action();
      }
    catch (const Error &error)
      {
        throw Error(file_name + ": " + error.what());
      }
  }
} // namespace signorini

#endif
