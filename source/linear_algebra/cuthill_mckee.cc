// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/cuthill_mckee.h>

#include <algorithm>
#include <numeric>

namespace signorini
{
  namespace
  {
    /** The neighbours of each node, from both triangles. */
    struct Graph
    {
      std::vector<unsigned int> row_start, neighbours;

      explicit Graph(const NodePattern &pattern)
        : row_start(pattern.n_local + 1, 0)
      {
        const auto for_each_coupling = [&](const auto &action) {
          for (unsigned int node = 0; node < pattern.n_local; ++node)
            for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
              if (pattern.columns[k] != node)
                {
                  action(node, pattern.columns[k]);
                  action(pattern.columns[k], node);
                }
        };
        for_each_coupling([&](const unsigned int node, unsigned int) { ++row_start[node + 1]; });
        std::partial_sum(row_start.begin(), row_start.end(), row_start.begin());
        neighbours.resize(row_start.back());
        std::vector<unsigned int> next(row_start.begin(), row_start.end() - 1);
        for_each_coupling([&](const unsigned int node, const unsigned int other) {
          neighbours[next[node]++] = other;
        });
      }

      unsigned int degree(const unsigned int node) const
      {
        return row_start[node + 1] - row_start[node];
      }
    };


    /**
     * Append to `numbering` what is connected with its nodes from `head` on, level by level, nodes
     * with few neighbours first.
     */
    void extend(const Graph               &graph,
                std::size_t                head,
                std::vector<char>         &visited,
                std::vector<unsigned int> &numbering)
    {
      for (; head < numbering.size(); ++head)
        {
          const unsigned int node  = numbering[head];
          const std::size_t  first = numbering.size();
          for (unsigned int k = graph.row_start[node]; k < graph.row_start[node + 1]; ++k)
            if (const unsigned int neighbour = graph.neighbours[k]; !visited[neighbour])
              {
                visited[neighbour] = 1;
                numbering.push_back(neighbour);
              }
          // By insertion: few at a time, and std::stable_sort() asks for memory each time.
          const auto fewer_neighbours = [&](const auto a, const auto b) {
            return graph.degree(a) < graph.degree(b);
          };
          const auto begin = numbering.begin() + first;
          for (auto next = begin; next != numbering.end(); ++next)
            std::rotate(std::upper_bound(begin, next, *next, fewer_neighbours), next, next + 1);
        }
    }


    /** Append the connected part of `start` to `numbering`. */
    void traverse(const Graph               &graph,
                  const unsigned int         start,
                  std::vector<char>         &visited,
                  std::vector<unsigned int> &numbering)
    {
      numbering.push_back(start);
      visited[start] = 1;
      extend(graph, numbering.size() - 1, visited, numbering);
    }
  } // namespace


  std::vector<unsigned int> cuthill_mckee(const NodePattern               &pattern,
                                          const std::vector<unsigned int> &first)
  {
    const Graph               graph(pattern);
    std::vector<unsigned int> numbering = first, trial;
    std::vector<char>         visited(pattern.n_local, 0), scratch(pattern.n_local);
    numbering.reserve(pattern.n_local);
    for (const unsigned int node : first)
      visited[node] = 1;
    extend(graph, 0, visited, numbering);
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      if (!visited[node])
        {
          // The last node of a traversal lies at the periphery; two trials find a good start.
          unsigned int start = node;
          for (unsigned int k = 0; k < 2; ++k)
            {
              scratch = visited;
              trial.clear();
              traverse(graph, start, scratch, trial);
              start = trial.back();
            }
          traverse(graph, start, visited, numbering);
        }
    return numbering;
  }
} // namespace signorini
