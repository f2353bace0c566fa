// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/prm/repeatable_text.h>

#include <filesystem>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** A line of a scene; an included file gets its absolute path. */
    std::string with_absolute_path(const std::string &line, const std::filesystem::path &folder)
    {
      const std::string statement = trim(line.substr(0, line.find('#')));
      for (const std::string verb : {"include ", "INCLUDE "})
        if (statement.compare(0, verb.size(), verb) == 0)
          return verb
                 + std::filesystem::absolute(folder / trim(statement.substr(verb.size()))).string();
      return line;
    }


    void write(const Statement &statement, std::ostream &out)
    {
      std::string indent;
      for (const std::string &name : statement.section)
        {
          out << indent << "subsection " << name << '\n';
          indent += "  ";
        }
      out << indent << "set " << statement.key << " = " << statement.value << '\n';
      for (std::size_t depth = statement.section.size(); depth > 0; --depth)
        out << std::string(2 * (depth - 1), ' ') << "end\n";
    }
  } // namespace


  std::string repeatable_text(const SceneText &text, const std::vector<Statement> &later)
  {
    const std::filesystem::path folder = std::filesystem::path(text.file_name).parent_path();
    std::istringstream          in(text.original);
    std::ostringstream          out;
    for (std::string line; std::getline(in, line);)
      out << with_absolute_path(line, folder) << '\n';
    if (!later.empty())
      out << '\n' << beyond_the_file << '\n';
    for (const Statement &statement : later)
      write(statement, out);
    return out.str();
  }
} // namespace signorini
