// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/prm/section_reader.h>
#include <signorini/scene/pair_name.h>

#include <algorithm>
#include <regex>

namespace signorini
{
  namespace
  {
    std::string without_blanks(std::string text)
    {
      text.erase(std::remove_if(text.begin(), text.end(), [](const char c) { return c == ' '; }),
                 text.end());
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

    bool is_number(const std::string &word)
    {
      return word.size() <= 6 && consists_of(word, "0123456789");
    }

    /** The numbers and names in `[0,top]`; none if there are no brackets. */
    std::vector<std::string>
    parse_ids(const SectionReader &in, const std::string &pair, const std::string &brackets)
    {
      std::vector<std::string> ids;
      if (brackets.empty())
        return ids;
      for (const std::string &id : split(brackets.substr(1, brackets.size() - 2), ','))
        {
          ids.push_back(is_number(id) ? std::to_string(std::stoul(id)) : id);
          if (std::count(ids.begin(), ids.end(), ids.back()) > 1)
            in.fail("Pairs", "`" + pair + "` names boundary id " + id + " twice. Name it once.");
        }
      return ids;
    }

    /** `[0,top]`, or nothing at all; names have no signs that a list of pairs or a table needs. */
    bool are_ids(const std::string &brackets)
    {
      if (brackets.empty())
        return true;
      if (brackets.size() < 3 || brackets.front() != '[' || brackets.back() != ']')
        return false;
      const auto ids = split(brackets.substr(1, brackets.size() - 2), ',');
      return std::all_of(ids.begin(), ids.end(), [](const std::string &id) {
        const bool is_digits = consists_of(id, "0123456789");
        return is_digits ? is_number(id) : is_name(id);
      });
    }

    PairName parse_pair(const SectionReader &in, const std::string &text)
    {
      const std::string compact = without_blanks(text);
      if (compact.empty())
        in.fail("Pairs", "the list has an empty entry. Remove the superfluous comma.");
      const std::vector<std::string> sides = split(compact, ':');
      std::vector<std::string>       names, brackets;
      for (const std::string &side : sides)
        {
          names.push_back(side.substr(0, side.find('[')));
          brackets.push_back(side.substr(names.back().size()));
        }
      if (sides.size() != 2 || !std::all_of(names.begin(), names.end(), is_name)
          || !std::all_of(brackets.begin(), brackets.end(), are_ids))
        in.fail("Pairs",
                "`" + trim(text)
                  + "` is not a pair. Write `body : partner` or, for some boundaries of a "
                  + "body, `body[0,2] : partner[3]`, and separate pairs by commas.");
      return {names[0],
              parse_ids(in, trim(text), brackets[0]),
              names[1],
              parse_ids(in, trim(text), brackets[1])};
    }

    void check_names(const SectionReader            &in,
                     const PairName                 &pair,
                     const std::vector<std::string> &bodies,
                     const std::vector<std::string> &obstacles)
    {
      const std::string head = "the pair `" + pair.text() + "`: ";
      if (contains(obstacles, pair.slave))
        in.fail("Pairs",
                head + "`" + pair.slave
                  + "` is an obstacle. The body comes first: `body : obstacle`.");
      if (!contains(bodies, pair.slave))
        in.fail("Pairs",
                head + "there is no body `" + pair.slave + "`. " + suggestion(pair.slave, bodies));
      if (contains(obstacles, pair.partner) && !pair.partner_ids.empty())
        in.fail("Pairs", head + "an obstacle has no boundary ids. Remove them.");
      if (!contains(bodies, pair.partner) && !contains(obstacles, pair.partner))
        {
          std::vector<std::string> partners = obstacles;
          for (const std::string &body : bodies)
            if (body != pair.slave)
              partners.push_back(body);
          in.fail(
            "Pairs",
            head + "there is no obstacle or body `" + pair.partner + "`"
              + (partners.empty()
                   ? "; the scene has no other. Add it to `Obstacles/Names` or `Bodies/Names`."
                   : ". " + suggestion(pair.partner, partners)));
        }
    }

    bool have_common(const std::vector<std::string> &ids, const std::vector<std::string> &others)
    {
      return ids.empty() || others.empty()
             || std::any_of(
               ids.begin(), ids.end(), [&](const std::string &id) { return contains(others, id); });
    }

    std::string in_brackets(const std::vector<std::string> &ids)
    {
      return ids.empty() ? "" : "[" + join(ids, ",") + "]";
    }
  } // namespace

  std::string PairName::text() const
  {
    return slave + in_brackets(ids) + " : " + partner + in_brackets(partner_ids);
  }

  bool overlap(const PairName &first, const PairName &second)
  {
    return (first.slave == second.slave && first.partner == second.partner
            && have_common(first.ids, second.ids)
            && have_common(first.partner_ids, second.partner_ids))
           || (first.slave == second.partner && first.partner == second.slave
               && have_common(first.ids, second.partner_ids)
               && have_common(first.partner_ids, second.ids));
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
                    "`" + other.text() + "` and `" + pair.text()
                      + "` are the same contact twice. Remove one of them.");
        pairs.push_back(pair);
      }
    return pairs;
  }
} // namespace signorini
