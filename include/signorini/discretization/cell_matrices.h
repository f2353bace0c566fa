// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_cell_matrices_h
#define signorini_discretization_cell_matrices_h

#include <signorini/discretization/cell_id_hash.h>
#include <signorini/discretization/cell_matrix.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <unordered_map>

namespace signorini
{
  /**
   * Mass and stiffness of single cells, also of cells that are not active. Cells of the same shape
   * and material are computed once: with edges t times as long the mass is t^dim, the stiffness
   * t^(dim-2), the gradient of modes times the volume element t^(dim-1) times as large. Shapes are
   * compared up to the round-off of the vertices; translations and changes of size make no
   * difference, rotations do. Cells whose map is not linear along each edge of the reference cell
   * are kept by their CellId, because quadrature is expensive there: 3 kB per cell in 3d, 0.5 kB in
   * 2d, with the modes of the enhanced element 6 kB and 0.8 kB, and never more than the given
   * number of cells; what is beyond is computed whenever it is asked for. So the matrices survive a
   * change of the mesh. Not for several threads.
   */
  template <int dim>
  class CellMatrices
  {
  public:
    using Cell = typename dealii::Triangulation<dim>::cell_iterator;

    /**
     * @param n_quadrature_points per direction
     * @param capacity            largest number of cells that are kept by their CellId
     */
    CellMatrices(const std::vector<BodyDescription<dim>> &bodies,
                 const dealii::Mapping<dim>              &mapping,
                 unsigned int                             n_quadrature_points,
                 std::size_t                              capacity = 20000);

    /** Of a cell that is not artificial. */
    ScaledCellMatrix<dim> of(const Cell &cell) const;

    /**
     * Shape functions and JxW at the points by which the matrices are integrated. Valid until this
     * object is asked for something else.
     */
    const dealii::FEValues<dim> &values_on(const Cell &cell) const;

    /**
     * To be called when the mesh has changed: shapes are computed anew, so that it does not depend
     * on earlier meshes which of the cells of a shape was computed; and if space gets scarce, what
     * was not used since the last call is dropped.
     */
    void forget_unused();

    /** Number of matrices that are kept. */
    std::size_t n_kept() const { return shapes.size() + curved_cells.size(); }

  private:
    static constexpr unsigned int n_vertices = CellMatrix<dim>::n_vertices;

    /**
     * A cell without place and size: material, and all vertices seen from the first one, divided
     * by the length of the diagonal.
     */
    struct Shape
    {
      unsigned int                              material;
      double                                    size;      ///< length of the diagonal
      double                                    tolerance; ///< round-off of the vertices
      std::array<double, dim *(n_vertices - 1)> vertices;

      Shape(const Cell &cell, const dealii::Mapping<dim> &mapping);
      bool        is_same(const Shape &other) const;
      std::size_t hash() const;
    };

    struct Kept
    {
      CellMatrix<dim> matrix;
      unsigned int    last_mesh; ///< that used it, see forget_unused()
    };

    struct Elastic
    {
      Material    material;
      ElementKind element;
    };

    std::vector<Elastic>          by_body; ///< and material id
    const dealii::Mapping<dim>   &mapping;
    const bool                    all_straight;
    const std::size_t             capacity;
    const dealii::FE_Q<dim>       scalar_fe;
    mutable dealii::FEValues<dim> fe_values, centre_values;
    mutable std::unordered_multimap<std::size_t, std::pair<Shape, Kept>> shapes;
    mutable std::unordered_map<dealii::CellId, Kept, CellIdHash<dim>>    curved_cells;
    mutable std::unordered_map<dealii::types::coarse_cell_id, bool>
                                    straight_coarse_cells; ///< and all their descendants
    mutable std::pair<Shape, Kept> *latest = nullptr;      ///< neighbours are often of one shape
    mutable CellMatrix<dim>         not_kept;
    unsigned int                    mesh = 0; ///< number of calls of forget_unused()

    bool                  is_straight(const Cell &cell, const dealii::CellId &id) const;
    ScaledCellMatrix<dim> of_straight(const Cell &cell) const;
    ScaledCellMatrix<dim> of_curved(const Cell &cell, const dealii::CellId &id) const;
    void                  compute(const Cell &cell, CellMatrix<dim> &result) const;
  };
} // namespace signorini

#endif
