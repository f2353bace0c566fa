// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_law_guard_h
#define signorini_diagnostics_law_guard_h

#include <array>
#include <set>
#include <string>
#include <vector>

namespace signorini
{
  /** Laws that schemes keep exactly, whatever mesh and step: what is left is solvers' accuracy. */
  enum class Law
  {
    no_gain,         ///< contact, predictor and friction add no energy
    energy_identity, ///< what a step reports explains the change of the energy
    no_adhesion,     ///< normal contact forces press
    coulomb,         ///< friction forces stay within their bound
    no_penetration,  ///< gaps do not become negative
    momentum         ///< forces explain the change of momentum of each body
  };

  constexpr std::array<Law, 6> all_laws = {{Law::no_gain,
                                            Law::energy_identity,
                                            Law::no_adhesion,
                                            Law::coulomb,
                                            Law::no_penetration,
                                            Law::momentum}};

  /** By how much a step breaks each law. */
  struct LawReading
  {
    double time = 0.;
    /**
     * In the order of all_laws: energies over the largest energy, forces over the largest nodal
     * force, lengths over the size of the bodies, residuals of momentum over the forces in its
     * balance. Zero or less if a law is kept.
     */
    std::array<double, all_laws.size()> violation{};
    /**
     * Relative, of forces that move bodies: stiffness is larger than inertia by the square of the
     * Courant number, and takes the digits.
     */
    double round_off = 0.;
  };

  /**
   * Stands guard over the laws that a scheme proves: a violation beyond doubt is an error of a
   * solver or of the program, not of the discretisation, and no result is to be trusted after it.
   */
  class LawGuard
  {
  public:
    /**
     * @param scheme   its name, for messages
     * @param proved   the laws that it keeps
     * @param accuracy of the solvers, relative: `Solver/Tolerance`
     */
    LawGuard(const std::string &scheme, const std::set<Law> &proved, double accuracy);

    /** @return the laws that this step is the first one to break, a diagnosis each */
    std::vector<std::string> judge(const LawReading &reading);

    /** From which violation on a law counts as broken. @param round_off see LawReading */
    double limit(Law law, double round_off = 0.) const;

  private:
    const std::string scheme;
    const double      accuracy;
    std::set<Law>     watched; ///< proved, and not broken yet

    std::string diagnosis(Law law, double violation, const LawReading &reading) const;
  };
} // namespace signorini

#endif
