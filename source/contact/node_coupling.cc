// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/node_coupling.h>

#include <cmath>
#include <map>
#include <set>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  NodeCoupling<dim>::NodeCoupling(
    const std::vector<ContactNode<dim>>                      &nodes,
    const std::shared_ptr<const Utilities::MPI::Partitioner> &partitioner,
    const bool                                                partners_may_come)
    : partners_change(partners_may_come)
    , n_owned_entries(partitioner->locally_owned_size())
  {
    std::vector<types::global_dof_index> ghosts;
    for (const ContactNode<dim> &node : nodes)
      for (const auto &[partner, weight] : node.partners)
        if (!partitioner->in_local_range(dim * partner))
          ghosts.push_back(partner);
    const MPI_Comm communicator = partitioner->get_mpi_communicator();
    partners                    = std::make_shared<Utilities::MPI::Partitioner>(
      partitioner->locally_owned_range(),
      entries_of_nodes<dim>(partitioner->size(), std::move(ghosts)),
      communicator);
    ghost_values.resize(partners->n_ghost_indices());
    import_storage.resize(partners->n_import_indices());

    relative_start.assign(1, 0);
    row_start.assign(1, 0);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const ContactNode<dim> &node = nodes[k];
        for (unsigned int row = 0; row < dim; ++row)
          if (node.relative[row])
            {
              relative.push_back(dim * node.node + row);
              relative_nodes.push_back(k);
              directions.push_back(node.direction(row));
            }
        relative_start.push_back(relative.size());
        for (const auto &[partner, weight] : node.partners)
          entries.emplace_back(partners->global_to_local(dim * partner), weight);
        row_start.push_back(entries.size());
      }
    const bool are_there =
      Utilities::MPI::max(static_cast<unsigned int>(!entries.empty()), communicator) > 0;
    has_partners = are_there || partners_may_come;
    level_of.assign(nodes.size(), 0);
    if (are_there)
      find_levels(nodes, partitioner);
  }


  template <int dim>
  void NodeCoupling<dim>::find_levels(
    const std::vector<ContactNode<dim>>                      &nodes,
    const std::shared_ptr<const Utilities::MPI::Partitioner> &partitioner)
  {
    Vector level_of_nodes(partitioner); // first entries
    for (unsigned int round = 0, any_changes = 1; any_changes > 0 && round <= most_levels; ++round)
      {
        bool changes = false;
        fetch(level_of_nodes);
        std::map<unsigned int, double> next;
        for (std::size_t k = 0; k < nodes.size(); ++k)
          if (relative_start[k] < relative_start[k + 1])
            {
              double highest = 0.;
              for (unsigned int j = row_start[k]; j < row_start[k + 1]; ++j)
                highest = std::max(highest, *values(level_of_nodes, entries[j].first));
              double &level = next[nodes[k].node];
              level         = std::max(level, highest + 1.);
            }
        for (const auto &[node, level] : next)
          {
            double &known = level_of_nodes.local_element(dim * node);
            changes       = changes || known != level;
            known         = level;
          }
        any_changes = Utilities::MPI::max(static_cast<unsigned int>(changes),
                                          partitioner->get_mpi_communicator());
      }
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        level_of[k] = std::lround(level_of_nodes.local_element(dim * nodes[k].node));
        levels      = std::max(levels, level_of[k]);
      }
    levels = Utilities::MPI::max(levels, partitioner->get_mpi_communicator());
  }


  template <int dim>
  std::vector<unsigned int> NodeCoupling<dim>::owned_partners() const
  {
    std::set<unsigned int> nodes;
    for (const auto &[entry, weight] : entries)
      if (entry < n_owned_entries)
        nodes.insert(entry / dim);
    for (const auto &[begin, end] : partners->import_indices())
      for (unsigned int entry = begin; entry < end; ++entry)
        nodes.insert(entry / dim);
    return std::vector<unsigned int>(nodes.begin(), nodes.end());
  }


  template <int dim>
  std::vector<Tensor<1, dim>> NodeCoupling<dim>::partner_displacement(const Vector &u) const
  {
    std::vector<Tensor<1, dim>> result(row_start.size() - 1);
    if (!has_partners)
      return result;
    fetch(u);
    for (std::size_t k = 0; k < result.size(); ++k)
      for (unsigned int j = row_start[k]; j < row_start[k + 1]; ++j)
        {
          const double *of_partner = values(u, entries[j].first);
          for (unsigned int c = 0; c < dim; ++c)
            result[k][c] += entries[j].second * of_partner[c];
        }
    return result;
  }


  template <int dim>
  std::vector<Tensor<1, dim>> NodeCoupling<dim>::partner_values(const Vector &u) const
  {
    std::vector<Tensor<1, dim>> result;
    if (!has_partners)
      return result;
    fetch(u);
    result.reserve(entries.size());
    for (const auto &[entry, weight] : entries)
      result.emplace_back(make_array_view(values(u, entry), values(u, entry) + dim));
    return result;
  }


  template <int dim>
  void NodeCoupling<dim>::fetch(const Vector &u) const
  {
    std::vector<MPI_Request> requests;
    partners->export_to_ghosted_array_start(0,
                                            ArrayView<const double>(u.begin(), n_owned_entries),
                                            make_array_view(import_storage),
                                            make_array_view(ghost_values),
                                            requests);
    partners->export_to_ghosted_array_finish(make_array_view(ghost_values), requests);
  }


  template <int dim>
  const double *NodeCoupling<dim>::values(const Vector &u, const unsigned int entry) const
  {
    return entry < n_owned_entries ? u.begin() + entry
                                   : ghost_values.data() + (entry - n_owned_entries);
  }


  template <int dim>
  std::vector<double> NodeCoupling<dim>::partner_motion(const Vector &u) const
  {
    const std::vector<Tensor<1, dim>> displacement = partner_displacement(u);
    std::vector<double>               result;
    result.reserve(relative.size());
    for (std::size_t k = 0; k < displacement.size(); ++k)
      for (unsigned int r = relative_start[k]; r < relative_start[k + 1]; ++r)
        result.push_back(directions[r] * displacement[k]);
    return result;
  }


  template <int dim>
  void NodeCoupling<dim>::add_to_partners(const std::vector<double> &forces, Vector &f) const
  {
    scatter(f, [&](const std::size_t k, const double weight, double *sum) {
      for (unsigned int r = relative_start[k]; r < relative_start[k + 1]; ++r)
        for (unsigned int c = 0; c < dim; ++c)
          sum[c] += weight * directions[r][c] * forces[r];
    });
  }


  template <int dim>
  void NodeCoupling<dim>::add_blocks_to_partners(
    const std::vector<std::array<double, dim * dim>> &blocks,
    Vector                                           &d) const
  {
    scatter(d, [&](const std::size_t k, const double weight, double *sum) {
      for (unsigned int r = relative_start[k]; r < relative_start[k + 1]; ++r)
        for (unsigned int s = relative_start[k]; s < relative_start[k + 1]; ++s)
          for (unsigned int c = 0; c < dim; ++c)
            sum[c] += (weight * directions[r][c]) * (weight * directions[s][c])
                      * blocks[k][dim * (relative[r] % dim) + relative[s] % dim];
    });
  }


  template <int dim>
  template <typename Add>
  void NodeCoupling<dim>::scatter(Vector &target, const Add &add) const
  {
    if (!has_partners)
      return;
    std::fill(ghost_values.begin(), ghost_values.end(), 0.);
    for (std::size_t k = 0; k + 1 < row_start.size(); ++k)
      for (unsigned int j = row_start[k]; j < row_start[k + 1]; ++j)
        {
          const auto &[entry, weight] = entries[j];
          add(k,
              weight,
              entry < n_owned_entries ? target.begin() + entry
                                      : ghost_values.data() + (entry - n_owned_entries));
        }
    std::vector<MPI_Request> requests;
    partners->import_from_ghosted_array_start(VectorOperation::add,
                                              0,
                                              make_array_view(ghost_values),
                                              make_array_view(import_storage),
                                              requests);
    partners->import_from_ghosted_array_finish(
      VectorOperation::add,
      ArrayView<const double>(import_storage.data(), import_storage.size()),
      ArrayView<double>(target.begin(), n_owned_entries),
      make_array_view(ghost_values),
      requests);
  }


  template class NodeCoupling<2>;
  template class NodeCoupling<3>;
} // namespace signorini
