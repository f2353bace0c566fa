// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_sweeps_special_positions_h
#define signorini_sweeps_special_positions_h

#include <signorini/linear_algebra/lanes.h>
#include <signorini/linear_algebra/node_masks.h>
#include <signorini/linear_algebra/slip_rows.h>
#include <signorini/sweeps/sweep_exchange.h>
#include <signorini/sweeps/unit_diagonal_matrix.h>

namespace signorini
{
  /**
   * What sweeps (NodeSweeps) do differently at nodes that are held or slip. Held directions are
   * projected out. What slip adds to the rows is E; the part of it that may be large, a slip that
   * is about to turn, is taken into the diagonal: the coordinates of such a node are scaled by S =
   * (I + sym Q)^(-1/2).
   */
  template <int dim, int block_size>
  class SpecialPositions
  {
  public:
    /** @param matrix must outlive the object */
    explicit SpecialPositions(const UnitDiagonalMatrix<dim, block_size> &matrix);

    /** Nothing slips from now on. */
    void set_held_nodes(const HeldNodes<dim> &held);
    /** After set_held_nodes(). Collective. */
    void set_slip(const std::vector<NodeSlip<dim>> &slipping);
    /** On any process. */
    bool any_slip() const { return slips; }

    bool contain(const unsigned int position) const { return is_special[position]; }

    /** p = S p. */
    void scale(std::vector<float> &p) const;
    /** @return t of the position, in the scale of K. @param sum of L't of its row */
    Lanes<float> back(unsigned int position, Lanes<float> of_p, Lanes<float> sum);
    /** After a sweep back: what slipping nodes need of t on other processes. Collective. */
    void fetch(SweepExchange &exchange, const std::vector<float> &t);
    /** As after a sweep back that gave t = 0. */
    void clear();
    /**
     * @param sum  minus (L y) of its row
     * @param of_t on entry in the scale of K, on exit in that of the position, as y is
     * @return y in the scale of K
     */
    Lanes<float> forth(unsigned int              position,
                       Lanes<float>              of_p,
                       Lanes<float>              sum,
                       const std::vector<float> &t,
                       Lanes<float>             &of_t,
                       Lanes<float>             &of_y);
    /** After a sweep forth: t and y in the scales of the positions. */
    void finish(std::vector<float> &t, std::vector<float> &y) const;

  private:
    using Numbers = std::array<float, dim * dim>;

    struct Special
    {
      unsigned int                                position;
      int                                         slip;      ///< its place below; negative: none
      Numbers                                     projector; ///< onto its free directions
      [[maybe_unused]] std::array<float, 4 - dim> spare;     ///< see Lanes

      Lanes<float> free_part(const Lanes<float> lanes) const
      {
        return without_spare_lanes<dim, float>(block_product<dim, float>(projector.data(), lanes));
      }
    };
    struct Slip
    {
      unsigned int position;
      Numbers      scaling;          ///< S
      Numbers      turning;          ///< S (Q + I - S^-2)
      Lanes<float> coupling, normal; ///< S C^-1 q and C'n, but for a common scale
      Lanes<float> t, y;             ///< in the scaled coordinates
      Lanes<float> upper;            ///< (L't) of the row
      Lanes<float> lower_ghosts;     ///< the part of (L t) from other processes
    };

    const UnitDiagonalMatrix<dim, block_size> &matrix;
    std::vector<char>                          is_special;
    std::vector<Special>                       specials; ///< by position
    std::vector<Slip>                          slipping;
    bool                                       slips = false;

    Special               &special(unsigned int position);
    dealii::Tensor<2, dim> inverse_root(unsigned int position) const; ///< C^-1
  };
} // namespace signorini

#endif
