// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/prm/new_scene.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

namespace signorini
{
  namespace
  {
    const std::string first_name = "ball", first_scene = "quick_start";

    const std::map<std::string, const char *> &shipped_scenes()
    {
      static const std::map<std::string, const char *> scenes = {
#include <signorini_scenes.h>
      };
      return scenes;
    }


    /** What the text says of its own place. */
    std::string moved(std::string text, const std::string &from, const std::string &to)
    {
      text = std::regex_replace(text, std::regex("parameters/(moving_contact/)?" + from), to);
      return std::regex_replace(text, std::regex("output/" + from), "output/" + to);
    }
  } // namespace


  std::vector<std::string> names_of_new_scenes()
  {
    std::vector<std::string> names = {first_name};
    for (const auto &[name, text] : shipped_scenes())
      if (name != first_scene)
        names.push_back(name);
    return names;
  }


  std::string write_new_scene(const std::string &name)
  {
    const std::vector<std::string> names = names_of_new_scenes();
    if (name.empty())
      return "Scenes to start from; `signorini --new NAME` writes NAME.prm:\n\n  "
             + join(names, "\n  ") + "\n";
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw UserError("--new " + name + ": there is no such scene. " + suggestion(name, names));
    const std::string file   = name + ".prm";
    const std::string source = name == first_name ? first_scene : name;
    if (std::filesystem::exists(file))
      throw UserError("--new " + name + ": there is a file `" + file
                      + "` already. Move it away, or work in another folder.");
    errno = 0;
    std::ofstream out(file);
    out << moved(shipped_scenes().at(source), source, name);
    out.close();
    if (!out)
      throw UserError("--new " + name + ": cannot write `" + file + "`: " + std::strerror(errno)
                      + ".");
    return "wrote " + file + ": read it, change it, and run it with\n\n  signorini " + file + "\n";
  }
} // namespace signorini
