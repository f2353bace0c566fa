// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_level_vector_h
#define signorini_multigrid_level_vector_h

#include <signorini/discretization/local_nodes.h>
#include <signorini/linear_algebra/lanes.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/partitioner.h>

#include <memory>
#include <tuple>
#include <vector>

namespace signorini
{
  /**
   * Displacements or forces of the owned nodes of a level: four numbers per node (see Lanes). The
   * spare ones of displacements are zero; what forces have there is never used.
   */
  template <typename Number>
  using LevelVector = dealii::AlignedVector<Number>;

  template <typename Number>
  inline Lanes<Number> value(const LevelVector<Number> &vector, const unsigned int node)
  {
    return load(vector.data() + 4 * node);
  }

  /** @param value Lanes<Number> */
  template <typename Number, typename Four>
  inline void set_value(LevelVector<Number> &vector, const unsigned int node, const Four value)
  {
    std::memcpy(vector.data() + 4 * node, &value, sizeof(value));
  }

  /** The values of nodes that other processes own, side by side with those of owned ones. */
  class GhostValues
  {
  public:
    /** Collective. */
    GhostValues(const LocalNodes &nodes, MPI_Comm communicator);

    /** Get the values of ghosts from their owners. Collective. */
    template <typename Number>
    void fetch(const LevelVector<Number> &vector) const;

    /** Set the values of ghosts to zero. */
    template <typename Number>
    void clear() const
    {
      buffer<Number>().values.fill(Number(0));
    }

    /** Add the values of ghosts to those of their owners. Collective. */
    template <typename Number>
    void add_to_owners(LevelVector<Number> &vector) const;

    /** @param node local: owned, or a ghost */
    template <typename Number>
    Lanes<Number> value(const LevelVector<Number> &vector, const unsigned int node) const
    {
      return load(node < n_owned ? vector.data() + 4 * node
                                 : buffer<Number>().values.data() + 4 * (node - n_owned));
    }

    /** @param increment Lanes<Number> */
    template <typename Number, typename Four>
    void add(LevelVector<Number> &vector, const unsigned int node, const Four increment) const
    {
      Number *const       place   = node < n_owned ? vector.data() : buffer<Number>().values.data();
      Number *const       of_node = place + 4 * (node < n_owned ? node : node - n_owned);
      const Lanes<Number> sum     = load(of_node) + increment;
      std::memcpy(of_node, &sum, sizeof(sum));
    }

    /** Flags of owned nodes, and behind them those of ghosts. Collective. */
    std::vector<char> with_ghosts(const std::vector<char> &flags) const;

    unsigned int n_owned_nodes() const { return n_owned; }
    bool         is_alone() const { return alone; }
    MPI_Comm     communicator() const { return partitioner->get_mpi_communicator(); }

  private:
    unsigned int                                               n_owned;
    bool                                                       alone; ///< the only process
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;

    /** Made when it is needed. */
    template <typename Number>
    struct Buffer
    {
      dealii::AlignedVector<Number> values, storage;
    };
    mutable std::tuple<Buffer<float>, Buffer<double>> buffers;

    template <typename Number>
    Buffer<Number> &buffer() const
    {
      auto &result = std::get<Buffer<Number>>(buffers);
      if (result.values.size() != partitioner->n_ghost_indices())
        result.values.resize(partitioner->n_ghost_indices());
      return result;
    }
  };
} // namespace signorini

#endif
