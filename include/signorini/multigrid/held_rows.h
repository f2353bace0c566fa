// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_held_rows_h
#define signorini_multigrid_held_rows_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/discretization/node_owners.h>
#include <signorini/linear_algebra/masked_preconditioner.h>
#include <signorini/multigrid/relative_rows.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <unordered_map>

namespace signorini
{
  /**
   * For entries of contact coordinates that are held: the direction n_e, the row rho_e that
   * measures the entry (of its node, and of its partners as far as they are not prescribed), and
   * the forces K n_e, all by global nodes. Made when an entry of an owned node or a ghost is held
   * for the first time. Clamped nodes are left out: no coarser level moves them (LevelHierarchy).
   */
  template <int dim>
  class HeldRows
  {
  public:
    using Node   = dealii::types::global_dof_index;
    using Tensor = dealii::Tensor<1, dim>;

    struct Part
    {
      Node   node;
      Tensor value;
    };
    using Row = std::vector<Part>;

    /** Collective. All must outlive the object. @param clamped owned nodes that are left out */
    HeldRows(const ElasticMatrices<dim>      &matrices,
             const ContactCoordinates<dim>   &coordinates,
             const MatrixSum                 &sum,
             const std::vector<unsigned int> &clamped);

    /** Take note of what is held. Collective. @return the numbers of entries that are new */
    std::vector<unsigned int> set_mask(Mask mask);

    unsigned int size() const { return entries.size(); }

    /** The entries that are held and owned, by number. */
    const std::vector<unsigned int> &owned_held() const { return owned; }

    const Row &measure(const unsigned int number) const { return entries[number].measure; }
    /** K n_e; empty if the node is a ghost. */
    const Row &forces(const unsigned int number) const { return entries[number].forces; }

    struct Coupling
    {
      unsigned int other; ///< number
      double       value; ///< n_e'K n_f

      bool operator==(const Coupling &as) const { return other == as.other && value == as.value; }
    };
    /** Of an owned entry with those that are held. */
    std::vector<Coupling> couplings(unsigned int number) const;

  private:
    struct Entry
    {
      Tensor direction;
      Row    measure, forces;
      bool   is_held = false;
    };
    /** What the owner of a node tells others: by entry of the node. */
    struct Knowledge
    {
      std::vector<std::array<double, dim>>                               directions;
      std::vector<std::vector<std::pair<Node, std::array<double, dim>>>> measures;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &directions &measures;
      }
    };
    const ElasticMatrices<dim>      &matrices;
    const ContactCoordinates<dim>   &coordinates;
    const MatrixSum                  sum;
    const RelativeRows<dim>          relative_rows;
    const std::vector<unsigned int> &clamped;
    NodeOwners                       owner;
    mutable Vector                   mask_values;
    std::vector<Entry>               entries;
    std::vector<unsigned int>        owned;
    /** The prescribed directions of partners. */
    std::map<Node, std::vector<std::array<double, dim>>> prescribed_of_partners;
    /** Numbers of the entries of a local node; unknown ones are invalid. */
    std::unordered_map<unsigned int, std::array<unsigned int, dim>> numbers;
    std::unordered_map<Node, unsigned int>                          local_of_known;
    /** Couplings with owned nodes in which a contact node is the column of the upper triangle. */
    struct Transposed
    {
      unsigned int row, position;
    };
    std::unordered_map<unsigned int, std::vector<Transposed>> transposed;

    Node   global(const unsigned int local) const;
    Tensor direction_of(unsigned int node, unsigned int component) const;
    void   ask_for_prescribed_directions();
    /** Get to know the entries of ghosts that are held. Collective. */
    void ask_for_ghosts();
    void find_transposed();
    Row  measure_of(unsigned int node, unsigned int component) const;
    Row  forces_of(unsigned int node, const Tensor &direction) const;
    void add(unsigned int node, unsigned int component, Entry entry);
  };
} // namespace signorini

#endif
