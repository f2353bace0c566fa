// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_missing_pairs_h
#define signorini_diagnostics_missing_pairs_h

#include <signorini/base/archive.h>
#include <signorini/discretization/discretization.h>
#include <signorini/model/contact_description.h>
#include <signorini/obstacles/rigid_obstacle.h>

#include <string>
#include <vector>

namespace signorini
{
  /**
   * Watches what is not in `Contact/Pairs`: nothing keeps these bodies and obstacles apart, and
   * whoever forgot the pair sees a motion without contact. Each overlap is told once, because it
   * may be meant.
   *
   * An obstacle is looked for at the vertices of the body's surface, as deep as Validity allows a
   * body in its partner. Bodies overlap if a vertex, the centre of a face or of a cell at the
   * surface of one is well inside a cell of the other, both in their present shapes; boxes around
   * the bodies are compared first, and less often where they keep overlapping.
   */
  template <int dim>
  class MissingPairs
  {
  public:
    MissingPairs(unsigned int                           n_bodies,
                 const std::vector<NamedObstacle<dim>> &obstacles,
                 const std::vector<PairDescription>    &pairs);

    /**
     * To be called after each step; most calls do nothing. Collective.
     * @param last whether it is the last step, which is always looked at
     * @return what begins to overlap, a sentence each; the same on all processes
     */
    std::vector<std::string> judge(const Discretization<dim> &discretization,
                                   const Vector              &displacement,
                                   double                     time,
                                   bool                       last);

    /** What was told of, and when to look next. */
    void archive(Archive &archive) { archive(body_obstacle, body_body, n_calls); }

  private:
    struct Absent
    {
      unsigned int body, other;
      unsigned int next_look = 0; ///< of bodies whose boxes overlap: number of the call
    };

    const std::vector<NamedObstacle<dim>> obstacles;
    std::vector<Absent>                   body_obstacle, body_body; ///< not told of yet
    unsigned int                          n_calls = 0;
  };
} // namespace signorini

#endif
