// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_ball_shape_h
#define signorini_shapes_ball_shape_h

#include <signorini/model/body_shape.h>
#include <signorini/prm/section_reader.h>

#include <memory>

namespace signorini
{
  /** A ball, in 2d a disc. Boundary id 0. */
  template <int dim>
  struct BallShape : public BodyShape<dim>
  {
    dealii::Point<dim> centre;
    double             radius = 1.;

    dealii::Point<dim>                      midpoint() const override { return centre; }
    std::vector<dealii::types::boundary_id> boundary_ids() const override { return {0}; }
    std::vector<dealii::Point<dim>> boundary_points(dealii::types::boundary_id id) const override;

    void make_coarse_mesh(const Placement<dim>       &placement,
                          dealii::Triangulation<dim> &mesh) const override;

    std::vector<dealii::Point<dim>> corners_around() const override;
    bool                            is_round() const override { return true; }
  };

  /** `Shape = ball`: centre and radius. */
  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse_ball_shape(const SectionReader &in);
} // namespace signorini

#endif
