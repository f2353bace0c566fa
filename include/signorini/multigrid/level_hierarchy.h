// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_level_hierarchy_h
#define signorini_multigrid_level_hierarchy_h

#include <signorini/discretization/discretization.h>
#include <signorini/multigrid/interpolation.h>
#include <signorini/multigrid/level_vector.h>

#include <deque>

namespace signorini
{
  /**
   * The levels of the mesh, each with the matrices of all step sizes: those of the finest are the
   * discretisation's, those of the others Galerkin products. Where the coarse mesh is too large for
   * a direct factor, levels go on below it by their couplings. Built once for a mesh and its mass.
   *
   * Nodes of which all entries are prescribed are in no coarser level, and follow nothing: the
   * displacements of coarser levels are zero there. (Unless there would be no coarser level.)
   */
  template <int dim>
  class LevelHierarchy
  {
  public:
    /** Collective. The discretisation must outlive the object. @param clamped owned nodes */
    LevelHierarchy(const Discretization<dim>       &discretization,
                   const std::vector<unsigned int> &clamped);

    /** The owned nodes of the finest level that are in no coarser one for what is prescribed. */
    const std::vector<unsigned int> &clamped_nodes() const { return clamped; }

    /** With the finest one: two at least. */
    unsigned int n_levels() const { return coarse.size() + 1; }

    const ElasticMatrices<dim> &matrices(const unsigned int level) const
    {
      return level < coarse.size() ? coarse[level].matrices : *finest;
    }

    /**
     * The owned nodes of a level from 1 on, 1 where it smooths: those that are new there, and those
     * that are coupled with them. The others are smoothed by the coarser levels, which are the same
     * there: on adaptive meshes the work of all levels is that of a few finest ones.
     */
    const std::vector<char> &smoothed(const unsigned int level) const
    {
      return coarse[level - 1].smoothed_above;
    }

    /** Zero. */
    template <typename Number>
    LevelVector<Number> make_vector(const unsigned int level) const
    {
      return LevelVector<Number>(4 * matrices(level).pattern.n_owned);
    }

    /** What nodes of a level from 1 on follow on the next coarser one. Collective. */
    std::vector<std::vector<WeightedNode>>
    parents(unsigned int level, const std::vector<dealii::types::global_dof_index> &nodes) const;

    /** fine = P coarse. Collective. @param level of the fine vector */
    template <typename Number>
    void prolongate(unsigned int               level,
                    const LevelVector<Number> &coarse,
                    LevelVector<Number>       &fine) const;

    /** coarse = P'fine. Collective. @param level of the fine vector */
    template <typename Number>
    void restrict_to_coarser(unsigned int               level,
                             const LevelVector<Number> &fine,
                             LevelVector<Number>       &coarse) const;

  private:
    struct Level
    {
      Interpolation        interpolation; ///< of the next finer level
      ElasticMatrices<dim> matrices;
      std::vector<char>    smoothed_above; ///< nodes of the next finer level
      GhostValues          ghosts;         ///< nodes that local finer nodes follow
    };
    const ElasticMatrices<dim> *finest;
    std::vector<unsigned int>   clamped;
    std::vector<char>           is_clamped; ///< nodes of the finest level
    std::deque<Level>           coarse;     ///< from level 0 on

    /** @param nodes of the coarsest level so far, by number in the finest; then of the new one */
    void add_level_of_mesh(const Discretization<dim>     &discretization,
                           const std::vector<NodeOrigin> &origins,
                           unsigned int                   level,
                           std::vector<unsigned int>     &nodes);
    void forget_clamped();
    /** @return false if it would hardly be coarser */
    bool add_algebraic_level(const Discretization<dim> &discretization,
                             std::vector<unsigned int> &nodes);
    /** @param parents and is_new: of the owned nodes of the coarsest level so far */
    void add_level(std::vector<std::vector<WeightedNode>> parents,
                   const std::vector<char>               &is_new,
                   const LocalNodes                      &coarse_nodes);
  };
} // namespace signorini

#endif
