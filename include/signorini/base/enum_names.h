// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_enum_names_h
#define signorini_base_enum_names_h

#include <optional>
#include <string>
#include <vector>

namespace signorini
{
  template <typename Enum>
  struct EnumName
  {
    Enum        value;
    const char *name;
  };

  /**
   * How the values of an enumeration are spelled in scenes and in messages: specialised beside each
   * enumeration that a scene can choose from, with an array `table` of EnumName, one for each
   * value, in the order in which they are listed.
   */
  template <typename Enum>
  struct EnumNames;

  template <typename Enum>
  std::string name_of(const Enum value)
  {
    for (const EnumName<Enum> &entry : EnumNames<Enum>::table)
      if (entry.value == value)
        return entry.name;
    return "";
  }

  template <typename Enum>
  std::vector<std::string> all_names()
  {
    std::vector<std::string> names;
    for (const EnumName<Enum> &entry : EnumNames<Enum>::table)
      names.push_back(entry.name);
    return names;
  }

  /** The value of a name; nothing if there is none. */
  template <typename Enum>
  std::optional<Enum> value_named(const std::string &name)
  {
    for (const EnumName<Enum> &entry : EnumNames<Enum>::table)
      if (entry.name == name)
        return entry.value;
    return std::nullopt;
  }
} // namespace signorini

#endif
