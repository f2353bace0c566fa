// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/scene/pair_name.h>
#include <signorini/scene/section_reader.h>

#include <algorithm>
#include <regex>

namespace signorini
{
  namespace
  {
    std::string without_blanks(std::string text)
    {
      text.erase(std::remove_if(text.begin(), text.end(), [](const char c) { return c == ' '; }), text.end());
      return text;
    }

    bool contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }

    /** Split at the commas that are not inside of brackets. */
    std::vector<std::string> split_pairs(const std::string &list)
    {
      std::vector<std::string> pairs(1);
      int                      open_brackets = 0;
      for (const char c : list)
        {
          open_brackets += (c == '[') - (c == ']');
          if (c == ',' && open_brackets == 0)
            pairs.emplace_back();
          else
            pairs.back() += c;
        }
      return pairs;
    }

    PairName parse_pair(const SectionReader &in, const std::string &text)
    {
      static const std::regex grammar(R"(([A-Za-z0-9_-]+)(\[([0-9]{1,6}(,[0-9]{1,6})*)\])?:([A-Za-z0-9_-]+)(\[.*\])?)");
      const std::string       compact = without_blanks(text);
      std::smatch             match;
      if (compact.empty())
        in.fail("Pairs", "the list has an empty entry. Remove the superfluous comma.");
      if (!std::regex_match(compact, match, grammar))
        in.fail("Pairs",
                "`" + trim(text) + "` is not a pair. Write `body : obstacle` or, for some boundaries of the "
                  + "body, `body[0,2] : obstacle`, and separate pairs by commas.");
      if (match[6].matched)
        in.fail("Pairs", "`" + trim(text) + "`: an obstacle has no boundary ids. Remove " + match[6].str() + ".");

      PairName pair{match[1], {}, match[5]};
      if (match[2].matched)
        for (const std::string &id : split(match[3].str(), ','))
          {
            pair.ids.push_back(std::stoul(id));
            if (std::count(pair.ids.begin(), pair.ids.end(), pair.ids.back()) > 1)
              in.fail("Pairs", "`" + trim(text) + "` names boundary id " + id + " twice. Name it once.");
          }
      return pair;
    }

    void check_names(const SectionReader            &in,
                     const PairName                 &pair,
                     const std::vector<std::string> &bodies,
                     const std::vector<std::string> &obstacles)
    {
      const std::string head = "the pair `" + pair.text() + "`: ";
      if (contains(obstacles, pair.slave))
        in.fail("Pairs", head + "`" + pair.slave + "` is an obstacle. The body comes first: `body : obstacle`.");
      if (!contains(bodies, pair.slave))
        in.fail("Pairs", head + "there is no body `" + pair.slave + "`. " + suggestion(pair.slave, bodies));
      if (pair.partner == pair.slave)
        in.fail("Pairs", head + "contact of a body with itself is not available. Name an obstacle.");
      if (contains(bodies, pair.partner))
        in.fail("Pairs",
                head
                  + "contact of body against body is not available in this version. "
                    "Pair each body with an obstacle.");
      if (obstacles.empty())
        in.fail("Pairs",
                head + "there is no obstacle `" + pair.partner + "`; the scene has none. "
                  + "Add it to `Obstacles/Names`.");
      if (!contains(obstacles, pair.partner))
        in.fail("Pairs", head + "there is no obstacle `" + pair.partner + "`. " + suggestion(pair.partner, obstacles));
    }

    bool overlap(const PairName &first, const PairName &second)
    {
      if (first.slave != second.slave || first.partner != second.partner)
        return false;
      if (first.ids.empty() || second.ids.empty())
        return true;
      return std::any_of(first.ids.begin(), first.ids.end(), [&](const unsigned int id) {
        return std::find(second.ids.begin(), second.ids.end(), id) != second.ids.end();
      });
    }
  } // namespace

  std::string PairName::text() const
  {
    std::vector<std::string> numbers;
    for (const unsigned int id : ids)
      numbers.push_back(std::to_string(id));
    return slave + (ids.empty() ? "" : "[" + join(numbers, ",") + "]") + " : " + partner;
  }

  std::string with_normal_blanks(const std::string &name)
  {
    return std::regex_replace(without_blanks(name), std::regex(":"), " : ");
  }

  std::vector<PairName> parse_pair_names(const SectionReader            &in,
                                         const std::string              &list,
                                         const std::vector<std::string> &bodies,
                                         const std::vector<std::string> &obstacles)
  {
    std::vector<PairName> pairs;
    if (list.empty())
      return pairs;
    for (const std::string &text : split_pairs(list))
      {
        const PairName pair = parse_pair(in, text);
        check_names(in, pair, bodies, obstacles);
        for (const PairName &other : pairs)
          if (overlap(pair, other))
            in.fail("Pairs",
                    "`" + other.text() + "` and `" + pair.text() + "` are the same contact twice. Remove one of them.");
        pairs.push_back(pair);
      }
    return pairs;
  }
} // namespace signorini
