// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/contact_rows.h>

#include <Eigen/Core>

#include <set>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The owner of each of the nodes, which other processes own. Collective. */
    template <int dim>
    std::map<types::global_dof_index, unsigned int>
    owners_of(const Utilities::MPI::Partitioner       &partitioner,
              const std::set<types::global_dof_index> &nodes)
    {
      IndexSet entries(partitioner.size());
      for (const auto node : nodes)
        entries.add_index(dim * node);
      const auto ranks = Utilities::MPI::compute_index_owner(
        partitioner.locally_owned_range(), entries, partitioner.get_mpi_communicator());
      std::map<types::global_dof_index, unsigned int> result;
      for (const auto node : nodes)
        result[node] = ranks[entries.index_within_set(dim * node)];
      return result;
    }


    /** The contact nodes with partners that this process knows without asking others. */
    template <int dim>
    std::vector<ContactRow<dim>> known_rows(const NodePattern             &pattern,
                                            const ContactCoordinates<dim> &coordinates)
    {
      const auto &partitioner = *pattern.partitioner;
      const auto  global_node = [&](const unsigned int local) {
        return partitioner.local_to_global(dim * local) / dim;
      };

      std::vector<ContactRow<dim>>         rows;
      std::map<unsigned int, unsigned int> row_of; // by local node
      for (const ContactNode<dim> &contact_node : coordinates.surface_nodes())
        if (!contact_node.partners.empty())
          {
            row_of[contact_node.node] = rows.size();
            ContactRow<dim> &row      = rows.emplace_back();
            row.node                  = global_node(contact_node.node);
            row.partners              = contact_node.partners;
            for (unsigned int k = 0; k < dim; ++k)
              if (contact_node.relative[k])
                std::copy_n(
                  contact_node.frame.begin() + dim * k, dim, row.directions.emplace_back().begin());
          }
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          {
            const unsigned int column = pattern.columns[k];
            if (const auto row = row_of.find(node); row != row_of.end())
              rows[row->second].neighbours.push_back(global_node(column));
            if (const auto row = row_of.find(column); row != row_of.end() && column != node)
              rows[row->second].neighbours.push_back(global_node(node));
          }
      return rows;
    }


    /** Sends rows to the owners of nodes, but for this process, and to none twice. */
    template <int dim>
    class RowExchange
    {
    public:
      explicit RowExchange(const Utilities::MPI::Partitioner &partitioner)
        : partitioner(partitioner)
      {
      }

      void send(const ContactRow<dim> &row, const types::global_dof_index to_owner_of)
      {
        if (!partitioner.in_local_range(dim * to_owner_of))
          addressees[to_owner_of].insert(&row);
      }

      /** What others have sent. Collective. */
      std::vector<ContactRow<dim>> receive()
      {
        std::set<types::global_dof_index> strangers;
        for (const auto &[node, rows] : addressees)
          strangers.insert(node);
        std::map<unsigned int, std::set<const ContactRow<dim> *>> by_rank;
        for (const auto &[node, rank] : owners_of<dim>(partitioner, strangers))
          for (const ContactRow<dim> *row : addressees[node])
            if (sent.emplace(rank, row).second)
              by_rank[rank].insert(row);
        addressees.clear();

        std::map<unsigned int, std::vector<ContactRow<dim>>> outgoing;
        for (const auto &[rank, rows] : by_rank)
          for (const ContactRow<dim> *row : rows)
            outgoing[rank].push_back(*row);
        std::vector<ContactRow<dim>> result;
        for (const auto &[rank, received] :
             Utilities::MPI::some_to_some(partitioner.get_mpi_communicator(), outgoing))
          result.insert(result.end(), received.begin(), received.end());
        return result;
      }

    private:
      const Utilities::MPI::Partitioner                                   &partitioner;
      std::map<types::global_dof_index, std::set<const ContactRow<dim> *>> addressees;
      std::set<std::pair<unsigned int, const ContactRow<dim> *>>           sent;
    };
  } // namespace


  template <int dim>
  std::vector<ContactRow<dim>> gather_contact_rows(const NodePattern             &pattern,
                                                   const ContactCoordinates<dim> &coordinates)
  {
    const auto own = known_rows<dim>(pattern, coordinates);

    RowExchange<dim> exchange(*pattern.partitioner);
    for (const ContactRow<dim> &row : own)
      {
        for (const auto &[partner, weight] : row.partners)
          exchange.send(row, partner);
        for (const auto neighbour : row.neighbours)
          exchange.send(row, neighbour);
      }
    std::vector<ContactRow<dim>> rows = exchange.receive();
    rows.insert(rows.end(), own.begin(), own.end());

    // Who owns a partner couples it with the partners of the neighbours, too.
    std::map<types::global_dof_index, const ContactRow<dim> *> own_row;
    for (const ContactRow<dim> &row : own)
      own_row[row.node] = &row;
    for (const ContactRow<dim> &row : rows)
      for (const auto neighbour : row.neighbours)
        if (const auto of_neighbour = own_row.find(neighbour); of_neighbour != own_row.end())
          for (const auto &[partner, weight] : row.partners)
            exchange.send(*of_neighbour->second, partner);
    const auto of_neighbours = exchange.receive();
    rows.insert(rows.end(), of_neighbours.begin(), of_neighbours.end());
    return rows;
  }


  template <int dim>
  std::map<types::global_dof_index, BlockRow<dim>>
  import_rows(const ElasticMatrices<dim>                 &matrices,
              const MatrixSum                            &sum,
              const std::vector<types::global_dof_index> &nodes)
  {
    const NodePattern &pattern      = matrices.pattern;
    const auto        &partitioner  = *pattern.partitioner;
    const MPI_Comm     communicator = partitioner.get_mpi_communicator();

    std::map<unsigned int, std::vector<types::global_dof_index>> requests;
    for (const auto &[node, rank] :
         owners_of<dim>(partitioner, std::set<types::global_dof_index>(nodes.begin(), nodes.end())))
      requests[rank].push_back(node);
    const auto incoming = Utilities::MPI::some_to_some(communicator, requests);

    // One pass over the upper triangle finds the full rows of all nodes that anyone asked for.
    std::map<unsigned int, BlockRow<dim>> rows; // by local node
    for (const auto &[rank, asked] : incoming)
      for (const auto node : asked)
        rows[partitioner.global_to_local(dim * node) / dim];
    if (!rows.empty())
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          {
            const unsigned int column = pattern.columns[k];
            const auto         row = rows.find(node), mirrored = rows.find(column);
            if (row != rows.end())
              row->second.emplace_back(partitioner.local_to_global(dim * column) / dim,
                                       matrices.combined_block(node, k, sum));
            if (column != node && mirrored != rows.end())
              {
                auto block = matrices.combined_block(node, k, sum);
                Eigen::Map<Eigen::Matrix<double, dim, dim>>(block.data()).transposeInPlace();
                mirrored->second.emplace_back(partitioner.local_to_global(dim * node) / dim, block);
              }
          }

    using Rows = std::vector<std::pair<types::global_dof_index, BlockRow<dim>>>;
    std::map<unsigned int, Rows> replies;
    for (const auto &[rank, asked] : incoming)
      for (const auto node : asked)
        replies[rank].emplace_back(node, rows[partitioner.global_to_local(dim * node) / dim]);
    std::map<types::global_dof_index, BlockRow<dim>> result;
    for (const auto &[rank, received] : Utilities::MPI::some_to_some(communicator, replies))
      result.insert(received.begin(), received.end());
    return result;
  }


  template std::vector<ContactRow<2>> gather_contact_rows(const NodePattern &,
                                                          const ContactCoordinates<2> &);
  template std::vector<ContactRow<3>> gather_contact_rows(const NodePattern &,
                                                          const ContactCoordinates<3> &);
  template std::map<types::global_dof_index, BlockRow<2>>
  import_rows(const ElasticMatrices<2> &,
              const MatrixSum &,
              const std::vector<types::global_dof_index> &);
  template std::map<types::global_dof_index, BlockRow<3>>
  import_rows(const ElasticMatrices<3> &,
              const MatrixSum &,
              const std::vector<types::global_dof_index> &);
} // namespace signorini
