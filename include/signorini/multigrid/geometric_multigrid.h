// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_geometric_multigrid_h
#define signorini_multigrid_geometric_multigrid_h

#include <signorini/multigrid/coarse_factor.h>
#include <signorini/multigrid/level_smoother.h>

namespace signorini
{
  /**
   * A V-cycle over the levels of the mesh for a M + b A in contact coordinates, in single or double
   * precision. It works in Cartesian components, in the space of what leaves held entries alone:
   * the finest level smooths in it, the transfer to the next one leaves out what is held, and the
   * matrices of the coarser levels are those of this transfer. Where held directions have turned by
   * more than a little since they were asked for, they are asked for anew.
   */
  template <int dim, typename Number>
  class GeometricMultigrid : public MaskedPreconditioner
  {
  public:
    /** Collective. The coordinates must outlive the object. */
    GeometricMultigrid(std::shared_ptr<const LevelHierarchy<dim>> levels_of_mesh,
                       const ContactCoordinates<dim>             &coordinates,
                       const MatrixSum                           &sum);

    void set_mask(const Mask &mask) override;
    void vmult(Vector &destination, const Vector &source) const override;

  private:
    const std::shared_ptr<const LevelHierarchy<dim>> shared_hierarchy;
    const LevelHierarchy<dim>                       &hierarchy;
    const ContactCoordinates<dim>                   &coordinates;
    const double                                     scale;
    const MatrixSum                                  sum;
    std::unique_ptr<HeldCorrection<dim, Number>>     correction;
    FreeSpace<dim, Number>                           free_space;
    CoarseFactor<dim>                                coarsest;
    Mask                                             mask;
    std::map<unsigned int, typename NodeFrames<dim>::Frame>
                                  known_frames; ///< of correction and space
    std::vector<ContactNode<dim>> known_nodes;  ///< where partners come and go
    mutable Vector                cartesian;

    struct Level
    {
      LevelMatrix<dim, Number>                    matrix;
      std::unique_ptr<LevelSmoother<dim, Number>> smoother; ///< none on level 0
      LevelVector<Number>                         residual, solution, coarse_correction;
    };
    mutable std::vector<Level> levels;

    /** Whether what a mask holds has other directions than those that are known. Collective. */
    bool have_turned(const Mask &mask) const;
    /** Whether a contact node that a mask holds has other partners than those that are known. */
    bool has_other_partners(std::size_t contact_node, const Mask &mask) const;
    /** Where a level smooths: 1 for each such owned node. */
    std::vector<char> smoothed(unsigned int level) const;
    /** solution of the level = what the cycle makes of its residual. */
    void cycle(unsigned int level) const;
    bool is_finest(const unsigned int level) const { return level + 1 == hierarchy.n_levels(); }
    void keep_free(Vector &vector) const;
  };

  /**
   * The cycle in the precision that it needs: single is twice as fast, and enough unless motions
   * with next to no energy have to be told from none (static problems of slender or free bodies).
   * Collective.
   */
  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_geometric_multigrid(std::shared_ptr<const LevelHierarchy<dim>> hierarchy,
                           const ContactCoordinates<dim>             &coordinates,
                           const MatrixSum                           &sum,
                           bool                                       in_double_precision);
} // namespace signorini

#endif
