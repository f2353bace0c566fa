// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/checkpoint/scene_changes.h>
#include <signorini/prm/scene_text.h>

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
                                                 "Solver/Preconditioner",
                                                 "Output/Guard",
                                                 "Output/VTU every",
                                                 "Output/VTU states",
                                                 "Output/History every",
                                                 "Output/FCLIB every",
                                                 "Checkpoint/Every steps",
                                                 "Checkpoint/Every minutes"};

    /** Value by path of the key. */
    std::map<std::string, std::string> values_of(const std::string &parameters)
    {
      std::istringstream                 text(parameters);
      std::map<std::string, std::string> values;
      for (const Statement &statement : scan_statements(text, "parameters"))
        if (!statement.key.empty())
          values[statement.path()] = statement.value;
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
