// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_command_line_h
#define signorini_base_command_line_h

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /** What the user asked for. */
  struct CommandLine
  {
    std::string                                      scene_file; ///< file name of the scene
    std::vector<std::pair<std::string, std::string>> overrides;  ///< --set: path of the key, value
    bool                                             validate = false;
    bool                                             resume   = false;
    std::string                                      explain; ///< key or section; empty: none
    std::optional<std::string> new_scene; ///< to be written; an empty name asks for all
    bool                       print_parameters = false;
    bool                       print_schemes    = false;
    bool                       as_json          = false; ///< print for programs
    bool                       quiet            = false;
    bool                       version          = false;
    bool                       help             = false;

    /** Whether there is nothing to run. */
    bool asks_for_information_only() const
    {
      return help || version || print_parameters || print_schemes || !explain.empty() || new_scene;
    }
    /** Or checks it. */
    bool runs_a_scene() const { return !scene_file.empty() && !asks_for_information_only(); }
  };

  /**
   * @param arguments without the name of the program
   * @throws UserError for what cannot be understood
   */
  CommandLine parse_command_line(const std::vector<std::string> &arguments);

  /** What a call without arguments shows: a few lines, and which scene to start with. */
  std::string short_help();

  /** All options. */
  std::string help();
} // namespace signorini

#endif
