// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_node_owners_h
#define signorini_discretization_node_owners_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <algorithm>
#include <map>
#include <vector>

namespace signorini
{
  /** Who owns a node: nodes are numbered process by process. */
  class NodeOwners
  {
  public:
    /** Collective. @param n_owned nodes of this process */
    NodeOwners(const unsigned int n_owned, const MPI_Comm communicator)
      : communicator(communicator)
    {
      dealii::types::global_dof_index end = 0;
      for (const unsigned int n : dealii::Utilities::MPI::all_gather(communicator, n_owned))
        ends.push_back(end += n);
    }

    unsigned int operator()(const dealii::types::global_dof_index node) const
    {
      return std::upper_bound(ends.begin(), ends.end(), node) - ends.begin();
    }

    dealii::types::global_dof_index n_nodes() const { return ends.back(); }

    /**
     * What the owners know about nodes, in the order of the nodes; any of them may be one's own.
     * Collective. @param knowledge of an owned node
     */
    template <typename Knowledge>
    auto ask(const std::vector<dealii::types::global_dof_index> &nodes,
             const Knowledge                                    &knowledge) const
    {
      using Node   = dealii::types::global_dof_index;
      using Answer = std::decay_t<decltype(knowledge(Node()))>;
      std::map<unsigned int, std::vector<Node>>        questions;
      std::map<unsigned int, std::vector<std::size_t>> places;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const unsigned int owner = (*this)(nodes[k]);
          questions[owner].push_back(nodes[k]);
          places[owner].push_back(k);
        }
      std::map<unsigned int, std::vector<Answer>> answers;
      for (const auto &[rank, asked] :
           dealii::Utilities::MPI::some_to_some(communicator, questions))
        for (const Node node : asked)
          answers[rank].push_back(knowledge(node));
      std::vector<Answer> result(nodes.size());
      for (auto &[rank, received] : dealii::Utilities::MPI::some_to_some(communicator, answers))
        for (std::size_t k = 0; k < received.size(); ++k)
          result[places.at(rank)[k]] = received[k];
      return result;
    }

  private:
    const MPI_Comm                               communicator;
    std::vector<dealii::types::global_dof_index> ends;
  };
} // namespace signorini

#endif
