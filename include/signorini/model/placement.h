// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_placement_h
#define signorini_model_placement_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace signorini
{
  /**
   * The rigid motion x -> c + Q (x - c) + v that takes a shape as it is described to its place in
   * space.
   */
  template <int dim>
  class Placement
  {
  public:
    /** Number of angles of a rotation: about the axis out of the plane, or about x, y and z. */
    static constexpr unsigned int n_angles = (dim == 2 ? 1 : 3);

    /** The shape stays where it is. */
    Placement();

    /**
     * Rotation by @p degrees about @p centre (3d: about the x axis first, then y, then z, axes of
     * space through the centre), then translation.
     */
    Placement(const std::array<double, n_angles> &degrees,
              const dealii::Point<dim>           &centre,
              const dealii::Tensor<1, dim>       &translation);

    bool is_identity() const { return !rotates && translation.norm() == 0.; }

    /**
     * Where a point of the shape comes to lie. Without a motion this is the point itself, to the
     * last digit.
     */
    dealii::Point<dim> place(const dealii::Point<dim> &point) const;
    /** The point of the shape that came to lie here; inverse of place(). */
    dealii::Point<dim> pull_back(const dealii::Point<dim> &point) const;
    /** Q times a direction. */
    dealii::Tensor<1, dim> turn(const dealii::Tensor<1, dim> &direction) const;

  private:
    bool                   rotates = false;
    dealii::Tensor<2, dim> rotation; ///< Q, orthogonal
    dealii::Point<dim>     centre;
    dealii::Tensor<1, dim> translation;
  };
} // namespace signorini

#endif
