// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/cuthill_mckee.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    unsigned int degree(const NodePattern &pattern, const unsigned int node)
    {
      return pattern.row_start[node + 1] - pattern.row_start[node];
    }


    /** Append the connected part of `start` to `numbering`, level by level, nodes with few neighbours first. */
    void traverse(const NodePattern         &pattern,
                  const unsigned int         start,
                  std::vector<char>         &visited,
                  std::vector<unsigned int> &numbering)
    {
      std::size_t head = numbering.size();
      numbering.push_back(start);
      visited[start] = 1;
      for (; head < numbering.size(); ++head)
        {
          const unsigned int node  = numbering[head];
          const std::size_t  first = numbering.size();
          for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
            if (!visited[pattern.columns[k]])
              {
                visited[pattern.columns[k]] = 1;
                numbering.push_back(pattern.columns[k]);
              }
          std::stable_sort(numbering.begin() + first, numbering.end(), [&](const auto a, const auto b) {
            return degree(pattern, a) < degree(pattern, b);
          });
        }
    }
  } // namespace


  std::vector<unsigned int> cuthill_mckee(const NodePattern &pattern)
  {
    std::vector<unsigned int> numbering, trial;
    std::vector<char>         visited(pattern.n_local, 0), scratch(pattern.n_local);
    numbering.reserve(pattern.n_local);
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      if (!visited[node])
        {
          // The last node of a traversal lies at the periphery; two trials find a good start.
          unsigned int start = node;
          for (unsigned int k = 0; k < 2; ++k)
            {
              scratch = visited;
              trial.clear();
              traverse(pattern, start, scratch, trial);
              start = trial.back();
            }
          traverse(pattern, start, visited, numbering);
        }
    return numbering;
  }
} // namespace signorini
