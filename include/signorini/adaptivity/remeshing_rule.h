// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_remeshing_rule_h
#define signorini_adaptivity_remeshing_rule_h

#include <signorini/adaptivity/mark_cells.h>
#include <signorini/base/archive.h>
#include <signorini/model/adaptivity_parameters.h>

namespace signorini
{
  /**
   * When the mesh is judged, and whether what it lacks is worth a change. After every so many steps
   * and always, if the scene says so. Else as one who rents does not buy before rents amount to the
   * price: what steps have lost on the present mesh is summed up, and the mesh changes when the sum
   * is the cost of a change. At most twice the cost of the best choice, made in hindsight, is paid
   * then.
   *
   * A step on a mesh loses the part of the squared estimate that the cells to be refined make,
   * times by how much the estimate has grown since the mesh was new; and the part of the cells that
   * could be spared. (Squared errors fall like the inverse of the number of cells in 2d, so that
   * both are parts of the same cost.) Contact that is about to meet coarse cells does not wait.
   */
  class RemeshingRule
  {
  public:
    explicit RemeshingRule(const AdaptivityParameters &parameters);

    /** Whether the mesh is to be judged after a step. */
    bool is_due(unsigned int step) const { return step >= next_judgement; }

    /**
     * The mesh was judged after a step.
     * @param longest_wait steps until it is judged again, at most
     * @return whether it should change as the flags say
     */
    bool pays(const MeshChange &change, unsigned int step, unsigned int longest_wait);

    /** The mesh changes after a step. */
    void mesh_changes(unsigned int step);

    void archive(Archive &archive)
    {
      archive(lost, squared_estimate_of_new_mesh, last_judgement, next_judgement, is_new);
    }

  private:
    unsigned int steps_between; ///< 0: when it pays
    double       lost                         = 0.;
    double       squared_estimate_of_new_mesh = 0.;
    unsigned int last_judgement = 0, next_judgement = 0;
    bool         is_new = true;

    double loss_of_a_step(const MeshChange &change) const;
  };
} // namespace signorini

#endif
