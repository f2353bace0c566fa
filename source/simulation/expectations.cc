// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/resolution.h>
#include <signorini/simulation/expectations.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** In the words of the summary, which judges the same after the run. */
    std::vector<std::string> doubts(const std::string    &pair,
                                    const ExpectedImpact &impact,
                                    const double          n_steps,
                                    const bool            is_round,
                                    const unsigned int    enough_nodes)
    {
      std::vector<std::string> result;
      const auto               say = [&](const auto &...parts) {
        std::ostringstream text;
        text.precision(2);
        text << "the first impact of the pair '" << pair << "' is expected to ";
        (text << ... << parts);
        result.push_back(text.str());
      };
      if (is_round && impact.n_nodes < enough_nodes)
        say("be carried by ",
            impact.n_nodes < 1.5 ? "a single node"
                                 : std::to_string(std::lround(impact.n_nodes)) + " nodes",
            ". Force and duration of such a contact may be wrong by 30 %: refine the "
            "mesh where the bodies touch (`Local refinements`, section Adaptivity).");
      // A plane wave is the shortest contact that there is: what bulges sideways comes back later.
      if (n_steps < (is_round ? few_steps : few_steps / 2))
        say(
          "last ", n_steps, " steps. Force and impulse need some twenty: reduce `Time/Step size`.");
      if (impact.strain > large_strain)
        say("strain a body by ",
            100. * impact.strain,
            " %. Strains are linear, and so is Hooke's law: the error is about as large.");
      return result;
    }
  } // namespace


  template <int dim>
  Remarks expectations(const Scene<dim> &scene, const std::vector<FirstImpact> &impacts)
  {
    Remarks remarks;
    // A mesh that changes refines what touches before it does.
    const unsigned int enough_nodes = scene.adaptivity.any() ? 0 : few_nodes(dim);
    for (const FirstImpact &first : impacts)
      {
        if (!first.is_known)
          continue;
        const ExpectedImpact &impact  = first.impact;
        const std::string    &pair    = scene.pairs[first.pair].name;
        const double          n_steps = scene.step_sizes.is_variable()
                                          ? std::numeric_limits<double>::infinity()
                                          : impact.duration / scene.time.step_size;
        std::ostringstream    text;
        text.precision(3);
        text << "expected of the first impact of '" << pair << "', at time " << first.time
             << " with speed " << first.speed << ": force " << impact.force << ", contact for "
             << impact.duration;
        if (std::isfinite(n_steps))
          text << " (" << n_steps << " steps)";
        const double n_nodes = std::max(1., std::round(impact.n_nodes));
        text << " on " << n_nodes << (n_nodes > 1. ? " nodes" : " node") << ", strain "
             << 100. * impact.strain << " % (" << (first.is_round ? "Hertz" : "a plane wave")
             << ", without other forces)";
        remarks.notes.push_back(text.str());
        for (const std::string &doubt : doubts(pair, impact, n_steps, first.is_round, enough_nodes))
          remarks.warnings.push_back(doubt);
      }
    return remarks;
  }


  template Remarks expectations(const Scene<2> &, const std::vector<FirstImpact> &);
  template Remarks expectations(const Scene<3> &, const std::vector<FirstImpact> &);
} // namespace signorini
