// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/prm/section_reader.h>
#include <signorini/scene/scene_names.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** Names of files have at most 255 characters, and some are made of two names. */
    constexpr std::size_t longest_name = 100;

    std::string value_of(const SceneText &text, const std::string &section, const std::string &key)
    {
      const Statement *statement = text.find({section}, key);
      return statement == nullptr ? "" : statement->value;
    }

    std::vector<std::string> parse_names(const SectionReader &in, const std::string &list)
    {
      std::vector<std::string> names;
      if (list.empty())
        return names;
      for (const std::string &name : split(list, ','))
        {
          if (name.empty())
            in.fail("Names", "the list has an empty name. Remove the superfluous comma.");
          if (!is_name(name))
            in.fail("Names",
                    "the name `" + name
                      + "` has strange characters. Use letters, digits, - and _ only, "
                      + "and separate names by commas.");
          if (name.size() > longest_name)
            in.fail("Names",
                    "the name `" + name + "` has " + std::to_string(name.size())
                      + " characters. It also names files and columns: use at most "
                      + std::to_string(longest_name) + ".");
          if (name == "Names")
            in.fail("Names", "`Names` is a key and cannot be a name. Choose another one.");
          if (std::find(names.begin(), names.end(), name) != names.end())
            in.fail("Names", "the name `" + name + "` is given twice. Every name must be unique.");
          names.push_back(name);
        }
      return names;
    }
  } // namespace

  SceneNames read_scene_names(SceneText &text)
  {
    const dealii::ParameterHandler no_values;
    const SectionReader            scene(no_values, text);
    const auto                     names = [&](const std::string &section) {
      return parse_names(scene.section(section), value_of(text, section, "Names"));
    };

    SceneNames result;
    result.bodies    = names("Bodies");
    result.obstacles = names("Obstacles");
    result.probes    = names("Probes");
    if (result.bodies.empty())
      scene.section("Bodies").fail("Names", "a scene needs at least one body. List its name here.");
    for (const std::string &name : result.obstacles)
      if (std::find(result.bodies.begin(), result.bodies.end(), name) != result.bodies.end())
        scene.section("Obstacles")
          .fail("Names", "`" + name + "` is the name of a body already. Choose another name.");
    result.pairs = parse_pair_names(scene.section("Contact"),
                                    value_of(text, "Contact", "Pairs"),
                                    result.bodies,
                                    result.obstacles);

    for (Statement &statement : text.statements)
      if (statement.section.size() == 2 && statement.section[0] == "Contact")
        statement.section[1] = with_normal_blanks(statement.section[1]);
    return result;
  }
} // namespace signorini
