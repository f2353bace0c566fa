// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/cylinder_shape.h>
#include <signorini/shapes/place.h>
#include <signorini/shapes/round_shapes.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  using dealii::Point;

  std::vector<Point<3>> CylinderShape::boundary_points(const dealii::types::boundary_id id) const
  {
    if (id == 0)
      return poles(centre, radius, axis);
    Point<3> end = centre;
    end[axis] += (id == 1 ? -.5 : .5) * length;
    std::vector<Point<3>> points = poles(end, radius, axis);
    points.push_back(end);
    return points;
  }


  void CylinderShape::make_coarse_mesh(const Placement<3>       &placement,
                                       dealii::Triangulation<3> &mesh) const
  {
    dealii::GridGenerator::subdivided_cylinder(mesh, n_axial_cells, radius, length / 2.);
    // deal.II's cylinder lies along x; turn x into the wanted axis by a proper rotation.
    dealii::GridTools::transform(
      [this](const Point<3> &p) {
        const Point<3> turned = axis == 0   ? p
                                : axis == 1 ? Point<3>(-p[1], p[0], p[2])
                                            : Point<3>(-p[2], p[1], p[0]);
        return turned + centre;
      },
      mesh);
    place(placement, mesh);
    dealii::Tensor<1, 3> direction;
    direction[axis] = 1.;
    mesh.set_manifold(
      0, dealii::CylindricalManifold<3>(placement.turn(direction), placement.place(centre)));
  }


  std::vector<Point<3>> CylinderShape::corners_around() const
  {
    dealii::Tensor<1, 3> half;
    for (unsigned int c = 0; c < 3; ++c)
      half[c] = c == axis ? length / 2. : radius;
    return {centre - half, centre + half};
  }


  std::vector<std::string> CylinderShape::notes() const
  {
    constexpr double width_over_radius = 0.75, much_longer = 5.;
    const double     n_even = length / (width_over_radius * radius);
    if (n_even < much_longer * n_axial_cells)
      return {};
    std::ostringstream text;
    text << "its cells are about " << std::round(n_even / n_axial_cells)
         << " times as long as wide, and the solvers slow; with `Axial cells = "
         << std::ceil(n_even) << "` they are even";
    return {text.str()};
  }


  template <>
  std::shared_ptr<const BodyShape<2>> parse_cylinder_shape(const SectionReader &in)
  {
    in.fail("Shape", "a cylinder exists in 3d only. In 2d use `ball` for a disc, or `box`.");
  }


  template <>
  std::shared_ptr<const BodyShape<3>> parse_cylinder_shape(const SectionReader &in)
  {
    const auto cylinder = std::make_shared<CylinderShape>();
    cylinder->centre    = in.point<3>("Centre");
    cylinder->radius    = parse_radius(in);
    cylinder->length    = in.positive_number("Length", "it is the distance between bottom and top");
    cylinder->axis      = std::string("xyz").find(in.text("Axis"));
    cylinder->n_axial_cells = in.integer("Axial cells", 1, 100000);
    return cylinder;
  }
} // namespace signorini
