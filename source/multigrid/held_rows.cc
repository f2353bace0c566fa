// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/held_rows.h>
#include <signorini/surfaces/contact_frame.h>

namespace signorini
{
  namespace
  {
    constexpr unsigned int unknown = dealii::numbers::invalid_unsigned_int;

    template <int dim>
    std::array<double, dim> as_array(const dealii::Tensor<1, dim> &tensor)
    {
      std::array<double, dim> values;
      for (unsigned int c = 0; c < dim; ++c)
        values[c] = tensor[c];
      return values;
    }

    template <std::size_t dim>
    dealii::Tensor<1, dim> as_tensor(const std::array<double, dim> &values)
    {
      dealii::Tensor<1, dim> tensor;
      for (unsigned int c = 0; c < dim; ++c)
        tensor[c] = values[c];
      return tensor;
    }
  } // namespace


  template <int dim>
  HeldRows<dim>::HeldRows(const ElasticMatrices<dim>      &matrices,
                          const ContactCoordinates<dim>   &coordinates,
                          const MatrixSum                 &sum,
                          const std::vector<unsigned int> &clamped)
    : matrices(matrices)
    , coordinates(coordinates)
    , sum(sum)
    , relative_rows(coordinates)
    , clamped(clamped)
    , owner(matrices.pattern.n_owned, matrices.pattern.partitioner->get_mpi_communicator())
    , mask_values(matrices.pattern.partitioner)
  {
    if (coordinates.coupling().any())
      ask_for_prescribed_directions();
    find_transposed();
  }


  template <int dim>
  void HeldRows<dim>::ask_for_prescribed_directions()
  {
    std::vector<Node> partners;
    for (const ContactNode<dim> &node : coordinates.surface_nodes())
      for (const auto &[partner, weight] : node.partners)
        partners.push_back(partner);
    std::sort(partners.begin(), partners.end());
    partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
    std::map<Node, std::vector<std::array<double, dim>>> prescribed;
    for (const unsigned int entry : coordinates.dirichlet_entries())
      prescribed[global(entry / dim)].push_back(
        as_array<dim>(direction_of(entry / dim, entry % dim)));
    const auto answers = owner.ask(partners, [&](const Node node) {
      const auto found = prescribed.find(node);
      return found == prescribed.end() ? std::vector<std::array<double, dim>>() : found->second;
    });
    for (std::size_t k = 0; k < partners.size(); ++k)
      if (!answers[k].empty())
        prescribed_of_partners[partners[k]] = answers[k];
  }


  template <int dim>
  void HeldRows<dim>::find_transposed()
  {
    const NodePattern &pattern = matrices.pattern;
    std::vector<char>  may_be_held(pattern.n_local, 0);
    for (const auto &[node, frame] : coordinates.node_frames())
      may_be_held[node] = 1;
    for (unsigned int row = 0; row < pattern.n_owned; ++row)
      for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
        if (const unsigned int column = pattern.columns[k]; may_be_held[column] && column != row)
          transposed[column].push_back({row, k});
  }


  template <int dim>
  std::vector<unsigned int> HeldRows<dim>::set_mask(Mask mask)
  {
    for (const unsigned int node : clamped)
      std::fill_n(mask.begin() + dim * node, dim, 0);
    mask_values.zero_out_ghost_values();
    for (unsigned int i = 0; i < mask.size(); ++i)
      mask_values.local_element(i) = mask[i];
    mask_values.update_ghost_values();

    const unsigned int n_known = entries.size();
    for (const auto &[node, frame] : coordinates.node_frames())
      for (unsigned int c = 0; c < dim; ++c)
        if (mask[dim * node + c] && (numbers.count(node) == 0 || numbers[node][c] == unknown))
          {
            const Tensor direction = direction_of(node, c);
            add(node, c, {direction, measure_of(node, c), forces_of(node, direction)});
          }

    ask_for_ghosts();

    owned.clear();
    for (const auto &[node, of_node] : numbers)
      for (unsigned int c = 0; c < dim; ++c)
        if (of_node[c] != unknown)
          {
            entries[of_node[c]].is_held = mask_values.local_element(dim * node + c) != 0.;
            if (entries[of_node[c]].is_held && node < matrices.pattern.n_owned)
              owned.push_back(of_node[c]);
          }
    std::sort(owned.begin(), owned.end());
    std::vector<unsigned int> result(entries.size() - n_known);
    std::iota(result.begin(), result.end(), n_known);
    return result;
  }


  template <int dim>
  void HeldRows<dim>::ask_for_ghosts()
  {
    const NodePattern        &pattern = matrices.pattern;
    std::vector<unsigned int> new_ghosts;
    std::vector<Node>         asked;
    for (unsigned int node = pattern.n_owned; node < pattern.n_local; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (mask_values.local_element(dim * node + c) != 0.
            && (numbers.count(node) == 0 || numbers[node][c] == unknown))
          {
            new_ghosts.push_back(node);
            asked.push_back(global(node));
            break;
          }
    const auto answers = owner.ask(asked, [&](const Node name) {
      const unsigned int node = pattern.partitioner->global_to_local(dim * name) / dim;
      Knowledge          answer;
      for (unsigned int c = 0; c < dim; ++c)
        {
          answer.directions.push_back(as_array<dim>(direction_of(node, c)));
          answer.measures.emplace_back();
          for (const Part &part : measure_of(node, c))
            answer.measures.back().emplace_back(part.node, as_array<dim>(part.value));
        }
      return answer;
    });
    for (std::size_t k = 0; k < asked.size(); ++k)
      for (unsigned int c = 0; c < dim; ++c)
        if (numbers.count(new_ghosts[k]) == 0 || numbers[new_ghosts[k]][c] == unknown)
          {
            Entry entry;
            entry.direction = as_tensor<dim>(answers[k].directions[c]);
            for (const auto &[node, value] : answers[k].measures[c])
              entry.measure.push_back({node, as_tensor<dim>(value)});
            add(new_ghosts[k], c, std::move(entry));
          }
  }


  template <int dim>
  std::vector<typename HeldRows<dim>::Coupling>
  HeldRows<dim>::couplings(const unsigned int number) const
  {
    std::vector<Coupling> result;
    for (const Part &part : entries[number].forces)
      {
        const auto local = local_of_known.find(part.node);
        if (local == local_of_known.end())
          continue;
        for (const unsigned int other : numbers.at(local->second))
          if (other != unknown && entries[other].is_held)
            result.push_back({other, part.value * entries[other].direction});
      }
    return result;
  }


  template <int dim>
  dealii::types::global_dof_index HeldRows<dim>::global(const unsigned int local) const
  {
    return matrices.pattern.partitioner->local_to_global(dim * local) / dim;
  }


  template <int dim>
  dealii::Tensor<1, dim> HeldRows<dim>::direction_of(const unsigned int node,
                                                     const unsigned int component) const
  {
    const auto frame = orthonormal_frame<dim>(coordinates.node_frames().at(node));
    Tensor     result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = frame[dim * component + d];
    return result;
  }


  template <int dim>
  typename HeldRows<dim>::Row HeldRows<dim>::measure_of(const unsigned int node,
                                                        const unsigned int component) const
  {
    const Tensor direction = direction_of(node, component);
    Row          result    = {{global(node), direction}};
    for (const auto &[partner, weight] : relative_rows.row(node, component))
      {
        Tensor     moved = weight;
        const auto fixed = prescribed_of_partners.find(partner);
        if (fixed != prescribed_of_partners.end())
          for (const auto &values : fixed->second)
            {
              const Tensor prescribed = as_tensor<dim>(values);
              moved -= (prescribed * weight) * prescribed;
            }
        if (moved.norm_square() > 0.)
          result.push_back({partner, -1. * moved});
      }
    return result;
  }


  template <int dim>
  typename HeldRows<dim>::Row HeldRows<dim>::forces_of(const unsigned int node,
                                                       const Tensor      &direction) const
  {
    const NodePattern &pattern = matrices.pattern;
    Row                result;
    for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
      {
        const auto block = matrices.combined_block(node, k, sum);
        Tensor     force;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            force[j] += block[dim * j + i] * direction[i];
        result.push_back({global(pattern.columns[k]), force});
      }
    if (const auto found = transposed.find(node); found != transposed.end())
      for (const Transposed &entry : found->second)
        {
          const auto block = matrices.combined_block(entry.row, entry.position, sum);
          Tensor     force;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              force[i] += block[dim * j + i] * direction[j];
          result.push_back({global(entry.row), force});
        }
    return result;
  }


  template <int dim>
  void HeldRows<dim>::add(const unsigned int node, const unsigned int component, Entry entry)
  {
    if (numbers.count(node) == 0)
      {
        numbers[node].fill(unknown);
        local_of_known[global(node)] = node;
      }
    numbers[node][component] = entries.size();
    entries.push_back(std::move(entry));
  }


  template class HeldRows<2>;
  template class HeldRows<3>;
} // namespace signorini
