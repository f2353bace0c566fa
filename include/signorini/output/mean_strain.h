// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_mean_strain_h
#define signorini_output_mean_strain_h

#include <signorini/discretization/discretization.h>

#include <deal.II/base/symmetric_tensor.h>

namespace signorini
{
  /** A vector at each vertex of a cell. */
  template <int dim>
  using CellVectors =
    std::array<dealii::Tensor<1, dim>, dealii::GeometryInfo<dim>::vertices_per_cell>;

  /**
   * The mean strain of a cell is that of its displacement, because strain modes have no mean value
   * (see StrainMode). It is linear in the displacement of the vertices,
   *
   *     1/|K| int_K eps(u) dx = sum over vertices v of sym(u_v (x) g_v),
   *     g_v = 1/|K| int_K grad N_v dx,
   *
   * and the g_v stay as long as the mesh: 192 bytes per cell in 3d, and one pass over them instead
   * of one over all points of quadrature.
   */
  template <int dim>
  class MeanStrain
  {
  public:
    /** Of the locally owned cells of a mesh. Not collective. */
    explicit MeanStrain(const Discretization<dim> &discretization);

    /**
     * @param cell         number of the cell among the locally owned active ones, in their order
     * @param displacement of its vertices
     */
    dealii::SymmetricTensor<2, dim> of(unsigned int            cell,
                                       const CellVectors<dim> &displacement) const;

  private:
    std::vector<CellVectors<dim>> gradients; ///< g_v
  };

  /**
   * The places of the first entries of the vertices of a cell in a vector.
   * @param vector with ghosts, see Discretization::interpolate_hanging_nodes()
   */
  template <int dim>
  std::array<unsigned int, dealii::GeometryInfo<dim>::vertices_per_cell>
  places_of_vertices(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                     const Vector                                                 &vector);

  /** @param places see places_of_vertices() */
  template <int dim>
  CellVectors<dim> values_at_vertices(
    const Vector                                                                 &vector,
    const std::array<unsigned int, dealii::GeometryInfo<dim>::vertices_per_cell> &places);
} // namespace signorini

#endif
