// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <sstream>

namespace signorini
{
  std::string join(const std::vector<std::string> &words, const std::string &separator)
  {
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i)
      result += (i == 0 ? "" : separator) + words[i];
    return result;
  }

  std::string enumeration(const std::vector<std::string> &words, const std::string &last)
  {
    const std::size_t n_first = words.size() - 1;
    return n_first == 0 ? words[0]
                        : join({words.begin(), words.begin() + n_first}) + last + words[n_first];
  }

  std::vector<std::string> split(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces(1);
    for (const char c : text)
      if (c == separator)
        pieces.emplace_back();
      else
        pieces.back() += c;
    for (std::string &piece : pieces)
      piece = trim(piece);
    return pieces;
  }

  std::string trim(const std::string &text)
  {
    std::istringstream words(text);
    std::string        word, result;
    while (words >> word)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }

  bool consists_of(const std::string &text, const std::string &characters)
  {
    return !text.empty() && text.find_first_not_of(characters) == std::string::npos;
  }

  bool is_name(const std::string &text)
  {
    return consists_of(text, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-");
  }

  bool same_letters(const std::string &first, const std::string &second)
  {
    const auto plain = [](const std::string &text) {
      std::string letters;
      for (const unsigned char c : text)
        if (c != ' ')
          letters += static_cast<char>(std::tolower(c));
      return letters;
    };
    return plain(first) == plain(second);
  }

  unsigned int edit_distance(const std::string &first, const std::string &second)
  {
    const auto same = [](const char a, const char b) {
      return std::tolower(static_cast<unsigned char>(a))
             == std::tolower(static_cast<unsigned char>(b));
    };
    // One row of Levenshtein's table at a time: row[j] is the distance of the beginnings.
    std::vector<unsigned int> row(second.size() + 1);
    std::iota(row.begin(), row.end(), 0u);
    for (std::size_t i = 1; i <= first.size(); ++i)
      {
        unsigned int diagonal = row[0];
        row[0]                = i;
        for (std::size_t j = 1; j <= second.size(); ++j)
          {
            const unsigned int replaced = diagonal + (same(first[i - 1], second[j - 1]) ? 0 : 1);
            diagonal                    = row[j];
            row[j]                      = std::min({replaced, row[j] + 1, row[j - 1] + 1});
          }
      }
    return row.back();
  }

  std::string nearest(const std::string &word, const std::vector<std::string> &valid)
  {
    std::string  best;
    unsigned int best_distance = 0;
    for (const std::string &candidate : valid)
      {
        const unsigned int distance = edit_distance(word, candidate);
        if (2 * distance <= std::max(word.size(), candidate.size())
            && (best.empty() || distance < best_distance))
          {
            best          = candidate;
            best_distance = distance;
          }
      }
    return best;
  }

  std::string suggestion(const std::string &word, const std::vector<std::string> &valid)
  {
    if (valid.empty())
      return "There is none so far.";
    const std::string best = nearest(word, valid);
    return (best.empty() ? "" : "Did you mean `" + best + "`? ") + "Valid: " + join(valid) + ".";
  }


  std::string about_per_cent(const double part)
  {
    if (part > 1.)
      return "more than 100 %";
    std::ostringstream text;
    text.precision(2);
    text << "about " << 100. * part << " %";
    return text.str();
  }
} // namespace signorini
