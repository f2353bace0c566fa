// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_kinds_of_section_h
#define signorini_prm_kinds_of_section_h

#include <signorini/base/spelling.h>
#include <signorini/prm/section_reader.h>
#include <signorini/prm/unused_keys.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace signorini
{
  // A section that a key makes one of several kinds (the shape of an obstacle, the material of a
  // body), each with keys of its own. A kind has a `name`, a `summary`, and the list of its `keys`.

  /** Declare the key that says the kind; the first one is the default. */
  template <typename Kind>
  void declare_kinds(dealii::ParameterHandler &prm,
                     const std::string        &key,
                     const std::vector<Kind>  &kinds)
  {
    std::vector<std::string> names, summaries;
    for (const Kind &kind : kinds)
      {
        names.emplace_back(kind.name);
        summaries.emplace_back(kind.summary);
      }
    prm.declare_entry(key,
                      names.front(),
                      dealii::Patterns::Selection(join(names, "|")),
                      "One of: " + join(summaries, ", ") + ".");
  }

  /** The names of kinds, for messages: `box or sphere`. */
  template <typename Kind>
  std::string names_of_kinds(const std::vector<const Kind *> &kinds)
  {
    std::vector<std::string> names;
    for (const Kind *kind : kinds)
      names.emplace_back(kind->name);
    return join(names, " or ");
  }

  /**
   * The kind that a section says.
   * @param declared a handler with the keys of this section at its top
   * @param in_words says of the kinds that look at a key who they are: `the shape box or sphere`
   * @throws UserError about keys that only other kinds look at
   *
   * (Texts and functions by value: GCC takes the kind for a part of a temporary argument.)
   */
  template <typename Kind, typename InWords>
  const Kind &kind_of(const SectionReader            &in,
                      const char                     *key,
                      const std::vector<Kind>        &kinds,
                      const dealii::ParameterHandler &declared,
                      const InWords                   in_words)
  {
    const Kind &own = *std::find_if(
      kinds.begin(), kinds.end(), [&](const Kind &kind) { return kind.name == in.text(key); });
    std::map<std::string, std::vector<const Kind *>> owners;
    for (const Kind &kind : kinds)
      for (const std::string &key_of_kind : kind.keys)
        owners[key_of_kind].push_back(&kind);
    for (const auto &[key_of_kinds, owners_of_key] : owners)
      if (std::find(own.keys.begin(), own.keys.end(), key_of_kinds) == own.keys.end())
        refuse_without_effect(in, key_of_kinds, declared, in_words(owners_of_key), key);
    return own;
  }
} // namespace signorini

#endif
