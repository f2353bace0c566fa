// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_table_of_kinds_h
#define signorini_base_table_of_kinds_h

#include <signorini/base/user_error.h>

#include <string>
#include <vector>

namespace signorini
{
  /**
   * Add an entry to a table that scenes choose from by name. Before a scene is read: entries may
   * move.
   * @param kind what the entries are, for the message
   * @throws UserError if the name is taken
   */
  template <typename Entry>
  void add_kind(std::vector<Entry> &table, const Entry &entry, const std::string &kind)
  {
    for (const Entry &known : table)
      if (std::string(known.name) == entry.name)
        throw UserError("there is a " + kind + " `" + entry.name
                        + "` already. Choose another name in the plug-in.");
    table.push_back(entry);
  }
} // namespace signorini

#endif
