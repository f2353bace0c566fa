// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_point_table_h
#define signorini_finite_elements_point_table_h

#include <signorini/linear_algebra/lanes.h>

#include <deal.II/fe/fe_q.h>

#include <array>
#include <vector>

namespace signorini
{
  /** One number, vector or matrix at four points at once. */
  using FourNumbers = Lanes<double>;
  template <int dim>
  using FourVectors = std::array<FourNumbers, dim>;
  template <int dim>
  using FourMatrices = std::array<FourVectors<dim>, dim>;

  /**
   * Values and derivatives of the Lagrange polynomials of the reference cell at four points, in
   * deal.II's order of the polynomials.
   */
  template <int dim>
  class PointTable
  {
  public:
    static constexpr unsigned int n_points = 4;
    using Points                           = std::array<dealii::Point<dim>, n_points>;
    /** Pairs of reference directions a <= b. */
    static constexpr unsigned int n_pairs = dim * (dim + 1) / 2;

    PointTable(const dealii::FE_Q<dim> &polynomials, const Points &points);

    /** sum_k numbers[k] phi_k, component by component; there are dim numbers per polynomial. */
    FourVectors<dim> values(const double *numbers) const;

    /** Derivatives of that: entry [c][d] is the derivative of component c in reference direction d.
     */
    FourMatrices<dim> gradients(const double *numbers) const;

    /** Second derivatives: entry [c][pair(a, b)]. */
    std::array<std::array<FourNumbers, n_pairs>, dim>
    second_derivatives(const double *numbers) const;

    static constexpr unsigned int pair(const unsigned int a, const unsigned int b)
    {
      return a == b ? a : dim == 2 ? 2 : 2 + a + b;
    }

  private:
    std::vector<std::array<FourNumbers, 1>>       zeroth;
    std::vector<std::array<FourNumbers, dim>>     first;
    std::vector<std::array<FourNumbers, n_pairs>> second;
  };


  /**
   * Gauss points with two per direction: on a face one per vertex, in the order of the vertices of
   * the cell. In 2d a face has two points, and the other two lanes repeat them.
   */
  template <int dim>
  struct GaussTables
  {
    static constexpr unsigned int n_faces       = 2 * dim;
    static constexpr unsigned int n_face_points = 1u << (dim - 1);
    static constexpr unsigned int n_subfaces    = 1u << (dim - 1);

    explicit GaussTables(unsigned int degree);

    /** The tables of a degree, made once. */
    static const GaussTables &of_degree(unsigned int degree);

    std::vector<PointTable<dim>> faces; ///< by face
    std::vector<PointTable<dim>>
      subfaces; ///< by face and subface, the subface at each vertex of the face
    std::vector<PointTable<dim>> interior; ///< all points of the cell
    /** By vertex of a face: its (bi)linear function at the points of the face. */
    std::array<FourNumbers, n_face_points> vertex_functions;
  };

  /**
   * The vertex of a cell at a vertex of a face; both in lexicographic order of the cell's own
   * coordinates.
   */
  template <int dim>
  constexpr unsigned int vertex_of_face(const unsigned int face, const unsigned int vertex)
  {
    const unsigned int low = vertex & ((1u << (face / 2)) - 1u), high = vertex >> (face / 2);
    return low | (face % 2) << (face / 2) | high << (face / 2 + 1);
  }
} // namespace signorini

#endif
