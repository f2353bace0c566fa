// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_base_levels_h
#define signorini_goals_base_levels_h

#include <signorini/base/archive.h>
#include <signorini/discretization/mesh.h>

#include <deal.II/lac/vector.h>

namespace signorini
{
  /**
   * How fine the coarsest cells of each body have to be. Where an error is that of waves it is
   * everywhere, and moves: a mesh whose cells are refined one by one would scatter the waves and
   * change all the time. So if the coarsest cells of a body together, without the parts of those
   * that stick out, use up a good part of what is tolerated, all of them are refined, and stay so
   * as long as the body matters.
   */
  template <int dim>
  class BaseLevels
  {
  public:
    explicit BaseLevels(const Mesh<dim> &mesh);

    /**
     * Bodies that do not matter lose their levels; others get one more if it is due. Collective.
     * @param indicator eta_T by active_cell_index
     * @param tolerated the sum of their squares
     */
    void see(const dealii::Vector<double> &indicator,
             double                        tolerated,
             const std::vector<bool>      &matters);

    unsigned int operator[](const unsigned int body) const { return levels[body]; }

    void archive(Archive &archive) { archive(levels); }

  private:
    const Mesh<dim>          &mesh;
    std::vector<unsigned int> levels; ///< of bodies
  };
} // namespace signorini

#endif
