// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// All vertices of a refined box with a cap are images of the lattice of the flat box, so those of
// the capped face are on the sphere. Its volume is the integral of the thickness over the face, up
// to the second order error of straight edges.

#include "shapes.h"

#include <signorini/shapes/cap.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Edges 1, 2 (, 1.5). */
  template <int dim>
  BodyDescription<dim>
  capped_box(const unsigned int face, const double radius, const unsigned int refinements)
  {
    BodyDescription<dim> body  = box<dim>();
    BoxShape<dim>       &shape = box_of(body);
    shape.upper_corner[1]      = 2.;
    if (dim == 3)
      shape.upper_corner[dim - 1] = 1.5;
    shape.cap_radius   = radius;
    shape.cap_boundary = face;
    body.refinements   = refinements;
    return body;
  }

  template <int dim>
  Placement<dim> turned()
  {
    std::array<double, Placement<dim>::n_angles> degrees;
    degrees.fill(30.);
    Tensor<1, dim> translation;
    translation[0] = 3.;
    return Placement<dim>(degrees, Point<dim>(), translation);
  }

  template <int dim>
  void check_vertices(const bool adaptive)
  {
    for (unsigned int face = 0; face < 2 * dim; ++face)
      {
        BodyDescription<dim> body = capped_box<dim>(face, 1.6, adaptive ? 1 : 2);
        body.placement            = turned<dim>();
        body.local_refinements    = adaptive ? 1 : 0;
        body.refine_where         = "x - 3";
        const Meshed<dim>    meshed(body);
        const BoxShape<dim> &shape = box_of(std::as_const(body));
        const Cap<dim>       cap(shape);
        const unsigned int   direction = face / 2;
        Point<dim> sphere = shape.lower_corner + 0.5 * (shape.upper_corner - shape.lower_corner);
        sphere[direction] =
          face % 2 == 0 ? shape.lower_corner[direction] + 1.6 : shape.upper_corner[direction] - 1.6;
        sphere = body.placement.place(sphere);

        unsigned int n_on_cap = 0;
        for_boundary_vertices(meshed.triangulation,
                              [&](const Point<dim> &vertex, const unsigned int id) {
                                if (id == face)
                                  {
                                    EXPECT_NEAR(vertex.distance(sphere), 1.6, 1e-13);
                                    ++n_on_cap;
                                  }
                              });
        EXPECT_GT(dealii::Utilities::MPI::sum(n_on_cap, MPI_COMM_WORLD), 0u);
        for (const auto &cell : meshed.triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            for (const unsigned int v : cell->vertex_indices())
              {
                const Point<dim> flat = cap.flatten(body.placement.pull_back(cell->vertex(v)));
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    const double step = (shape.upper_corner[d] - shape.lower_corner[d]) / 8.;
                    EXPECT_NEAR(flat[d] / step, std::round(flat[d] / step), 1e-12);
                  }
              }
      }
  }
} // namespace

TEST(Caps, VerticesLieOnTheSphereAndOnTheMap)
{
  check_vertices<2>(false);
  check_vertices<3>(false);
}

TEST(Caps, AlsoWithLocalRefinement)
{
  check_vertices<2>(true);
  check_vertices<3>(true);
}

TEST(Caps, AreaIsTheIntegralOfTheThickness)
{
  // The face is the edge of length 1 at y = 2: recession integrated over |x| < a = 1/2.
  const double R = 0.8, a = 0.5;
  const double expected =
    2. - (2. * a * R - a * std::sqrt(R * R - a * a) - R * R * std::asin(a / R));
  std::vector<double> error;
  for (const unsigned int refinements : {1, 2, 3, 4})
    error.push_back(volume(Meshed<2>(capped_box<2>(3, R, refinements)).triangulation) - expected);
  EXPECT_LT(error[3], 0.) << "chords are inside of the circle";
  EXPECT_LT(std::abs(error[3]), 2e-4);
  EXPECT_NEAR(error[2] / error[3], 4., 0.05);
  EXPECT_NEAR(error[1] / error[2], 4., 0.2);
}

TEST(Caps, VolumeIsTheIntegralOfTheThickness)
{
  // The face x = 0, the rectangle 2 x 1.5.
  const double            R = 1.6;
  const dealii::QGauss<2> quadrature(40);
  double                  expected = 3.;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const double y = 2. * (quadrature.point(q)[0] - 0.5),
                   z = 1.5 * (quadrature.point(q)[1] - 0.5);
      expected -= 3. * quadrature.weight(q) * (R - std::sqrt(R * R - y * y - z * z));
    }
  std::vector<double> error;
  for (const unsigned int refinements : {1, 2, 3})
    error.push_back(volume(Meshed<3>(capped_box<3>(0, R, refinements)).triangulation) - expected);
  EXPECT_LT(std::abs(error[2]), 0.01);
  EXPECT_NEAR(error[1] / error[2], 4., 0.1);
  EXPECT_NEAR(error[0] / error[1], 4., 0.3);

  BodyDescription<3> elsewhere = capped_box<3>(0, R, 3);
  elsewhere.placement          = turned<3>();
  EXPECT_NEAR(volume(Meshed<3>(elsewhere).triangulation) - expected, error[2], 1e-13);
}

TEST(Caps, CurvedCellsFollowTheCap)
{
  const double R = 0.8, a = 0.5;
  const double expected =
    2. - (2. * a * R - a * std::sqrt(R * R - a * a) - R * R * std::asin(a / R));
  Scene<2>     scene    = scene_of<2>({capped_box<2>(3, R, 2)});
  const double straight = total_mass(Assembled<2>(scene).discretization) / 2.;
  scene.mapping         = CellGeometry::curved;
  const double curved   = total_mass(Assembled<2>(scene).discretization) / 2.;
  EXPECT_GT(std::abs(straight - expected), 1e-3);
  EXPECT_LT(std::abs(curved - expected), 0.02 * std::abs(straight - expected));
}
