// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_cell_strain_h
#define signorini_finite_elements_cell_strain_h

#include <signorini/finite_elements/cell_map.h>
#include <signorini/finite_elements/cell_neighbors.h>

#include <algorithm>

namespace signorini
{
  /** Entries (c, pair(a, b)): derivatives of component c, see PointTable. */
  template <int dim>
  using FourHessians = std::array<std::array<FourNumbers, PointTable<dim>::n_pairs>, dim>;

  /**
   * A displacement on a cell and the strain that the element of the cell makes of it, with the map
   * of the cell. The gradient is that of the displacement and of the strain modes; its symmetric
   * part is the strain.
   */
  template <int dim>
  class CellStrain
  {
  public:
    CellStrain(const CellNeighbors<dim> &mesh,
               const LocalCell<dim>     &cell,
               const Vector             &displacement)
      : material(mesh.discretization.mesh().bodies()[cell.body].material)
      , points(support_points(mesh.discretization.mesh().mapping(), cell.cell))
    {
      mesh.gather(cell, displacement, values.data());
      if (has_modes =
            !strain_modes<dim>(mesh.discretization.mesh().bodies()[cell.body].element).empty();
          has_modes)
        modes =
          mesh.discretization.mesh().cell_matrices().of(cell.cell).mode_gradient(values.data());
    }

    const Material &material;

    /** Of the map: entry [i][a] is dx_i/dxi_a. */
    FourMatrices<dim> jacobian(const PointTable<dim> &map_polynomials) const
    {
      return map_polynomials.gradients(numbers(points));
    }

    /** Gradient times the volume element. */
    FourMatrices<dim> gradient(const PointTable<dim>   &polynomials,
                               const FourMatrices<dim> &cofactors) const
    {
      FourMatrices<dim> result = product(polynomials.gradients(values.data()), cofactors);
      for (unsigned int c = 0; has_modes && c < dim; ++c)
        {
          const FourVectors<dim> row = polynomials.values(modes[c].data());
          for (unsigned int i = 0; i < dim; ++i)
            result[c][i] += row[i];
        }
      return result;
    }

    /**
     * Divergence of the stress, sum_i d/dx_i (lambda tr g delta_ci + mu (g_ci + g_ic)) of the
     * gradient g.
     * @param K      inverse Jacobians, entry [a][i] = dxi_a/dx_i
     * @param volume their determinant's inverse
     */
    FourVectors<dim> divergence_of_stress(const PointTable<dim>   &polynomials,
                                          const PointTable<dim>   &map_polynomials,
                                          const FourMatrices<dim> &K,
                                          const FourNumbers       &volume) const;

  private:
    std::array<double, dim *(1u << dim)>  values;
    const std::vector<dealii::Point<dim>> points;
    bool                                  has_modes;
    ModeGradient<dim>                     modes;

    FourVectors<dim> of_displacement(const PointTable<dim>   &polynomials,
                                     const FourHessians<dim> &of_map,
                                     const FourMatrices<dim> &K) const;
    FourVectors<dim> of_modes(const PointTable<dim>   &polynomials,
                              const FourHessians<dim> &of_map,
                              const FourMatrices<dim> &K,
                              const FourNumbers       &volume) const;
  };
} // namespace signorini

#endif
