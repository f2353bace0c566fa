// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_json_h
#define signorini_base_json_h

#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /** A text as a value of JSON, in quotation marks. */
  std::string json_text(const std::string &text);

  /** A number as a value of JSON, which knows no infinity: `null` for what is not finite. */
  std::string json_number(double number);

  /** A list of values of JSON, on one line. */
  std::string json_list(const std::vector<std::string> &values);

  /** An object of JSON: names and values in the order in which they were added. */
  class JsonObject
  {
  public:
    JsonObject &text(const std::string &name, const std::string &value)
    {
      return value_of(name, json_text(value));
    }

    JsonObject &number(const std::string &name, const double value)
    {
      return value_of(name, json_number(value));
    }

    JsonObject &truth(const std::string &name, const bool value)
    {
      return value_of(name, value ? "true" : "false");
    }

    JsonObject &texts(const std::string &name, const std::vector<std::string> &values);

    /** Something that is a value of JSON already. */
    JsonObject &value_of(const std::string &name, const std::string &value)
    {
      members.emplace_back(name, value);
      return *this;
    }

    /** On one line. */
    std::string line() const;

    /** One member on each line. */
    std::string lines() const;

  private:
    std::vector<std::pair<std::string, std::string>> members;

    std::string
    with(const std::string &begin, const std::string &between, const std::string &end) const;
  };
} // namespace signorini

#endif
