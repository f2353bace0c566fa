// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/prm/scene_text.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr unsigned int max_include_depth = 20;

    [[noreturn]] void refuse(const std::string &file_name, const std::string &reason)
    {
      throw UserError(file_name + ": cannot read this scene: " + reason);
    }

    std::string read_file(const std::string &file_name)
    {
      std::error_code error;
      if (!std::filesystem::exists(file_name, error))
        refuse(file_name,
               "there is no such file. Check the name; a path is relative to the current folder.");
      if (std::filesystem::is_directory(file_name, error))
        refuse(file_name, "it is a directory. Name a .prm file in it.");
      std::ifstream in(file_name);
      if (!in)
        refuse(file_name, std::strerror(errno) + std::string(". Check its permissions."));
      std::ostringstream text;
      text << in.rdbuf();
      if (text.str().find('\0') != std::string::npos)
        refuse(file_name, "it is not a text file. Name a .prm file.");
      // Some editors begin a file with the mark of its byte order.
      const std::string mark = "\xef\xbb\xbf";
      return text.str().compare(0, mark.size(), mark) == 0 ? text.str().substr(mark.size())
                                                           : text.str();
    }

    /** Collects statements line by line and keeps track of the open sections. */
    class Scanner
    {
    public:
      void scan(std::istream &in, const std::string &file_name, unsigned int depth);

      std::vector<Statement> statements;

    private:
      void scan_line(const std::string &line, const std::string &file_name, unsigned int depth);
      void include(const std::string &line, const std::string &file_name, unsigned int depth);
      void set(const std::string &assignment);
      [[noreturn]] void fail(const std::string &message) const
      {
        throw UserError(origin + ": " + message);
      }

      std::string              origin;              ///< of the current line
      bool                     is_override = false; ///< are the statements of the current line
      std::vector<std::string> section;
      std::vector<std::string> section_origin;
    };

    void Scanner::scan(std::istream &in, const std::string &file_name, const unsigned int depth)
    {
      const std::size_t depth_of_sections = section.size();
      std::string       line, logical_line;
      unsigned int      first_line = 1, line_number = 0;
      while (std::getline(in, line))
        {
          ++line_number;
          if (logical_line.empty())
            first_line = line_number;
          origin      = file_name + ", line " + std::to_string(first_line);
          is_override = is_override || line == beyond_the_file;
          logical_line += line.substr(0, line.find('#'));
          const std::size_t last = logical_line.find_last_not_of(" \t\r");
          if (last != std::string::npos && logical_line[last] == '\\')
            {
              logical_line.resize(last);
              continue;
            }
          scan_line(trim(logical_line), file_name, depth);
          logical_line.clear();
        }
      if (!trim(logical_line).empty())
        fail("the last line ends with a backslash, but there is no line to continue it.");
      if (section.size() > depth_of_sections)
        throw UserError(section_origin.back() + ": `subsection " + section.back()
                        + "` has no `end` before the end of the file. Add the missing `end`.");
    }

    void Scanner::scan_line(const std::string &line,
                            const std::string &file_name,
                            const unsigned int depth)
    {
      const std::string verb = line.substr(0, line.find(' '));
      const std::string rest = line.size() > verb.size() ? line.substr(verb.size() + 1) : "";
      if (line.empty())
        return;
      else if ((verb == "subsection" || verb == "SUBSECTION") && !rest.empty())
        {
          section.push_back(rest);
          section_origin.push_back(origin);
          statements.push_back({section, "", "", origin});
        }
      else if (line == "end" || line == "END")
        {
          if (section.empty())
            fail("`end` closes nothing: every `subsection` above has its `end` already. Remove "
                 "this line, or add the missing `subsection`.");
          section.pop_back();
          section_origin.pop_back();
        }
      else if (verb == "set" || verb == "SET")
        set(rest);
      else if (verb == "include" || verb == "INCLUDE")
        include(rest, file_name, depth);
      else if (line.find('=') != std::string::npos)
        {
          // Whatever stands in front of a `set` that is there belongs nowhere.
          const std::size_t at = line.substr(0, line.find('=')).find(" set ");
          fail("`" + line + "` is not a statement. Write `"
               + (at == std::string::npos ? "set " + line : line.substr(at + 1)) + "`.");
        }
      else
        fail("`" + line
             + "` is not a statement. Valid: `set key = value`, `subsection name`, `end`, `include "
               "file`; comments start with #.");
    }

    void Scanner::set(const std::string &assignment)
    {
      const std::size_t equal = assignment.find('=');
      if (equal == std::string::npos)
        fail("`set " + assignment + "` has no value. Write `set key = value`.");
      const std::string key = trim(assignment.substr(0, equal));
      if (key.empty())
        fail("`set " + assignment + "` names no key. Write `set key = value`.");
      statements.push_back({section, key, trim(assignment.substr(equal + 1)), origin, is_override});
    }

    void Scanner::include(const std::string &line,
                          const std::string &file_name,
                          const unsigned int depth)
    {
      if (depth >= max_include_depth)
        fail("include of " + line + ": too many files include each other. Break the circle.");
      const std::string  place = origin;
      const auto         file  = std::filesystem::path(file_name).parent_path() / line;
      std::istringstream in;
      try
        {
          in.str(read_file(file.string()));
        }
      catch (const UserError &error)
        {
          fail("include: " + std::string(error.what()));
        }
      scan(in, file.string(), depth + 1);
      origin = place;
    }

    /**
     * A file that sets a key twice has a mistake in one of the lines. What another file has set
     * that it includes, it may change.
     */
    void refuse_repetitions(const std::vector<Statement> &statements)
    {
      std::map<std::string, const Statement *> known; // by file and path
      for (const Statement &statement : statements)
        {
          if (statement.is_override)
            continue;
          const std::size_t comma = statement.origin.rfind(", line ");
          const auto [earlier, is_new] =
            known.emplace(statement.origin.substr(0, comma) + '\n' + statement.path(), &statement);
          if (!is_new && !statement.key.empty())
            throw UserError(statement.origin + ": " + statement.path() + " = " + statement.value
                            + ": this key is set already in"
                            + earlier->second->origin.substr(comma + 1) + ", to "
                            + earlier->second->value + ". Remove one of the two.");
        }
    }

    Statement statement_of_override(const Override &override, const std::string &file_name)
    {
      std::vector<std::string> path = split(override.first, '/');
      if (std::any_of(path.begin(), path.end(), [](const auto &name) { return name.empty(); }))
        throw UserError(
          "--set \"" + override.first + "=" + override.second
          + "\": the path has an empty name. Write --set \"Section/Subsection/Key=value\".");
      const std::string key = path.back();
      path.pop_back();
      return {path, key, trim(override.second), file_name + ", --set", true};
    }
  } // namespace

  std::string Statement::path() const
  {
    std::vector<std::string> names = section;
    if (!key.empty())
      names.push_back(key);
    return join(names, "/");
  }

  const Statement *SceneText::find(const std::vector<std::string> &section,
                                   const std::string              &key) const
  {
    const Statement *found = nullptr;
    for (const Statement &statement : statements)
      if (statement.section == section && statement.key == key)
        found = &statement;
    return found;
  }

  std::vector<Statement> scan_statements(std::istream &in, const std::string &file_name)
  {
    Scanner scanner;
    scanner.scan(in, file_name, 0);
    return scanner.statements;
  }

  SceneText read_scene_text(const std::string &file_name, const std::vector<Override> &overrides)
  {
    SceneText text;
    text.file_name = file_name;
    text.original  = read_file(file_name);
    std::istringstream in(text.original);
    text.statements = scan_statements(in, file_name);
    refuse_repetitions(text.statements);
    text.n_overrides = overrides.size();
    for (const Override &override : overrides)
      text.statements.push_back(statement_of_override(override, file_name));
    return text;
  }
} // namespace signorini
