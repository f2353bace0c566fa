// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/complete_rows.h>
#include <signorini/discretization/node_owners.h>
#include <signorini/multigrid/algebraic_coarsening.h>
#include <signorini/multigrid/galerkin_product.h>
#include <signorini/multigrid/level_hierarchy.h>

#include <map>
#include <numeric>
#include <utility>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr types::global_dof_index no_node = numbers::invalid_dof_index;

    /** Entries of a level that is small enough for a direct factor. */
    constexpr unsigned int largest_coarse_level = 600;
    /** Part of the nodes that must go for an algebraic level to pay. */
    constexpr double least_progress = 0.7;
    /**
     * Part of the nodes to which affine displacements may be strange: a slender body with one node
     * across has no rotations left, and cannot bend without being stretched.
     */
    constexpr double most_not_affine = 0.05;

    types::global_dof_index first_of_process(const unsigned int n_owned,
                                             const MPI_Comm     communicator)
    {
      types::global_dof_index before = 0;
      const auto              all    = Utilities::MPI::all_gather(communicator, n_owned);
      const auto              rank   = Utilities::MPI::this_mpi_process(communicator);
      for (unsigned int other = 0; other < rank; ++other)
        before += all[other];
      return before;
    }


    template <int dim>
    types::global_dof_index global_node(const NodePattern &pattern, const unsigned int node)
    {
      return pattern.partitioner->local_to_global(dim * node) / dim;
    }


    /** Flags of owned nodes, and of those that are coupled with them. Collective. */
    template <int dim>
    std::vector<char> with_neighbours(const NodePattern &pattern, const std::vector<char> &flags)
    {
      Vector values(pattern.partitioner);
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        values.local_element(dim * node) = flags[node];
      values.update_ghost_values();
      const auto is_set = [&](const unsigned int node) {
        return values.local_element(dim * node) != 0.;
      };
      std::vector<char> result = flags;
      for (unsigned int row = 0; row < pattern.n_owned; ++row)
        for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
          {
            const unsigned int column = pattern.columns[k];
            if (is_set(column))
              result[row] = 1;
            if (is_set(row) && column < pattern.n_owned)
              result[column] = 1;
          }
      return result;
    }


    /** Clamped nodes are no parents, and have none. */
    void take_out_clamped(const std::vector<char> &is_clamped, Coarsening &coarsening)
    {
      std::vector<unsigned int>            kept;
      std::map<unsigned int, unsigned int> place; // by the place before
      for (std::size_t k = 0; k < coarsening.kept.size(); ++k)
        if (!is_clamped[coarsening.kept[k]])
          {
            place[k] = kept.size();
            kept.push_back(coarsening.kept[k]);
          }
      coarsening.kept = std::move(kept);
      for (std::size_t node = 0; node < coarsening.parents.size(); ++node)
        {
          const auto before = std::exchange(coarsening.parents[node], {});
          for (const auto &[parent, weight] : before)
            if (const auto found = place.find(parent); found != place.end() && !is_clamped[node])
              coarsening.parents[node].emplace_back(found->second, weight);
        }
    }
  } // namespace


  template <int dim>
  LevelHierarchy<dim>::LevelHierarchy(const Discretization<dim>       &discretization,
                                      const std::vector<unsigned int> &clamped_nodes)
    : finest(&discretization.matrices())
    , clamped(clamped_nodes)
    , is_clamped(finest->pattern.n_owned, 0)
  {
    for (const unsigned int node : clamped)
      is_clamped[node] = 1;
    const std::vector<NodeOrigin> origins = node_origins(discretization);
    unsigned int                  top     = 0;
    for (const NodeOrigin &origin : origins)
      top = std::max(top, origin.level);
    top                     = Utilities::MPI::max(top, discretization.communicator());
    unsigned int n_coarsest = 0;
    for (std::size_t node = 0; node < origins.size(); ++node)
      n_coarsest +=
        origins[node].level == 0 && !finest->pattern.is_empty(node) && !is_clamped[node];
    if (Utilities::MPI::sum(n_coarsest, discretization.communicator()) == 0)
      forget_clamped();
    std::vector<unsigned int> nodes(origins.size()); // of the level, by number in the finest
    std::iota(nodes.begin(), nodes.end(), 0);
    for (unsigned int level = top; level > 0; --level)
      add_level_of_mesh(discretization, origins, level, nodes);
    while (coarse.empty() || matrices(0).pattern.partitioner->size() > largest_coarse_level)
      if (!add_algebraic_level(discretization, nodes))
        break;
  }


  template <int dim>
  void LevelHierarchy<dim>::forget_clamped()
  {
    clamped.clear();
    is_clamped.assign(is_clamped.size(), 0);
  }


  template <int dim>
  void LevelHierarchy<dim>::add_level_of_mesh(const Discretization<dim>     &discretization,
                                              const std::vector<NodeOrigin> &origins,
                                              const unsigned int             level,
                                              std::vector<unsigned int>     &nodes)
  {
    const MPI_Comm                       communicator = discretization.communicator();
    const NodePattern                   &finest_nodes = finest->pattern;
    std::vector<unsigned int>            kept;
    std::vector<types::global_dof_index> number(origins.size(), no_node);
    for (const unsigned int node : nodes)
      if (origins[node].level < level && !finest_nodes.is_empty(node) && !is_clamped[node])
        kept.push_back(node);
    const auto first_coarse = first_of_process(kept.size(), communicator);
    for (std::size_t k = 0; k < kept.size(); ++k)
      number[kept[k]] = first_coarse + k;

    // Parents by their numbers in the coarse level.
    std::vector<types::global_dof_index> asked;
    for (const unsigned int node : nodes)
      if (origins[node].level == level)
        for (const auto &[parent, weight] : origins[node].parents)
          asked.push_back(parent);
    const auto first = origins.empty() ? 0 : global_node<dim>(finest_nodes, 0);
    const auto numbers_of_parents =
      NodeOwners(origins.size(), communicator).ask(asked, [&](const auto node) {
        return number[node - first];
      });
    std::vector<std::vector<WeightedNode>> parents(nodes.size());
    std::vector<char>                      is_new(nodes.size());
    auto                                   next = numbers_of_parents.begin();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        is_new[k] = origins[nodes[k]].level == level;
        if (is_new[k])
          for (const auto &[parent, weight] : origins[nodes[k]].parents)
            {
              const auto number_of_parent = *next++;
              if (number_of_parent != no_node && !is_clamped[nodes[k]])
                parents[k].emplace_back(number_of_parent, weight);
            }
        else if (number[nodes[k]] != no_node)
          parents[k].emplace_back(number[nodes[k]], 1.);
      }
    add_level(
      std::move(parents), is_new, {first_coarse, static_cast<unsigned int>(kept.size()), {}});
    nodes = std::move(kept);
  }


  template <int dim>
  bool LevelHierarchy<dim>::add_algebraic_level(const Discretization<dim> &discretization,
                                                std::vector<unsigned int> &nodes)
  {
    const MPI_Comm          communicator = discretization.communicator();
    std::vector<Point<dim>> positions;
    for (const unsigned int node : nodes)
      positions.push_back(discretization.node_positions()[node]);
    Coarsening coarsening = coarsen(matrices(0), positions);
    if (coarse.empty())
      {
        const Coarsening with_clamped = coarsening;
        take_out_clamped(is_clamped, coarsening);
        if (Utilities::MPI::sum(static_cast<unsigned int>(coarsening.kept.size()), communicator)
            == 0)
          {
            forget_clamped();
            coarsening = with_clamped;
          }
      }
    const auto n_before = matrices(0).pattern.partitioner->size() / dim,
               n_after =
                 Utilities::MPI::sum(types::global_dof_index(coarsening.kept.size()), communicator);
    const auto n_not_affine = Utilities::MPI::sum(coarsening.n_not_affine, communicator);
    if (!coarse.empty()
        && (n_after > least_progress * n_before || n_not_affine > most_not_affine * n_before))
      return false;
    const auto first_coarse = first_of_process(coarsening.kept.size(), communicator);
    std::vector<std::vector<WeightedNode>> parents(nodes.size());
    std::vector<char>                      is_new(nodes.size(), 1);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (const auto &[parent, weight] : coarsening.parents[k])
        parents[k].emplace_back(first_coarse + parent, weight);
    std::vector<unsigned int> kept;
    for (const unsigned int k : coarsening.kept)
      {
        is_new[k] = 0;
        kept.push_back(nodes[k]);
      }
    add_level(
      std::move(parents), is_new, {first_coarse, static_cast<unsigned int>(kept.size()), {}});
    nodes = std::move(kept);
    return true;
  }


  template <int dim>
  void LevelHierarchy<dim>::add_level(std::vector<std::vector<WeightedNode>> parents,
                                      const std::vector<char>               &is_new,
                                      const LocalNodes                      &coarse_nodes)
  {
    const ElasticMatrices<dim> &fine         = matrices(0);
    const MPI_Comm              communicator = fine.pattern.partitioner->get_mpi_communicator();
    // Those of ghosts from their owners.
    std::vector<types::global_dof_index> ghosts;
    for (unsigned int node = fine.pattern.n_owned; node < fine.pattern.n_local; ++node)
      ghosts.push_back(global_node<dim>(fine.pattern, node));
    const auto first_fine = parents.empty() ? 0 : global_node<dim>(fine.pattern, 0);
    for (auto &of_ghost :
         NodeOwners(fine.pattern.n_owned, communicator).ask(ghosts, [&](const auto node) {
           return parents[node - first_fine];
         }))
      parents.push_back(std::move(of_ghost));

    Interpolation interpolation(parents, coarse_nodes);
    GhostValues   ghosts_of_transfer(interpolation.coarse(), communicator);
    auto          product = galerkin_product(fine, interpolation, communicator);
    coarse.push_front({std::move(interpolation),
                       std::move(product),
                       with_neighbours<dim>(fine.pattern, is_new),
                       std::move(ghosts_of_transfer)});
  }


  template <int dim>
  std::vector<std::vector<WeightedNode>>
  LevelHierarchy<dim>::parents(const unsigned int                          level,
                               const std::vector<types::global_dof_index> &nodes) const
  {
    const NodePattern   &pattern     = matrices(level).pattern;
    const Interpolation &to_parents  = coarse[level - 1].interpolation;
    const auto           of_own_node = [&](const types::global_dof_index node) {
      std::vector<WeightedNode> result;
      for (const auto &part :
           to_parents.parts(pattern.partitioner->global_to_local(dim * node) / dim))
        result.emplace_back(to_parents.coarse().global(part.node), part.weight);
      return result;
    };
    const MPI_Comm communicator = pattern.partitioner->get_mpi_communicator();
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      return NodeOwners(pattern.n_owned, communicator).ask(nodes, of_own_node);
    std::vector<std::vector<WeightedNode>> result;
    result.reserve(nodes.size());
    for (const types::global_dof_index node : nodes)
      result.push_back(of_own_node(node));
    return result;
  }


  template <int dim>
  template <typename Number>
  void LevelHierarchy<dim>::prolongate(const unsigned int         level,
                                       const LevelVector<Number> &coarse_vector,
                                       LevelVector<Number>       &fine) const
  {
    const Level &below = coarse[level - 1];
    below.ghosts.fetch(coarse_vector);
    for (unsigned int node = 0; node < matrices(level).pattern.n_owned; ++node)
      {
        Lanes<Number> sum{};
        for (const auto &part : below.interpolation.parts(node))
          sum += static_cast<Number>(part.weight) * below.ghosts.value(coarse_vector, part.node);
        set_value(fine, node, sum);
      }
  }


  template <int dim>
  template <typename Number>
  void LevelHierarchy<dim>::restrict_to_coarser(const unsigned int         level,
                                                const LevelVector<Number> &fine,
                                                LevelVector<Number>       &coarse_vector) const
  {
    const Level &below = coarse[level - 1];
    coarse_vector.fill(Number(0));
    below.ghosts.template clear<Number>();
    for (unsigned int node = 0; node < matrices(level).pattern.n_owned; ++node)
      {
        const Lanes<Number> force = value(fine, node);
        for (const auto &part : below.interpolation.parts(node))
          below.ghosts.add(coarse_vector, part.node, static_cast<Number>(part.weight) * force);
      }
    below.ghosts.add_to_owners(coarse_vector);
  }


#define INSTANTIATE(dim, Number)                                                                   \
  template void LevelHierarchy<dim>::prolongate(                                                   \
    unsigned int, const LevelVector<Number> &, LevelVector<Number> &) const;                       \
  template void LevelHierarchy<dim>::restrict_to_coarser(                                          \
    unsigned int, const LevelVector<Number> &, LevelVector<Number> &) const;
  template class LevelHierarchy<2>;
  template class LevelHierarchy<3>;
  INSTANTIATE(2, float)
  INSTANTIATE(2, double)
  INSTANTIATE(3, float)
  INSTANTIATE(3, double)
#undef INSTANTIATE
} // namespace signorini
