// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_free_space_h
#define signorini_multigrid_free_space_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/linear_algebra/masked_preconditioner.h>
#include <signorini/multigrid/level_matrix.h>
#include <signorini/multigrid/node_blocks.h>

namespace signorini
{
  /**
   * The displacements of the finest level, in Cartesian components, that leave held entries of
   * contact coordinates alone: the range of the projection
   *
   *   G = I - sum_e n_e rho_e',    rho_e'u = n_e.(u_p - sum_l P_pl u_l),
   *
   * where n_e is a direction of the node p, and the sum over its partners is there if the entry is
   * relative to another body (RelativeRows). Only what is held is relative: free nodes of two
   * bodies move on their own, as they do apart. Partners that are held themselves come first, level
   * by level.
   */
  template <int dim, typename Number>
  class FreeSpace
  {
  public:
    /** Collective. The coordinates must outlive the object. */
    FreeSpace(const ContactCoordinates<dim> &coordinates, const NodePattern &pattern);

    void set_mask(const Mask &mask);

    /** u = G u. Collective. */
    void project(LevelVector<Number> &displacement) const;

    /** f = G'f. Collective. */
    void project_force(LevelVector<Number> &force) const;

    using Block = typename LevelMatrix<dim, Number>::Block;

    /** A node with held entries or partners of such: what stands for its diagonal block. */
    struct NodeBlock
    {
      unsigned int node;
      Block        inverse;
    };

    /**
     * For the nodes that differ, the inverse of the diagonal block of G'K G on the directions in
     * which the node is free. A partner carries other nodes along: its block is large enough to
     * stand for the couplings among them, too. Collective.
     */
    std::vector<NodeBlock> changed_inverses(const LevelMatrix<dim, Number> &matrix) const;

  private:
    struct Partner
    {
      unsigned int           node;   ///< local: owned, or a ghost
      dealii::Tensor<1, dim> weight; ///< a_l

      Lanes<Number> lanes() const
      {
        Lanes<Number> result{};
        for (unsigned int c = 0; c < dim; ++c)
          result[c] = weight[c];
        return result;
      }
    };
    /** An entry that may be held. */
    struct Entry
    {
      unsigned int           node, component;
      dealii::Tensor<1, dim> direction;
      unsigned int           partners_begin = 0, partners_end = 0;
      unsigned int           level = 0; ///< of a relative entry: see NodeCoupling::level()

      Lanes<Number> lanes() const
      {
        Lanes<Number> result{};
        for (unsigned int c = 0; c < dim; ++c)
          result[c] = direction[c];
        return result;
      }
      Block projector() const
      {
        const Eigen::Matrix<double, dim, 1> n(direction.begin_raw());
        return n * n.transpose();
      }
      bool is_relative() const { return partners_begin != partners_end; }
    };
    std::vector<Entry>           entries;
    std::vector<Partner>         partners;
    bool                         any_partners; ///< of any process
    std::unique_ptr<GhostValues> ghosts;
    unsigned int                 n_levels; ///< of relative entries, on all processes
    std::vector<Entry> absolute, relative; ///< those that are held, relative ones by level
  };
} // namespace signorini

#endif
