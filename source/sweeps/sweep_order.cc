// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/cuthill_mckee.h>
#include <signorini/sweeps/sweep_order.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <set>

namespace signorini
{
  namespace
  {
    using dealii::Utilities::MPI::Partitioner;

    /** The other processes, what they own of the ghosts here, and what they want from here. */
    template <int dim>
    std::vector<SweepOrder::Neighbour> neighbours_of(const Partitioner &partitioner)
    {
      std::map<unsigned int, SweepOrder::Neighbour> by_rank;
      unsigned int                                  first_ghost = 0;
      for (const auto &[rank, n_entries] : partitioner.ghost_targets())
        {
          by_rank[rank] = {rank, false, first_ghost, n_entries / dim, {}};
          first_ghost += n_entries / dim;
        }
      auto         chunk = partitioner.import_indices().begin();
      unsigned int taken = 0; // of the chunk
      for (const auto &[rank, n_entries] : partitioner.import_targets())
        {
          SweepOrder::Neighbour &neighbour =
            by_rank.emplace(rank, SweepOrder::Neighbour{rank, false, 0, 0, {}}).first->second;
          for (unsigned int entry = 0; entry < n_entries; ++entry)
            {
              if (chunk->first + taken == chunk->second)
                ++chunk, taken = 0;
              const unsigned int i = chunk->first + taken++;
              if (i % dim == 0)
                neighbour.wanted.push_back(i / dim);
            }
        }
      std::vector<SweepOrder::Neighbour> result;
      for (auto &[rank, neighbour] : by_rank)
        result.push_back(std::move(neighbour));
      return result;
    }


    /** Of each process, the smallest one that none of its neighbours of lower rank has. */
    std::vector<unsigned int> colours(const std::vector<SweepOrder::Neighbour> &neighbours,
                                      const MPI_Comm                            communicator)
    {
      std::vector<unsigned int> ranks;
      for (const auto &neighbour : neighbours)
        ranks.push_back(neighbour.rank);
      std::vector<std::set<unsigned int>> graph; // either may know the other without being known
      const auto all = dealii::Utilities::MPI::all_gather(communicator, ranks);
      graph.resize(all.size());
      for (unsigned int rank = 0; rank < all.size(); ++rank)
        for (const unsigned int other : all[rank])
          {
            graph[rank].insert(other);
            graph[other].insert(rank);
          }
      std::vector<unsigned int> result(all.size());
      for (unsigned int rank = 0; rank < all.size(); ++rank)
        {
          std::set<unsigned int> taken;
          for (const unsigned int other : graph[rank])
            if (other < rank)
              taken.insert(result[other]);
          while (taken.count(result[rank]) > 0)
            ++result[rank];
        }
      return result;
    }


    /** Of the owned nodes, whether they are coupled with ghosts. */
    std::vector<char> coupled_with_ghosts(const NodePattern &pattern)
    {
      std::vector<char> result(pattern.n_owned, 0);
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        if (!pattern.is_empty(node))
          result[node] = pattern.columns[pattern.row_start[node + 1] - 1] >= pattern.n_owned;
      return result;
    }
  } // namespace


  template <int dim>
  SweepOrder SweepOrder::of(const NodePattern &pattern)
  {
    SweepOrder     result;
    const MPI_Comm communicator = pattern.partitioner->get_mpi_communicator();
    double         place        = 0.; // of the interface among the other nodes, from 0 to 1
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      {
        result.neighbours            = neighbours_of<dim>(*pattern.partitioner);
        const auto         colour_of = colours(result.neighbours, communicator);
        const unsigned int own  = colour_of[dealii::Utilities::MPI::this_mpi_process(communicator)],
                           last = *std::max_element(colour_of.begin(), colour_of.end());
        for (Neighbour &neighbour : result.neighbours)
          neighbour.is_earlier = colour_of[neighbour.rank] < own;
        place = last == 0 ? 0. : static_cast<double>(own) / last;
      }

    const std::vector<char>   is_interface = coupled_with_ghosts(pattern);
    std::vector<unsigned int> interface;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (is_interface[node])
        interface.push_back(node);
    for (const unsigned int node : cuthill_mckee(pattern, interface))
      if (node < pattern.n_owned && !is_interface[node])
        result.nodes.push_back(node);
    if (place > 0.5)
      std::reverse(result.nodes.begin(), result.nodes.end());
    result.interface_begin = static_cast<unsigned int>(place * result.nodes.size());
    result.interface_end   = result.interface_begin + interface.size();
    result.nodes.insert(
      result.nodes.begin() + result.interface_begin, interface.begin(), interface.end());
    result.sort_by(SeparateParts::of<dim>(pattern));
    return result;
  }


  SweepOrder SweepOrder::restricted_to(const std::vector<char> &is_wanted) const
  {
    SweepOrder result;
    result.neighbours = neighbours;
    for (unsigned int s = 0; s < part_begin.size(); ++s)
      for (unsigned int k = 0; k <= n_parts(); ++k)
        {
          result.part_begin[s].push_back(result.nodes.size());
          if (k < n_parts())
            for (unsigned int position = part_begin[s][k]; position < part_begin[s][k + 1];
                 ++position)
              if (is_wanted[nodes[position]])
                result.nodes.push_back(nodes[position]);
        }
    result.interface_begin = result.part_begin[1].front();
    result.interface_end   = result.part_begin[1].back();
    return result;
  }


  void SweepOrder::sort_by(const SeparateParts &parts)
  {
    const std::array<unsigned int, 4> segments{
      {0, interface_begin, interface_end, static_cast<unsigned int>(nodes.size())}};
    for (unsigned int s = 0; s < part_begin.size(); ++s)
      {
        const auto begin = nodes.begin() + segments[s], end = nodes.begin() + segments[s + 1];
        if (parts.n > 1)
          std::stable_sort(begin, end, [&](const unsigned int a, const unsigned int b) {
            return parts.part_of[a] < parts.part_of[b];
          });
        for (unsigned int k = 0; k <= parts.n; ++k)
          part_begin[s].push_back(
            std::partition_point(
              begin, end, [&](const unsigned int node) { return parts.part_of[node] < k; })
            - nodes.begin());
      }
  }


  bool SweepOrder::is_earlier(const unsigned int ghost) const
  {
    for (const Neighbour &neighbour : neighbours)
      if (ghost >= neighbour.first_ghost && ghost < neighbour.first_ghost + neighbour.n_ghosts)
        return neighbour.is_earlier;
    Assert(false, dealii::ExcMessage("A ghost has an owner."));
    return false;
  }


  template SweepOrder SweepOrder::of<2>(const NodePattern &);
  template SweepOrder SweepOrder::of<3>(const NodePattern &);
} // namespace signorini
