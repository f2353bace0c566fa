// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_local_nodes_h
#define signorini_discretization_local_nodes_h

#include <deal.II/base/types.h>

#include <algorithm>
#include <vector>

namespace signorini
{
  /**
   * Local numbers of nodes: first the owned ones, which are consecutive, then ghosts by their
   * global number.
   */
  struct LocalNodes
  {
    dealii::types::global_dof_index              first_owned = 0;
    unsigned int                                 n_owned     = 0;
    std::vector<dealii::types::global_dof_index> ghosts; ///< ascending

    unsigned int size() const { return n_owned + ghosts.size(); }

    bool owns(const dealii::types::global_dof_index global) const
    {
      return global >= first_owned && global < first_owned + n_owned;
    }

    /** The local number, or size() of a node that is unknown here. */
    unsigned int local(const dealii::types::global_dof_index global) const
    {
      if (owns(global))
        return global - first_owned;
      const auto found = std::lower_bound(ghosts.begin(), ghosts.end(), global);
      return found != ghosts.end() && *found == global ? n_owned + (found - ghosts.begin())
                                                       : size();
    }

    dealii::types::global_dof_index global(const unsigned int local) const
    {
      return local < n_owned ? first_owned + local : ghosts[local - n_owned];
    }

    /** Ghosts in any order, with repetitions: bring them into order. */
    void sort_ghosts()
    {
      std::sort(ghosts.begin(), ghosts.end());
      ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    }
  };
} // namespace signorini

#endif
