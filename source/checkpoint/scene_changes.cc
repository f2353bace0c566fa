// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/checkpoint/scene_changes.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace signorini
{
  namespace
  {
    const std::vector<std::string> may_change = {"Output directory",
                                                 "Time/End time",
                                                 "Time/Step tolerance",
                                                 "Time/Stop on warning",
                                                 "Solver/Tolerance",
                                                 "Output/VTU every",
                                                 "Output/VTU states",
                                                 "Output/History every",
                                                 "Checkpoint/Every steps",
                                                 "Checkpoint/Every minutes"};

    /** Value by key, sections before it. */
    std::map<std::string, std::string> values_of(const std::string &parameters)
    {
      std::map<std::string, std::string> values;
      std::vector<std::string>           sections;
      std::istringstream                 lines(parameters);
      for (std::string line; std::getline(lines, line);)
        {
          line = trim(line.substr(0, line.find('#')));
          if (line.rfind("subsection ", 0) == 0)
            sections.push_back(trim(line.substr(11)) + "/");
          else if (line == "end" && !sections.empty())
            sections.pop_back();
          else if (const std::size_t equal = line.find('=');
                   line.rfind("set ", 0) == 0 && equal != std::string::npos)
            values[join(sections, "") + trim(line.substr(4, equal - 4))] =
              trim(line.substr(equal + 1));
        }
      return values;
    }
  } // namespace


  std::vector<std::string> forbidden_changes(const std::string &before, const std::string &now)
  {
    std::vector<std::string>                 changes;
    const std::map<std::string, std::string> old_values = values_of(before);
    std::map<std::string, std::string>       new_values = values_of(now);
    const auto note = [&](const std::string &key, const std::string &then, const std::string &is) {
      if (then != is && std::find(may_change.begin(), may_change.end(), key) == may_change.end())
        changes.push_back("`" + key + "` is `" + is + "` and was `" + then + "`");
    };
    for (const auto &[key, value] : old_values)
      {
        note(key, value, new_values[key]);
        new_values.erase(key);
      }
    for (const auto &[key, value] : new_values)
      note(key, "", value);
    return changes;
  }


  std::string keys_that_may_change()
  {
    return join(may_change, ", ");
  }
} // namespace signorini
