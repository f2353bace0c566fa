// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What a shape says before its mesh is made is true of the mesh: number of cells, boundary ids,
// points on the boundaries, and the box around it. Placing the mesh places its vertices. Shapes
// need not agree on the ids of their manifolds.

#include "../discretization/shapes.h"

#include <signorini/model/placed_body.h>

#include <gtest/gtest.h>

#include <set>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  template <int dim>
  Point<dim> some_point()
  {
    Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = 0.3 + 0.7 * d;
    return point;
  }

  /** One of each class, with data that differ from the defaults. */
  template <int dim>
  std::vector<BodyDescription<dim>> one_of_each()
  {
    BodyDescription<dim> round, flat, capped;
    round.name                               = "ball";
    ball_of(round).centre                    = some_point<dim>();
    ball_of(round).radius                    = 0.7;
    flat.name                                = "box";
    BoxShape<dim> &box                       = box_of(flat);
    box.lower_corner                         = some_point<dim>();
    box.upper_corner                         = 3. * some_point<dim>();
    box.repetitions[0]                       = 3;
    capped.name                              = "box with a cap";
    capped.shape                             = flat.shape;
    box_of(capped).cap_radius                = 10.;
    box_of(capped).cap_boundary              = 1;
    std::vector<BodyDescription<dim>> bodies = {round, flat, capped};
    if constexpr (dim == 3)
      {
        BodyDescription<3> cylinder, anvil;
        cylinder.name                                   = "cylinder";
        shape_of<CylinderShape>(cylinder).centre        = some_point<3>();
        shape_of<CylinderShape>(cylinder).length        = 3.;
        shape_of<CylinderShape>(cylinder).axis          = 1;
        shape_of<CylinderShape>(cylinder).n_axial_cells = 3;
        anvil.name                                      = "file";
        anvil.shape                                     = std::make_shared<MeshFileShape<3>>(
          describe_mesh_file<3>(SIGNORINI_SOURCE_DIR "/parameters/meshes/anvil.msh"));
        bodies.push_back(cylinder);
        bodies.push_back(anvil);
      }
    return bodies;
  }

  template <int dim>
  dealii::BoundingBox<dim> box_around(const std::vector<Point<dim>> &points)
  {
    dealii::BoundingBox<dim> box(points);
    box.extend(1e-12);
    return box;
  }

  template <int dim>
  void check_shapes()
  {
    for (BodyDescription<dim> body : one_of_each<dim>())
      {
        SCOPED_TRACE(body.name);
        const BodyShape<dim>      &shape = *body.shape;
        dealii::Triangulation<dim> mesh;
        shape.make_coarse_mesh(body.placement, mesh);
        EXPECT_EQ(shape.boundary_ids(), mesh.get_boundary_ids());
        if (shape.n_coarse_cells() > 0.)
          {
            EXPECT_EQ(shape.n_coarse_cells(), mesh.n_active_cells());
          }
        if (const auto corners = shape.corners_around(); !corners.empty())
          {
            for (const Point<dim> &vertex : mesh.get_vertices())
              EXPECT_TRUE(box_around(corners).point_inside(vertex)) << vertex;
            EXPECT_LT(shape.midpoint().distance(corners[0] + 0.5 * (corners[1] - corners[0])),
                      1e-14);
          }
        else
          {
            EXPECT_LT(shape.midpoint().distance(box_around(mesh.get_vertices()).center()), 1e-12);
          }

        const std::vector<Point<dim>>                vertices = mesh.get_vertices();
        std::array<double, Placement<dim>::n_angles> degrees;
        degrees.fill(25.);
        body.placement = Placement<dim>(degrees, some_point<dim>(), some_point<dim>());
        dealii::Triangulation<dim> placed;
        shape.make_coarse_mesh(body.placement, placed);
        ASSERT_EQ(placed.n_vertices(), vertices.size());
        for (std::size_t v = 0; v < vertices.size(); ++v)
          EXPECT_LT(placed.get_vertices()[v].distance(body.placement.place(vertices[v])), 1e-13);
      }
  }

  /** Whether a point is one of the vertices on a boundary. */
  template <int dim>
  bool is_on_boundary(const dealii::parallel::distributed::Triangulation<dim> &mesh,
                      const unsigned int                                       id,
                      const Point<dim>                                        &point)
  {
    bool found = false;
    for_boundary_vertices(mesh, [&](const Point<dim> &vertex, const unsigned int id_of_face) {
      found = found || (id == id_of_face && vertex.distance(point) < 1e-12);
    });
    return found;
  }

  /** Points of balls, boxes and cylinders become vertices when cells are halved. */
  template <int dim>
  void check_boundary_points()
  {
    for (BodyDescription<dim> body : one_of_each<dim>())
      {
        SCOPED_TRACE(body.name);
        body.refinements = 1;
        body.placement   = Placement<dim>({}, Point<dim>(), some_point<dim>());
        const Meshed<dim> meshed(body);
        for (const auto id : body.shape->boundary_ids())
          for (const Point<dim> &point : boundary_points(body, id))
            EXPECT_TRUE(is_on_boundary(meshed.triangulation, id, point)) << id << ": " << point;
      }
  }

  /** A ball whose manifold has another id than those of the other shapes. */
  struct OddBall : public BallShape<2>
  {
    void make_coarse_mesh(const Placement<2>       &placement,
                          dealii::Triangulation<2> &mesh) const override
    {
      BallShape<2>::make_coarse_mesh(placement, mesh);
      const auto manifold = mesh.get_manifold(0).clone();
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            face->set_manifold_id(4);
      mesh.reset_all_manifolds();
      mesh.set_manifold(4, *manifold);
    }
  };
} // namespace


TEST(CoarseMeshes, AreWhatTheShapeSays)
{
  check_shapes<2>();
  check_shapes<3>();
}


TEST(CoarseMeshes, HavePointsForExpressionsOnTheirBoundaries)
{
  check_boundary_points<2>();
  check_boundary_points<3>();
}


TEST(CoarseMeshes, OfSlenderCylindersAreTold)
{
  CylinderShape cylinder;
  cylinder.length = 3.;
  EXPECT_TRUE(cylinder.notes().empty());
  cylinder.length = 30.;
  ASSERT_EQ(cylinder.notes().size(), 1U);
  EXPECT_NE(cylinder.notes()[0].find("20 times as long as wide"), std::string::npos);
  EXPECT_NE(cylinder.notes()[0].find("`Axial cells = 40`"), std::string::npos);
  cylinder.n_axial_cells = 40;
  EXPECT_TRUE(cylinder.notes().empty());
}

TEST(CoarseMeshes, MayHaveManifoldsOfAnyId)
{
  std::vector<BodyDescription<2>> bodies = {ball<2>(3), ball<2>(3), ball<2>(3)};
  bodies[0].shape                        = std::make_shared<OddBall>();
  bodies[1].placement                    = Placement<2>({}, Point<2>(), Tensor<1, 2>({5., 0.}));
  bodies[2].placement                    = Placement<2>({}, Point<2>(), Tensor<1, 2>({9., 0.}));
  dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
  make_triangulation(bodies, mesh);
  unsigned int n_vertices = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        for (const unsigned int v : face->vertex_indices())
          {
            EXPECT_NEAR(
              face->vertex(v).distance(centre_of(bodies[cell->material_id()])), 1., 1e-14);
            ++n_vertices;
          }
  EXPECT_EQ(n_vertices, 3u * 2u * 4u * 8u);
}
