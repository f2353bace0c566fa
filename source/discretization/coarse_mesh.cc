// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/cap_manifold.h>
#include <signorini/discretization/coarse_mesh.h>
#include <signorini/mesh_files/mesh_file.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Move the vertices; the manifolds of the shape are replaced by the caller. */
    template <int dim>
    void place(const Placement<dim> &placement, Triangulation<dim> &mesh)
    {
      if (!placement.is_identity())
        GridTools::transform(
          [&placement](const Point<dim> &point) { return placement.place(point); }, mesh);
    }

    template <int dim>
    void make_ball(const BodyDescription<dim> &body, Triangulation<dim> &mesh)
    {
      GridGenerator::hyper_ball(mesh, body.centre, body.radius);
      place(body.placement, mesh);
      mesh.set_manifold(0, SphericalManifold<dim>(body.placement.place(body.centre)));
    }

    template <int dim>
    void make_box(const BodyDescription<dim> &body, Triangulation<dim> &mesh)
    {
      GridGenerator::subdivided_hyper_rectangle(
        mesh,
        std::vector<unsigned int>(body.repetitions.begin(), body.repetitions.end()),
        body.lower_corner,
        body.upper_corner,
        true);
      if (body.cap_radius > 0.)
        {
          const CapManifold<dim> manifold(body);
          GridTools::transform(
            [&manifold](const Point<dim> &point) { return manifold.push_forward(point); }, mesh);
          mesh.set_all_manifold_ids(0);
          mesh.set_manifold(0, manifold);
        }
      else
        place(body.placement, mesh);
    }

    void make_cylinder(const BodyDescription<3> &body, Triangulation<3> &mesh)
    {
      GridGenerator::cylinder(mesh, body.radius, body.length / 2.);
      // deal.II's cylinder lies along x; turn x into the wanted axis by a proper rotation.
      GridTools::transform(
        [&body](const Point<3> &p) {
          const Point<3> turned = body.axis == 0   ? p
                                  : body.axis == 1 ? Point<3>(-p[1], p[0], p[2])
                                                   : Point<3>(-p[2], p[1], p[0]);
          return turned + body.centre;
        },
        mesh);
      place(body.placement, mesh);
      Tensor<1, 3> direction;
      direction[body.axis] = 1.;
      mesh.set_manifold(
        0,
        CylindricalManifold<3>(body.placement.turn(direction), body.placement.place(body.centre)));
    }
  } // namespace

  template <int dim>
  void make_coarse_mesh(const BodyDescription<dim> &body, Triangulation<dim> &mesh)
  {
    if (body.shape == BodyShape::ball)
      make_ball(body, mesh);
    else if (body.shape == BodyShape::box)
      make_box(body, mesh);
    else if (body.shape == BodyShape::file)
      {
        read_mesh_file(body.mesh_file.path, mesh, body.mesh_file.part, body.mesh_file.scale);
        place(body.placement, mesh);
      }
    else if constexpr (dim == 3)
      make_cylinder(body, mesh);
  }

  template void make_coarse_mesh(const BodyDescription<2> &, Triangulation<2> &);
  template void make_coarse_mesh(const BodyDescription<3> &, Triangulation<3> &);
} // namespace signorini
