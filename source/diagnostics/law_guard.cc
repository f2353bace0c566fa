// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/law_guard.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** What a law forbids, in which unit it is measured, and from where on it is broken. */
    struct LawText
    {
      const char *broken, *unit;
      double      limit;
    };

    LawText text_of(const Law law)
    {
      switch (law)
        {
        case Law::no_gain:
          return {"contact, predictor and friction have added energy in a step",
                  "of the largest energy of the motion",
                  1e-6};
        case Law::energy_identity:
          return {"the works of a step do not explain its change of energy",
                  "of the largest energy of the motion",
                  1e-6};
        case Law::no_adhesion:
          return {
            "a contact node is pulled instead of pressed", "of the largest contact force", 1e-5};
        case Law::coulomb:
          // Where contact follows the motion, a step is made again until its bounds agree.
          return {"a friction force exceeds its bound", "of the largest contact force", 1e-4};
        case Law::no_penetration:
          return {"a node is inside of what it touches", "of the size of the bodies", 1e-6};
        case Law::momentum:
          return {"the forces on a body do not explain the change of its momentum",
                  "of these forces",
                  1e-5};
        }
      return {"", "", 0.};
    }

    /** Between what solvers are asked for and what they give in the worst of many steps. */
    constexpr double margin = 1e4;
    /** Between one rounding and those of a step. */
    constexpr double many_roundings = 100.;
  } // namespace


  LawGuard::LawGuard(const std::string &scheme, const std::set<Law> &proved, const double accuracy)
    : scheme(scheme)
    , accuracy(accuracy)
    , watched(proved)
  {
  }


  double LawGuard::limit(const Law law, const double round_off) const
  {
    const double of_forces = law == Law::no_penetration ? 0. : many_roundings * round_off;
    return std::max({text_of(law).limit, margin * accuracy, of_forces});
  }


  std::vector<std::string> LawGuard::judge(const LawReading &reading)
  {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < all_laws.size(); ++i)
      // A violation that is not a number is none that is small.
      if (!(reading.violation[i] <= limit(all_laws[i], reading.round_off))
          && watched.erase(all_laws[i]) > 0)
        result.push_back(diagnosis(all_laws[i], reading.violation[i], reading));
    return result;
  }


  std::string
  LawGuard::diagnosis(const Law law, const double violation, const LawReading &reading) const
  {
    const LawText      text_of_law = text_of(law);
    std::ostringstream text;
    text.precision(3);
    text << "at time " << reading.time << " a law is broken that `Time/Scheme = " << scheme
         << "` keeps on every mesh and with every step: " << text_of_law.broken << " (" << violation
         << " " << text_of_law.unit << ", where " << limit(law, reading.round_off)
         << " would be beyond the accuracy of the solvers). A smaller `Solver/Tolerance` may help; "
            "otherwise it is a mistake of the program: please report it with this folder. "
            "`Output/Guard = warn` lets such runs go on.";
    return text.str();
  }
} // namespace signorini
