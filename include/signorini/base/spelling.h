// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_spelling_h
#define signorini_base_spelling_h

#include <string>
#include <vector>

namespace signorini
{
  /** The words in one string, separated by `separator`. */
  std::string join(const std::vector<std::string> &words, const std::string &separator = ", ");

  /** The words as a list in a sentence; the last separator differs: `a, b and c`. */
  std::string enumeration(const std::vector<std::string> &words, const std::string &last);

  /** The pieces of @p text between the characters @p separator, without surrounding white space. */
  std::vector<std::string> split(const std::string &text, char separator);

  /** @p text without white space at both ends and with single blanks inside. */
  std::string trim(const std::string &text);

  /** Whether @p text has at least one character, and only some of @p characters. */
  bool consists_of(const std::string &text, const std::string &characters);

  /** Whether @p text may be a name: letters, digits, - and _ only. */
  bool is_name(const std::string &text);

  /** Whether two words differ at most in blanks, and between small and capital letters. */
  bool same_letters(const std::string &first, const std::string &second);

  /**
   * Least number of inserted, deleted or replaced characters between two words, upper and lower
   * case being the same.
   */
  unsigned int edit_distance(const std::string &first, const std::string &second);

  /** The word of @p valid that resembles @p word most; empty if none resembles it. */
  std::string nearest(const std::string &word, const std::vector<std::string> &valid);

  /** "Did you mean `x`? Valid: a, x, z." The question is left out when nothing resembles @p word.
   */
  std::string suggestion(const std::string &word, const std::vector<std::string> &valid);

  /**
   * An estimated part of a whole: "about 3.4 %", or "more than 100 %", as an estimate beyond that
   * says no more.
   */
  std::string about_per_cent(double part);
} // namespace signorini

#endif
