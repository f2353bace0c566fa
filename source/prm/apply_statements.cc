// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/prm/apply_statements.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
  namespace
  {
    using Path = std::vector<std::string>;

    /** Words of later versions, so that a scene for them is not taken for a spelling mistake. */
    const std::vector<std::string> words_of_later_versions = {"Kinematics"};

    /** All that is declared, as statements: the handler prints itself and the print is scanned. */
    std::vector<Statement> declared_statements(const dealii::ParameterHandler &prm)
    {
      std::stringstream print;
      prm.print_parameters(print,
                           dealii::ParameterHandler::ShortText
                             | dealii::ParameterHandler::KeepDeclarationOrder);
      return scan_statements(print, "declared parameters");
    }

    bool starts_with(const Path &path, const Path &beginning)
    {
      return path.size() >= beginning.size()
             && std::equal(beginning.begin(), beginning.end(), path.begin());
    }

    bool is_declared(const std::vector<Statement> &declared, const Path &section)
    {
      return std::any_of(declared.begin(), declared.end(), [&](const Statement &statement) {
        return starts_with(statement.section, section);
      });
    }

    std::vector<std::string> keys_of(const std::vector<Statement> &declared, const Path &section)
    {
      std::vector<std::string> keys;
      for (const Statement &statement : declared)
        if (statement.section == section && !statement.key.empty())
          keys.push_back(statement.key);
      return keys;
    }

    std::vector<std::string> sections_in(const std::vector<Statement> &declared, const Path &outer)
    {
      std::vector<std::string> names;
      for (const Statement &statement : declared)
        if (statement.section.size() > outer.size() && starts_with(statement.section, outer))
          {
            const std::string &name = statement.section[outer.size()];
            if (std::find(names.begin(), names.end(), name) == names.end())
              names.push_back(name);
          }
      return names;
    }

    bool is_of_later_version(const std::string &word)
    {
      return std::find(words_of_later_versions.begin(), words_of_later_versions.end(), word)
             != words_of_later_versions.end();
    }

    /** Why there is no section @p name in @p outer, and what to do. */
    std::string explain_section(const std::vector<Statement> &declared,
                                const Path                   &outer,
                                const std::string            &name)
    {
      const std::string remedy = suggestion(name, sections_in(declared, outer));
      const auto        keys   = keys_of(declared, outer);
      if (is_of_later_version(name))
        return "it is not available in this version. Remove it.";
      if (outer == Path{"Contact"})
        return "`Contact/Pairs` does not list this pair. Write it exactly as there, or add it "
               "there. "
               + remedy;
      if (!outer.empty() && std::find(keys.begin(), keys.end(), "Names") != keys.end())
        return "`" + join(outer, "/")
               + "/Names` does not list this name. Add it there, or correct it. " + remedy;
      if (!outer.empty())
        return "section `" + join(outer, "/")
               + "` has no sections inside. Close it with `end` before.";
      return "there is no such section. " + remedy;
    }

    void check_section(const Statement &statement, const std::vector<Statement> &declared)
    {
      Path outer;
      for (const std::string &name : statement.section)
        {
          Path inner = outer;
          inner.push_back(name);
          if (!is_declared(declared, inner))
            throw UserError(statement.origin + ": unknown section `" + join(inner, "/")
                            + "`: " + explain_section(declared, outer, name));
          outer = inner;
        }
    }

    void check_key(const Statement &statement, const std::vector<Statement> &declared)
    {
      const std::vector<std::string> keys = keys_of(declared, statement.section);
      if (statement.key.empty() || std::find(keys.begin(), keys.end(), statement.key) != keys.end())
        return;

      const std::string head =
        statement.origin + ": unknown key `" + statement.path() + "` = " + statement.value + ": ";
      if (is_of_later_version(statement.key))
        throw UserError(head + "it is not available in this version. Remove it.");
      for (const Statement &other : declared)
        if (other.key == statement.key)
          throw UserError(head + "this key belongs to section `"
                          + (other.section.empty() ? "(top level)" : join(other.section, "/"))
                          + "`. Move it there; a missing `end` has the same effect.");
      throw UserError(head + "there is no such key in this section. "
                      + suggestion(statement.key, keys));
    }

    /** In words what a deal.II pattern such as "[Selection a|b ]" wants. */
    std::string
    explain(const std::string &pattern, const std::string &key, const std::string &value)
    {
      const auto begins = [&](const std::string &word) { return pattern.rfind(word, 0) == 0; };
      if (begins("[Selection"))
        {
          const std::size_t begin = pattern.find(' ') + 1;
          const std::string words = pattern.substr(begin, pattern.rfind(']') - begin);
          return is_of_later_version(value)
                   ? "it is not available in this version. Valid: " + join(split(words, '|')) + "."
                   : "there is no such choice. " + suggestion(value, split(words, '|'));
        }
      if (begins("[List"))
        {
          const std::size_t begin  = pattern.rfind("...") + 3;
          const std::string length = pattern.substr(begin, pattern.find(' ', begin) - begin);
          return "must be " + length
                 + (pattern.find("[Integer") != std::string::npos ? " integers" : " numbers")
                 + " (one per space dimension), separated by commas.";
        }
      if (const std::size_t n = split(value, ',').size(); begins("[Double") && n > 1)
        return "must be one number, not " + std::to_string(n) + "."
               + (key == "Rotation" ? " In 2d it is one angle, about the z axis." : "");
      if (begins("[Double"))
        return "must be a finite number, for example 5e-3.";
      if (begins("[Integer"))
        return "must be an integer.";
      if (begins("[Bool"))
        return "must be true or false.";
      return "does not match the pattern " + pattern + ".";
    }

    void set_value(const Statement &statement, dealii::ParameterHandler &prm)
    {
      for (const std::string &name : statement.section)
        prm.enter_subsection(name);
      std::string complaint;
      try
        {
          prm.set(statement.key, statement.value);
        }
      catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &exception)
        {
          std::ostringstream info;
          exception.print_info(info);
          // The pattern stands at the end: "... does not match the given pattern <[...]>."
          const std::string mark    = "given pattern <";
          const std::size_t begin   = info.str().rfind(mark) + mark.size();
          const std::string pattern = info.str().substr(begin, info.str().rfind('>') - begin);
          complaint                 = explain(pattern, statement.key, statement.value);
        }
      for (std::size_t i = 0; i < statement.section.size(); ++i)
        prm.leave_subsection();
      if (!complaint.empty())
        throw UserError(statement.origin + ": " + statement.path() + " = " + statement.value + ": "
                        + complaint);
    }
  } // namespace

  void apply_statements(const SceneText &text, dealii::ParameterHandler &prm)
  {
    const std::vector<Statement> declared = declared_statements(prm);
    for (const Statement &statement : text.statements)
      {
        check_section(statement, declared);
        check_key(statement, declared);
        if (!statement.key.empty())
          set_value(statement, prm);
      }
  }
} // namespace signorini
