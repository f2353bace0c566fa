// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/plugin.h>
#include <signorini/base/user_error.h>
#include <signorini/prm/plugins.h>
#include <signorini/prm/section_reader.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <filesystem>

namespace signorini
{
  std::vector<std::string> plugins_of(const SceneText &text)
  {
    std::vector<std::string> paths;
    if (const Statement *statement = text.find({}, key_of_plugins))
      for (const std::string &name : dealii::Utilities::split_string_list(statement->value))
        {
          const auto folder = std::filesystem::path(text.file_name).parent_path();
          paths.push_back(std::filesystem::absolute(folder / name).lexically_normal().string());
        }
    return paths;
  }


  SceneText plugins_without_a_scene(const std::vector<Override> &overrides)
  {
    SceneText text;
    for (const auto &[key, value] : overrides)
      if (key == key_of_plugins)
        text.statements.push_back({{}, key, value, "--set", true});
    return text;
  }


  void load_plugins(const SceneText &text)
  {
    const dealii::ParameterHandler no_values;
    for (const std::string &path : plugins_of(text))
      try
        {
          load_plugin(path);
        }
      catch (const UserError &error)
        {
          SectionReader(no_values, text).fail(key_of_plugins, error.what());
        }
  }
} // namespace signorini
