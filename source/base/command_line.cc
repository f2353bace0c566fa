// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/command_line.h>
#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>

namespace signorini
{
  namespace
  {
    const std::vector<std::string> options = {"--set",
                                              "--validate",
                                              "--resume",
                                              "--explain",
                                              "--new",
                                              "--print-parameters",
                                              "--print-schemes",
                                              "--quiet",
                                              "--version",
                                              "--help"};

    std::pair<std::string, std::string> parse_override(const std::string &assignment)
    {
      const std::size_t equal = assignment.find('=');
      if (equal == std::string::npos || trim(assignment.substr(0, equal)).empty())
        throw UserError(
          "--set \"" + assignment
          + "\": a key and a value are needed. Write --set \"Section/Subsection/Key=value\".");
      if (assignment.find('#') != std::string::npos)
        throw UserError("--set \"" + assignment
                        + "\": '#' begins a comment in a scene, and its copy could not be run. "
                          "Choose a value without it.");
      return {trim(assignment.substr(0, equal)), trim(assignment.substr(equal + 1))};
    }

    void parse_option(const std::string &option, CommandLine &result)
    {
      if (option == "--validate" || option == "--validate=json")
        {
          result.validate = true;
          result.as_json  = option == "--validate=json";
        }
      else if (option == "--resume")
        result.resume = true;
      else if (option == "--print-parameters")
        result.print_parameters = true;
      else if (option == "--print-schemes" || option == "--print-schemes=json")
        {
          result.print_schemes = true;
          result.as_json       = option == "--print-schemes=json";
        }
      else if (option == "--quiet")
        result.quiet = true;
      else if (option == "--version")
        result.version = true;
      else if (option == "--help" || option == "-h")
        result.help = true;
      else if (option.rfind("--validate=", 0) == 0 || option.rfind("--print-schemes=", 0) == 0)
        throw UserError(option + ": only json is known. Write " + option.substr(0, option.find('='))
                        + "=json, or leave it out for text.");
      else
        throw UserError("unknown option " + option + ". " + suggestion(option, options));
    }
  } // namespace

  CommandLine parse_command_line(const std::vector<std::string> &arguments)
  {
    CommandLine result;
    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &argument = arguments[i];
        if (argument == "--set")
          {
            if (++i == arguments.size())
              throw UserError(
                "--set needs a key and a value. Write --set \"Section/Subsection/Key=value\".");
            result.overrides.push_back(parse_override(arguments[i]));
          }
        else if (argument == "--explain")
          {
            if (++i == arguments.size())
              throw UserError("--explain needs a key. Write --explain \"Section/Key\".");
            result.explain = trim(arguments[i]);
            if (result.explain.empty())
              throw UserError("--explain needs a key, not an empty one.");
          }
        else if (argument == "--new")
          result.new_scene = ++i == arguments.size() ? "" : trim(arguments[i]);
        else if (!argument.empty() && argument[0] == '-')
          parse_option(argument, result);
        else if (!result.scene_file.empty())
          throw UserError("two scenes, " + result.scene_file + " and " + argument
                          + ". Name one; each runs on its own.");
        else
          result.scene_file = argument;
      }
    if (result.resume && result.validate)
      throw UserError("--resume and --validate: a run goes on, or is checked. Name one of them.");
    if (result.print_schemes && result.scene_file == "json")
      throw UserError("--print-schemes: `json` is taken for a scene here. Write "
                      "--print-schemes=json.");
    if (result.scene_file.empty() && !arguments.empty() && !result.asks_for_information_only())
      throw UserError(
        "no scene. Name a .prm file, for example: signorini parameters/quick_start.prm");
    return result;
  }

  std::string short_help()
  {
    return "signorini: elastic bodies that hit rigid obstacles or each other.\n\n"
           "  signorini --new ball              write a scene to start from, ball.prm\n"
           "  signorini scene.prm               run a scene\n"
           "  mpirun -np 4 signorini scene.prm  the same on four processes\n"
           "  signorini --help                  all options\n";
  }

  std::string help()
  {
    return "Usage: signorini [options] scene.prm\n\n"
           "  --set \"Section/Key=value\"  change a value of the scene (repeatable, applied after "
           "the file)\n"
           "  --validate[=json]          check scene and physics, say what would run and what to "
           "expect, and stop\n"
           "  --resume                   go on from the latest checkpoint in the output directory\n"
           "  --explain \"Section/Key\"    say what a key means, its default and its values; or "
           "list "
           "a section\n"
           "  --new ball                 write a scene with comments to start from, ball.prm; "
           "--new alone\n"
           "                             says which there are\n"
           "  --print-parameters         print all keys of a scene with descriptions and defaults\n"
           "  --print-schemes[=json]     print what is known about each time scheme, as a table or "
           "for programs\n"
           "  --quiet                    no progress line\n"
           "  --version                  print version and commit\n"
           "  --help                     print this text\n\n"
           "A first scene: signorini --new ball.\n"
           "Exit status: 0 done, 1 the run failed, 2 the command line or the scene has a mistake, "
           "130 or 143\nended by Ctrl-C or SIGTERM after a step, with its state written.\n";
  }
} // namespace signorini
