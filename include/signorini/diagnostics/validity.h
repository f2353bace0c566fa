// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_validity_h
#define signorini_diagnostics_validity_h

#include <map>
#include <set>
#include <signorini/base/archive.h>
#include <string>
#include <vector>

namespace signorini
{
  /** What the method takes to be small, at one time. In the order of bodies and of pairs. */
  struct ValidityReading
  {
    double              time = 0.;
    std::vector<double> depth;    ///< of bodies in obstacles by the true geometry, over their sizes
    std::vector<double> rotation; ///< of bodies, radians
    std::vector<double> strain;   ///< of bodies, the largest principal one
    std::vector<double> sliding;  ///< of bodies in pairs on each other, in sizes of a face
    /** Of contact nodes of bodies: alternating velocities over those of the motion. */
    std::vector<double> alternation = {};
    /** The same of nodes whose displacement is prescribed. */
    std::vector<double> prescribed = {};
    /** Of bodies, radians: normals at nodes that stay in contact, see TurningNormals. */
    std::vector<double> turning = {};
  };

  /**
   * Watches whether the run is still within what the method can do: linear strains, contact that is
   * linearised about the initial configuration. What is exceeded is said once, when it begins, and
   * again at the end with the largest value; what to do about it, each time for the first body.
   */
  class Validity
  {
  public:
    /**
     * @param contact_follows   the motion, and is not linearised
     * @param scheme_that_turns the name of one that is right where normals turn
     * @param how_to_follow     see ContactSurface
     */
    Validity(const std::vector<std::string> &bodies,
             const std::vector<std::string> &pairs,
             bool                            contact_follows   = false,
             const std::string              &scheme_that_turns = "",
             const std::string              &how_to_follow     = set_motion_to_follow);

    /** @return what begins to be doubtful, a sentence each with the time */
    std::vector<std::string> judge(const ValidityReading &reading);

    /** All that has been doubtful: since when, how much at most, and what not to trust. */
    std::vector<std::string> summary() const;

    /** Turns by more than this make linear strains wrong: radians. */
    static double rotation_limit();

    /** What is doubtful so far. */
    void archive(Archive &archive);

  private:
    struct Limit;
    struct Doubt
    {
      double since, largest;
    };

    const std::vector<std::string>                       bodies, pairs;
    const bool                                           contact_follows;
    const std::string                                    scheme_that_turns, how_to_follow;
    std::map<std::pair<std::size_t, std::size_t>, Doubt> doubts;    ///< by limit, then body or pair
    std::set<std::size_t>                                explained; ///< limits

    static const std::vector<Limit> &limits();
    std::string                      consequence(const Limit &limit) const;
    std::string sentence(const Limit &limit, std::size_t subject, double value) const;
  };
} // namespace signorini

#endif
