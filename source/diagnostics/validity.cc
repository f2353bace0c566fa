// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/resolution.h>
#include <signorini/diagnostics/validity.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr double degree = 3.14159265358979324 / 180.;

    constexpr const char *too_fast_for_steps =
      "Steps are too long for these vibrations: velocities and stresses near the contact are "
      "wrong, forces and energies are not. Choose a scheme that damps what steps do not resolve "
      "(`Time/Spectral radius` of about 0.6, doc/schemes.md), or much smaller steps.";

    constexpr const char *after_a_jump =
      "The prescribed velocity jumps, and schemes without damping never forget a jump, however "
      "short their steps are: velocities there and forces of supports alternate; their means over "
      "two steps are right. Let the motion begin and end smoothly, over ten steps or more, or take "
      "an alpha method with `Time/Spectral radius = 0.6` (doc/schemes.md).";

    std::string number(const double value)
    {
      std::ostringstream text;
      text.precision(3);
      text << value;
      return text.str();
    }
  } // namespace


  struct Validity::Limit
  {
    std::vector<double> ValidityReading::*values;
    bool                                  of_pairs;
    double                                largest; ///< that is still small
    double                                unit;    ///< in which it is told
    std::string                           has_happened, consequence;
    std::string consequence_if_followed = ""; ///< where contact follows the motion; empty: the same
  };


  const std::vector<Validity::Limit> &Validity::limits()
  {
    static const std::vector<Limit> table = {
      {&ValidityReading::depth,
       false,
       0.01,
       0.01,
       " % of its size deep in an obstacle, by the true geometry",
       "Contact is linearised about the initial configuration, with one obstacle per node: do not "
       "trust motion along a curved obstacle, in a corner or past an edge.",
       "A node has come in past the end of an obstacle, or as a coarse mesh had not seen it "
       "before, "
       "or more obstacles meet it than can hold it, as where a component is prescribed: do not "
       "trust the forces there. Give a plane that ends as a box, begin with finer cells, prescribe "
       "less, or move the obstacles apart."},
      {&ValidityReading::rotation,
       false,
       rotation_limit(),
       degree,
       " degrees turned",
       "Strains are linear: what turns by an angle grows by one over its cosine and resists. Do "
       "not "
       "trust shape, energy and contact of this body; end the run earlier, or let it turn less."},
      {&ValidityReading::strain,
       false,
       large_strain,
       0.01,
       " % strained at one place",
       "Strains are linear, and so is Hooke's law: the error is about as large. A slower impact, a "
       "lower load or a stiffer material stays within them."},
      {&ValidityReading::alternation,
       false,
       3.,
       1.,
       " times as fast to and fro from step to step, at a contact node, as it moves on",
       too_fast_for_steps},
      {&ValidityReading::prescribed,
       false,
       0.1,
       1.,
       " times as fast to and fro from step to step, where its displacement is prescribed, as it "
       "moves on",
       after_a_jump},
      {&ValidityReading::turning,
       false,
       rotation_limit(),
       degree,
       " degrees round an obstacle, by the normals of nodes that stay in contact",
       "The predictor of the scheme leaves these nodes the velocity with which they approached, so "
       "that the body slides too slowly, by some per cent in a turn of 1 radian."},
      {&ValidityReading::sliding,
       true,
       1.,
       1.,
       " times the size of a face displaced along each other while in contact",
       "The faces that meet are chosen once, in the initial configuration: do not trust the places "
       "where forces act after that."}};
    return table;
  }


  double Validity::rotation_limit()
  {
    return 3. * degree;
  }


  Validity::Validity(const std::vector<std::string> &bodies,
                     const std::vector<std::string> &pairs,
                     const bool                      contact_follows,
                     const std::string              &scheme_that_turns,
                     const std::string              &how_to_follow)
    : bodies(bodies)
    , pairs(pairs)
    , contact_follows(contact_follows)
    , scheme_that_turns(scheme_that_turns)
    , how_to_follow(how_to_follow)
  {
  }


  std::string Validity::consequence(const Limit &limit) const
  {
    if (limit.values == &ValidityReading::turning)
      return limit.consequence + " Take `Time/Scheme = " + scheme_that_turns + "`.";
    if (contact_follows && !limit.consequence_if_followed.empty())
      return limit.consequence_if_followed;
    const bool of_linearised_contact =
      limit.values == &ValidityReading::depth || limit.values == &ValidityReading::sliding;
    return limit.consequence
           + (of_linearised_contact ? " Let contact follow the motion: " + how_to_follow + "."
                                    : "");
  }


  std::string
  Validity::sentence(const Limit &limit, const std::size_t subject, const double value) const
  {
    return (limit.of_pairs ? "the bodies of the pair '" + pairs[subject] + "' are "
                           : "the body '" + bodies[subject] + "' is ")
           + number(value / limit.unit) + limit.has_happened;
  }


  std::vector<std::string> Validity::judge(const ValidityReading &reading)
  {
    std::vector<std::string> news;
    for (std::size_t l = 0; l < limits().size(); ++l)
      {
        const Limit &limit  = limits()[l];
        const auto  &values = reading.*limit.values;
        for (std::size_t subject = 0; subject < values.size(); ++subject)
          {
            if (!(values[subject] > limit.largest))
              continue;
            const auto [doubt, is_new] =
              doubts.insert({{l, subject}, {reading.time, values[subject]}});
            doubt->second.largest = std::max(doubt->second.largest, values[subject]);
            if (is_new)
              {
                std::string text = "at time " + number(reading.time) + " "
                                   + sentence(limit, subject, values[subject]) + ".";
                if (explained.insert(l).second) // the advice once, not for each body
                  text += " " + consequence(limit);
                news.push_back(text);
              }
          }
      }
    return news;
  }


  void Validity::archive(Archive &archive)
  {
    struct Known
    {
      std::size_t limit, subject;
      Doubt       doubt;
    };
    std::vector<Known> known;
    for (const auto &[what, doubt] : doubts)
      known.push_back({what.first, what.second, doubt});
    archive(known, explained);
    for (const auto &[limit, subject, doubt] : known)
      doubts[{limit, subject}] = doubt;
  }


  std::vector<std::string> Validity::summary() const
  {
    std::map<std::size_t, std::string> of_limits; // the advice once, not for each body
    for (const auto &[what, doubt] : doubts)
      {
        std::string &text = of_limits[what.first];
        text += (text.empty() ? "since time " : ", since time ") + number(doubt.since) + " "
                + sentence(limits()[what.first], what.second, doubt.largest);
      }
    std::vector<std::string> result;
    for (const auto &[limit, text] : of_limits)
      result.push_back(text + " (the most of the run). " + consequence(limits()[limit]));
    return result;
  }
} // namespace signorini
