// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/sweeps/sweep_exchange.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    constexpr unsigned int per_node  = 4;
    constexpr int          sweep_tag = 7301;

    void wait_for(std::vector<MPI_Request> &requests)
    {
      const int error = MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
      AssertThrowMPI(error);
      requests.clear();
    }
  } // namespace


  SweepExchange::SweepExchange(const SweepOrder                &order,
                               const std::vector<unsigned int> &position_of,
                               const MPI_Comm                   communicator)
    : communicator(communicator)
  {
    unsigned int n_ghosts = 0;
    for (const SweepOrder::Neighbour &neighbour : order.neighbours)
      {
        n_ghosts = std::max(n_ghosts, neighbour.first_ghost + neighbour.n_ghosts);
        neighbours.push_back({neighbour.rank,
                              neighbour.is_earlier,
                              neighbour.first_ghost,
                              std::vector<float>(per_node * neighbour.n_ghosts),
                              std::vector<float>(per_node * neighbour.wanted.size()),
                              {}});
        for (const unsigned int node : neighbour.wanted)
          neighbours.back().wanted.push_back(position_of[node]);
      }
    ghosts.assign(per_node * n_ghosts, 0.f);
  }


  void SweepExchange::expect(const bool forward)
  {
    expects_earlier = forward;
    for (Neighbour &neighbour : neighbours)
      if (neighbour.is_earlier == forward && !neighbour.incoming.empty())
        {
          receiving.emplace_back();
          const int error = MPI_Irecv(neighbour.incoming.data(),
                                      neighbour.incoming.size(),
                                      MPI_FLOAT,
                                      neighbour.rank,
                                      sweep_tag,
                                      communicator,
                                      &receiving.back());
          AssertThrowMPI(error);
        }
  }


  const std::vector<float> &SweepExchange::receive()
  {
    wait_for(receiving);
    for (const Neighbour &neighbour : neighbours)
      if (neighbour.is_earlier == expects_earlier)
        std::copy(neighbour.incoming.begin(),
                  neighbour.incoming.end(),
                  ghosts.begin() + per_node * neighbour.first_ghost);
    return ghosts;
  }


  void SweepExchange::send(const std::vector<float> &values, const bool forward)
  {
    for (Neighbour &neighbour : neighbours)
      if (neighbour.is_earlier != forward && !neighbour.outgoing.empty())
        {
          auto next = neighbour.outgoing.begin();
          for (const unsigned int position : neighbour.wanted)
            next = std::copy_n(values.begin() + per_node * position, per_node, next);
          sending.emplace_back();
          const int error = MPI_Isend(neighbour.outgoing.data(),
                                      neighbour.outgoing.size(),
                                      MPI_FLOAT,
                                      neighbour.rank,
                                      sweep_tag,
                                      communicator,
                                      &sending.back());
          AssertThrowMPI(error);
        }
  }


  void SweepExchange::finish()
  {
    wait_for(sending);
  }
} // namespace signorini
