// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_held_correction_h
#define signorini_multigrid_held_correction_h

#include <signorini/linear_algebra/masked_preconditioner.h>
#include <signorini/multigrid/held_rows.h>
#include <signorini/multigrid/level_hierarchy.h>
#include <signorini/multigrid/node_blocks.h>

namespace signorini
{
  /**
   * What held entries change in the matrices of the coarser levels. The finest level moves in the
   * range of G = I - sum_e n_e rho_e' (see FreeSpace), so that on every coarser level
   *
   *   P'(G'K G - K) P = sum_e r_e s_e' + s_e r_e',   r_e = P'rho_e,
   *   s_e = -P'K n_e + 1/2 sum_f (n_e'K n_f) r_f.
   *
   * A few numbers for each held entry tell all of it; they are computed when an entry is held for
   * the first time, and holding another set of entries costs next to nothing.
   */
  template <int dim, typename Number>
  class HeldCorrection
  {
  public:
    /** Collective. The hierarchy must outlive the object. @param scale see LevelMatrix */
    HeldCorrection(const LevelHierarchy<dim>     &hierarchy,
                   const ContactCoordinates<dim> &coordinates,
                   const MatrixSum               &sum,
                   double                         scale);

    /** Hold the entries of a mask. Collective. */
    void set_mask(const Mask &mask);

    /** y -= the change times x, on a coarser level. Collective. */
    void subtract_product(unsigned int               level,
                          const LevelVector<Number> &x,
                          LevelVector<Number>       &y) const;

    /** The change of the diagonal blocks of owned nodes. Collective. */
    NodeBlocks<dim> diagonal_changes(unsigned int level) const;

    /** A part of a vector of the whole level: a node on all processes, and its components. */
    using Part = typename HeldRows<dim>::Part;

    double matrix_scale() const { return scale; }

    /** Whether nodes of one body carry those of another along, on any process. */
    bool has_partners() const { return any_partners; }

    /** Call action(r_e, s_e), without that scale, rows of such parts, for the held entries of this
     * process. */
    template <typename Action>
    void for_each_held(const unsigned int level, const Action &action) const
    {
      for (std::size_t e = 0; e < held.size(); ++e)
        action(levels[level].measures[held[e]], levels[level].sums[held[e]]);
    }

  private:
    using Row = typename HeldRows<dim>::Row;

    /** A row by local numbers, for products. */
    struct LocalPart
    {
      unsigned int  node;
      Lanes<Number> value;
    };
    struct Level
    {
      std::vector<Row>             measures; ///< r_e of all that is known
      std::vector<Row>             forces;   ///< P'K n_e
      std::vector<Row>             sums;     ///< s_e of all that is known, when it was last held
      std::vector<LocalPart>       parts;    ///< r_e, then s_e, of each held entry in turn
      std::vector<unsigned int>    starts;
      LocalNodes                   nodes;
      std::unique_ptr<GhostValues> ghosts;
    };
    const LevelHierarchy<dim> &hierarchy;
    const double               scale;
    const bool                 any_partners;
    HeldRows<dim>              rows;   ///< of the finest level
    std::vector<Level>         levels; ///< all but the finest
    std::vector<unsigned int>  held;   ///< owned entries, by number in the rows
    std::vector<std::vector<typename HeldRows<dim>::Coupling>>
      couplings; ///< with which the sums were made

    void             add_rows(const std::vector<unsigned int> &numbers);
    std::vector<Row> coarsened(unsigned int level, const std::vector<Row> &rows) const;
    /** Of those entries that are held together with other ones than before. */
    void sum_up();
    void localise(unsigned int level);
  };
} // namespace signorini

#endif
