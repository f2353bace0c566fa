// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_contact_frame_h
#define signorini_surfaces_contact_frame_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace signorini
{
  /**
   * Right-handed orthonormal frame, row by row: normal, tangents. Axes are kept exactly where the
   * normal allows it.
   */
  template <int dim>
  std::array<double, dim * dim> contact_frame(const dealii::Tensor<1, dim> &normal);

  /**
   * A frame in which the held Cartesian components are single tangential entries.
   * @return false if there is none, because a held direction is not tangential
   */
  template <int dim>
  bool contact_frame_with_dirichlet(const dealii::Tensor<1, dim>  &normal,
                                    const std::array<bool, dim>   &held,
                                    std::array<double, dim * dim> &frame);

  /**
   * Rows that are unit vectors at right angles, by Gram and Schmidt: first those that are held,
   * then the others. A frame that is orthonormal stays what it is.
   */
  template <int dim>
  std::array<double, dim * dim> orthonormal_frame(const std::array<double, dim * dim> &frame,
                                                  const std::array<bool, dim>         &held = {});

  /**
   * The frame whose first rows are given unit vectors, linearly independent ones, one to dim; what
   * is left are unit vectors at right angles to them.
   */
  template <int dim>
  std::array<double, dim * dim> oblique_frame(const std::vector<dealii::Tensor<1, dim>> &normals);

  /** The inverse of a frame, transposed. */
  template <int dim>
  std::array<double, dim * dim> dual_frame(const std::array<double, dim * dim> &frame);

  /**
   * For each Cartesian component the row of a frame that is its axis, up to the sign; dim where
   * there is none.
   */
  template <int dim>
  std::array<unsigned int, dim> rows_along_axes(const std::array<double, dim * dim> &frame);
} // namespace signorini

#endif
