// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What the program says of the keys of a scene: all of them as an example, and one by one.

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/scene/explain_key.h>
#include <signorini/scene/read_scene.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <boost/property_tree/json_parser.hpp>

#include <ostream>
#include <sstream>

namespace signorini
{
  namespace
  {
    /**
     * A small scene, so that the printed file can be run: lists of names and the step size have no
     * useful default.
     */
    void set_example_values(dealii::ParameterHandler &prm)
    {
      const std::vector<std::pair<std::vector<std::string>, std::pair<std::string, std::string>>>
        values = {{{"Time"}, {"Step size", "5e-3"}},
                  {{"Time"}, {"End time", "0.5"}},
                  {{"Bodies"}, {"Names", "ball"}},
                  {{"Bodies", "ball"}, {"Centre", "0, 0, 1"}},
                  {{"Obstacles"}, {"Names", "floor"}},
                  {{"Contact"}, {"Pairs", "ball : floor"}},
                  {{"Probes"}, {"Names", "south_pole"}}};
      for (const auto &[section, entry] : values)
        {
          for (const std::string &name : section)
            prm.enter_subsection(name);
          prm.set(entry.first, entry.second);
          for (std::size_t i = 0; i < section.size(); ++i)
            prm.leave_subsection();
        }
    }
  } // namespace

  void print_parameters(std::ostream &out)
  {
    dealii::ParameterHandler prm;
    declare_scene<3>(prm, {{"ball"}, {"floor"}, {"south_pole"}, {{"ball", {}, "floor", {}}}});
    set_example_values(prm);
    out << "# All keys of a scene, with descriptions and defaults, for one body, one obstacle and "
           "one probe.\n"
           "# Lists of numbers are separated by commas, the components of expressions by "
           "semicolons.\n"
           "# Units are the user's, consistently.\n#\n";
    prm.print_parameters(
      out, dealii::ParameterHandler::PRM | dealii::ParameterHandler::KeepDeclarationOrder);
  }


  namespace
  {
    using Tree = boost::property_tree::ptree;

    /** Names that stand for those of a scene, in sections that have a part for each of them. */
    const std::vector<std::pair<std::string, std::string>> placeholders = {
      {"Bodies", "<body>"},
      {"Obstacles", "<obstacle>"},
      {"Probes", "<probe>"},
      {"Contact", "<body> : <obstacle>"}};

    /** All keys as the library writes them for programs. */
    Tree all_keys()
    {
      dealii::ParameterHandler prm;
      declare_scene<3>(prm, {{"body"}, {"obstacle"}, {"probe"}, {{"body", {}, "obstacle", {}}}});
      std::stringstream json;
      prm.print_parameters(json, dealii::ParameterHandler::JSON);
      Tree tree;
      boost::property_tree::read_json(json, tree);
      return tree;
    }


    bool is_key(const Tree &tree)
    {
      return tree.find("pattern_description") != tree.not_found();
    }


    /** The library writes what is neither letter nor digit as an underscore and two digits. */
    std::string name_of(const std::string &written)
    {
      std::string name;
      for (std::size_t i = 0; i < written.size(); ++i)
        if (written[i] == '_' && i + 2 < written.size())
          {
            name += static_cast<char>(std::stoi(written.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          name += written[i];
      return name;
    }


    /** The parts of a section that have the names of a scene stand for all of them. */
    bool has_name_of_scene(const std::string &section, const std::string &part)
    {
      return (section == "Bodies" && part == "body")
             || (section == "Obstacles" && part == "obstacle")
             || (section == "Probes" && part == "probe")
             || (section == "Contact" && part == "body : obstacle");
    }


    std::string shown(const std::string &section, const std::string &part)
    {
      if (has_name_of_scene(section, part))
        for (const auto &[of_section, placeholder] : placeholders)
          if (of_section == section)
            return placeholder;
      return part;
    }


    /** "a, b or c" of "[Selection a|b|c ]"; "" if there is nothing to say. */
    std::string values_of(const std::string &pattern)
    {
      const std::string text = trim(pattern.substr(1, pattern.size() - 2));
      if (text.rfind("Selection ", 0) == 0)
        return join(split(text.substr(10), '|'), ", ");
      if (text == "Bool")
        return "true, false";
      // The limits of numbers are those of the reader, and in the text.
      if (text.rfind("Integer range", 0) == 0)
        return "an integer";
      if (text.rfind("Double ", 0) == 0)
        return "a number";
      return text == "Anything" ? "" : text;
    }


    void explain(const std::string &path, const Tree &key, std::ostream &out)
    {
      out << path << '\n';
      for (const std::string &line :
           dealii::Utilities::break_text_into_lines(key.get<std::string>("documentation"), 78))
        out << "  " << line << '\n';
      const std::string standard = key.get<std::string>("default_value");
      out << "default: " << (standard.empty() ? "(nothing)" : standard) << '\n';
      if (const std::string values = values_of(key.get<std::string>("pattern_description"));
          !values.empty())
        out << "values:  " << values << '\n';
    }


    /** The keys and parts of a section, parts with a stroke at the end. */
    void
    list(const std::string &path, const std::string &section, const Tree &tree, std::ostream &out)
    {
      out << (path.empty() ? "All sections" : path) << '\n';
      for (const auto &[written, entry] : tree)
        {
          const std::string name = shown(section, name_of(written));
          if (is_key(entry))
            out << "  " << name << " = " << entry.get<std::string>("default_value") << '\n';
          else
            out << "  " << name << "/\n";
        }
    }


    /** The part of a section with a name, or that which stands for it. Null: there is none. */
    const Tree *find(const Tree &tree, const std::string &section, const std::string &name)
    {
      const Tree *for_any_name = nullptr;
      for (const auto &[written, entry] : tree)
        if (name_of(written) == name)
          return &entry;
        else if (has_name_of_scene(section, name_of(written)))
          for_any_name = &entry;
      return for_any_name;
    }
  } // namespace


  void explain_key(const std::string &path, std::ostream &out)
  {
    const Tree  all  = all_keys();
    const Tree *tree = &all;
    std::string section, way;
    for (const std::string &name : split(path, '/'))
      {
        if (name.empty())
          continue;
        const Tree *next = is_key(*tree) ? nullptr : find(*tree, section, name);
        if (next == nullptr)
          {
            std::vector<std::string> names;
            if (!is_key(*tree))
              for (const auto &[written, entry] : *tree)
                names.push_back(shown(section, name_of(written)));
            throw UserError("--explain \"" + path + "\": there is no `" + name + "`"
                            + (way.empty() ? "" : " in `" + way + "`") + ". "
                            + (names.empty() ? "That is a key." : suggestion(name, names)));
          }
        tree    = next;
        section = way.empty() ? name : std::string();
        way += (way.empty() ? "" : "/") + name;
      }
    if (is_key(*tree))
      explain(way, *tree, out);
    else
      list(way, section, *tree, out);
  }
} // namespace signorini
