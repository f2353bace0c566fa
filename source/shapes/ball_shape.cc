// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/ball_shape.h>
#include <signorini/shapes/place.h>
#include <signorini/shapes/round_shapes.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>

namespace signorini
{
  template <int dim>
  std::vector<dealii::Point<dim>>
  BallShape<dim>::boundary_points(const dealii::types::boundary_id /*id*/) const
  {
    return poles(centre, radius, dealii::numbers::invalid_unsigned_int);
  }


  template <int dim>
  void BallShape<dim>::make_coarse_mesh(const Placement<dim>       &placement,
                                        dealii::Triangulation<dim> &mesh) const
  {
    dealii::GridGenerator::hyper_ball(mesh, centre, radius);
    place(placement, mesh);
    mesh.set_manifold(0, dealii::SphericalManifold<dim>(placement.place(centre)));
  }


  template <int dim>
  std::vector<dealii::Point<dim>> BallShape<dim>::corners_around() const
  {
    dealii::Tensor<1, dim> half;
    for (unsigned int c = 0; c < dim; ++c)
      half[c] = radius;
    return {centre - half, centre + half};
  }


  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse_ball_shape(const SectionReader &in)
  {
    const auto ball = std::make_shared<BallShape<dim>>();
    ball->centre    = in.point<dim>("Centre");
    ball->radius    = parse_radius(in);
    return ball;
  }


#define INSTANTIATE(dim)                                                                           \
  template struct BallShape<dim>;                                                                  \
  template std::shared_ptr<const BodyShape<dim>> parse_ball_shape<dim>(const SectionReader &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
