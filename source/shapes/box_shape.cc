// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/box_shape.h>
#include <signorini/shapes/cap_manifold.h>
#include <signorini/shapes/place.h>

#include <deal.II/grid/grid_generator.h>

#include <functional>
#include <numeric>

namespace signorini
{
  using dealii::Point;
  using dealii::types::boundary_id;

  template <int dim>
  BoxShape<dim>::BoxShape()
  {
    for (unsigned int d = 0; d < dim; ++d)
      upper_corner[d] = 1.;
    repetitions.fill(1);
  }


  template <int dim>
  Point<dim> BoxShape<dim>::midpoint() const
  {
    return lower_corner + .5 * (upper_corner - lower_corner);
  }


  template <int dim>
  std::vector<boundary_id> BoxShape<dim>::boundary_ids() const
  {
    std::vector<boundary_id> ids(2 * dim);
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
  }


  template <int dim>
  std::vector<Point<dim>> BoxShape<dim>::boundary_points(const boundary_id id) const
  {
    const unsigned int      normal_direction  = id / 2;
    const double            normal_coordinate = (id % 2 == 0 ? lower_corner : upper_corner)[id / 2];
    std::vector<Point<dim>> points            = {midpoint()};
    for (unsigned int corner = 0; corner < (1u << dim); ++corner)
      {
        Point<dim> point;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] = ((corner >> d) & 1u ? upper_corner : lower_corner)[d];
        points.push_back(point);
      }
    for (Point<dim> &point : points)
      {
        point[normal_direction] = normal_coordinate;
        point                   = Cap<dim>(*this).bulge(point);
      }
    return points;
  }


  template <int dim>
  void BoxShape<dim>::make_coarse_mesh(const Placement<dim>       &placement,
                                       dealii::Triangulation<dim> &mesh) const
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh,
      std::vector<unsigned int>(repetitions.begin(), repetitions.end()),
      lower_corner,
      upper_corner,
      true);
    if (cap_radius > 0.)
      {
        const CapManifold<dim> manifold(*this, placement);
        dealii::GridTools::transform(
          [&manifold](const Point<dim> &point) { return manifold.push_forward(point); }, mesh);
        mesh.set_all_manifold_ids(0);
        mesh.set_manifold(0, manifold);
      }
    else
      place(placement, mesh);
  }


  template <int dim>
  std::vector<Point<dim>> BoxShape<dim>::corners_around() const
  {
    return {lower_corner, upper_corner};
  }


  template <int dim>
  double BoxShape<dim>::n_coarse_cells() const
  {
    return std::accumulate(repetitions.begin(), repetitions.end(), 1., std::multiplies<>());
  }


  template <int dim>
  std::string BoxShape<dim>::too_many_cells() const
  {
    return "Repetitions gives more than 1000000 coarse cells, which every process must keep. Use "
           "fewer repetitions and more Refinements.";
  }


  template struct BoxShape<2>;
  template struct BoxShape<3>;
} // namespace signorini
