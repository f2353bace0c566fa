// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/json.h>
#include <signorini/base/spelling.h>

#include <cmath>
#include <cstdio>

namespace signorini
{
  std::string json_text(const std::string &text)
  {
    std::string result = "\"";
    for (const char c : text)
      if (c == '"' || c == '\\')
        result += {'\\', c};
      else if (static_cast<unsigned char>(c) < 0x20)
        {
          char code[8];
          std::snprintf(code, sizeof(code), "\\u%04x", c);
          result += code;
        }
      else
        result += c;
    return result + "\"";
  }


  std::string json_number(const double number)
  {
    if (!std::isfinite(number))
      return "null";
    char text[32];
    std::snprintf(text, sizeof(text), "%.12g", number);
    return text;
  }


  std::string json_list(const std::vector<std::string> &values)
  {
    return "[" + join(values, ", ") + "]";
  }


  JsonObject &JsonObject::texts(const std::string &name, const std::vector<std::string> &values)
  {
    std::vector<std::string> quoted;
    for (const std::string &value : values)
      quoted.push_back(json_text(value));
    return value_of(name, json_list(quoted));
  }


  std::string JsonObject::line() const
  {
    return with("{", ", ", "}");
  }


  std::string JsonObject::lines() const
  {
    return with("{\n  ", ",\n  ", "\n}");
  }


  std::string JsonObject::with(const std::string &begin,
                               const std::string &between,
                               const std::string &end) const
  {
    std::vector<std::string> parts;
    for (const auto &[name, value] : members)
      parts.push_back(json_text(name) + ": " + value);
    return begin + join(parts, between) + end;
  }
} // namespace signorini
