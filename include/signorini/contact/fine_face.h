// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_fine_face_h
#define signorini_contact_fine_face_h

#include <signorini/discretization/discretization.h>

#include <deal.II/base/bounding_box.h>

#include <functional>
#include <optional>

namespace signorini
{
  /**
   * A face of an owned cell as a finer mesh would have it: points between its vertices that lie on
   * the surface of the body, not on the straight face, and move with the displacement of the face.
   */
  template <int dim>
  class FineFace
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    FineFace(const Cell &cell, unsigned int face);

    const Cell &cell() const { return of_cell; }

    /** Of its vertices; length. */
    double diameter() const { return size; }

    /** @param displacement with ghosts, see Discretization::interpolate_hanging_nodes() */
    std::vector<dealii::Point<dim>> vertices(const Vector &displacement) const;

    /** Whether a vertex has a value. @param values with ghosts */
    bool has_value(unsigned int vertex, const Vector &values) const;

    /** Around its surface. @param displacement with ghosts */
    dealii::BoundingBox<dim> box(const Vector &displacement);

    /** A wider one, for which its surface need not be known. @param displacement with ghosts */
    dealii::BoundingBox<dim> wide_box(const Vector &displacement) const;

    /** The middle of the straight face. @param displacement with ghosts */
    dealii::Point<dim> middle(const Vector &displacement) const;

    /**
     * The least value of a function on the surface: that of the best of a grid of points, around
     * which it is looked for more closely. Infinity where the function has no value.
     * @param displacement with ghosts
     */
    double least(const std::function<std::optional<double>(const dealii::Point<dim> &)> &function,
                 const Vector &displacement);

    /**
     * The grid as segments or triangles; outside is where normal_of_facet() points to.
     * @param displacement with ghosts
     */
    std::vector<std::array<dealii::Point<dim>, dim>> facets(const Vector &displacement);

  private:
    static constexpr unsigned int n_vertices = dealii::GeometryInfo<dim>::vertices_per_face;
    /** Parts of an edge: a bulge between points is 1/64 or 1/16 of that of the face. */
    static constexpr unsigned int n_parts = dim == 2 ? 8 : 4;
    /** Of one and the next grid around the best point; each is twice as fine. */
    static constexpr unsigned int n_closer_looks = 4;
    /** Of the diameter: bulges are less high. */
    static constexpr double margin = 0.5;
    /** Reference coordinates on the face; in 2d the second one is zero. */
    using Place = std::array<double, 2>;

    Cell                            of_cell;
    unsigned int                    number;
    double                          size;
    bool                            is_turned; ///< its vertices: the normal would point inwards
    std::vector<dealii::Point<dim>> grid;      ///< undeformed; empty: not known yet

    static std::array<double, n_vertices>          weights(const Place &place);
    static Place                                   place_in_grid(unsigned int n);
    dealii::Point<dim>                             undeformed(const Place &place) const;
    std::array<dealii::Tensor<1, dim>, n_vertices> displacements(const Vector &displacement) const;
    /** The grid, vertices included. */
    std::vector<dealii::Point<dim>> points(const Vector &displacement);
    dealii::Tensor<1, dim> displacement_of(unsigned int vertex, const Vector &displacement) const;
  };

  /** Unit vector. */
  template <int dim>
  dealii::Tensor<1, dim> normal_of_facet(const std::array<dealii::Point<dim>, dim> &corners);
} // namespace signorini

#endif
