// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_box_shape_h
#define signorini_shapes_box_shape_h

#include <signorini/model/body_shape.h>
#include <signorini/prm/section_reader.h>

#include <array>
#include <memory>

namespace signorini
{
  /**
   * A box, in 2d a rectangle, along the coordinate axes; one of its faces may bulge. Boundary ids
   * are deal.II's colours 0..2*dim-1 (0, 1: x-, x+; 2, 3: y-, y+; ...).
   */
  template <int dim>
  struct BoxShape : public BodyShape<dim>
  {
    dealii::Point<dim>            lower_corner, upper_corner;
    std::array<unsigned int, dim> repetitions;       ///< coarse cells per direction
    double                        cap_radius   = 0.; ///< of the bulging face; 0: all are flat
    dealii::types::boundary_id    cap_boundary = 0;  ///< the face that bulges

    /** Of one cell, with edges 1 from the origin. */
    BoxShape();

    dealii::Point<dim>                      midpoint() const override;
    std::vector<dealii::types::boundary_id> boundary_ids() const override;
    std::vector<dealii::Point<dim>> boundary_points(dealii::types::boundary_id id) const override;

    void make_coarse_mesh(const Placement<dim>       &placement,
                          dealii::Triangulation<dim> &mesh) const override;

    std::vector<dealii::Point<dim>> corners_around() const override;
    double                          n_coarse_cells() const override;
    std::string                     too_many_cells() const override;
    bool                            is_round() const override { return cap_radius > 0.; }
    bool has_only_parallelepipeds() const override { return !is_round(); }
  };

  // `Shape = box`: corners, repetitions, cap.
  template <int dim>
  void declare_box_shape(dealii::ParameterHandler &prm);
  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse_box_shape(const SectionReader &in);

  /** The keys of the cap, which are listed behind those of all shapes. */
  template <int dim>
  void declare_cap(dealii::ParameterHandler &prm);
} // namespace signorini

#endif
