// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_cylinder_shape_h
#define signorini_shapes_cylinder_shape_h

#include <signorini/model/body_shape.h>
#include <signorini/prm/section_reader.h>

#include <memory>
#include <string>
#include <vector>

namespace signorini
{
  /** A cylinder along one of the coordinate axes. Boundary ids 0 mantle, 1 bottom, 2 top. */
  struct CylinderShape : public BodyShape<3>
  {
    dealii::Point<3> centre;
    double           radius        = 1.;
    double           length        = 2.; ///< from bottom to top
    unsigned int     axis          = 2;  ///< its direction: 0, 1, 2
    unsigned int     n_axial_cells = 2;  ///< coarse cells from bottom to top

    dealii::Point<3>                        midpoint() const override { return centre; }
    std::vector<dealii::types::boundary_id> boundary_ids() const override { return {0, 1, 2}; }
    std::vector<dealii::Point<3>> boundary_points(dealii::types::boundary_id id) const override;
    void                          make_coarse_mesh(const Placement<3>       &placement,
                                                   dealii::Triangulation<3> &mesh) const override;
    std::vector<dealii::Point<3>> corners_around() const override;
    double                        n_coarse_cells() const override { return 5. * n_axial_cells; }
    bool                          is_round() const override { return true; }
    /** About cells that are much longer than wide. */
    std::vector<std::string> notes() const override;
  };

  /** `Shape = cylinder`: centre, radius, length, axis, coarse cells along it. @throws UserError in
   * 2d */
  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse_cylinder_shape(const SectionReader &in);
} // namespace signorini

#endif
