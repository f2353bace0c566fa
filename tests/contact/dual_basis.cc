// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The dual basis is biorthogonal to the shape functions of all nodes that carry a multiplier, and
// contains the constants: on whole and on partly covered faces, for every choice of carriers, and
// also on distorted faces.

#include <signorini/surfaces/dual_basis.h>
#include <signorini/surfaces/face_segments.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

using namespace signorini;
using dealii::Point;

namespace
{
  /**
   * A face in the plane where the last coordinate is `height`, its outward side up (1) or down
   * (-1).
   */
  SurfaceFace<3>
  quadrilateral(const std::vector<Point<2>> &corners, const double height, const double side)
  {
    SurfaceFace<3> face;
    for (unsigned int v = 0; v < 4; ++v)
      face.vertices[v] = Point<3>(corners[v][0], corners[v][1], height);
    face.orientation = side * (face.area_vector(Point<2>(0.5, 0.5))[2] > 0. ? 1. : -1.);
    return face;
  }

  SurfaceFace<2>
  interval(const double lower, const double upper, const double height, const double side)
  {
    SurfaceFace<2> face;
    face.vertices    = {{Point<2>(lower, height), Point<2>(upper, height)}};
    face.orientation = side * (face.area_vector(Point<1>(0.5))[1] > 0. ? 1. : -1.);
    return face;
  }

  /** int N N' over the part of a slave face that is opposite to a master. */
  template <int dim>
  Eigen::MatrixXd covered_mass(const SurfaceFace<dim> &slave, const SurfaceFace<dim> &master)
  {
    const unsigned int n    = SurfaceFace<dim>::n_vertices;
    Eigen::MatrixXd    mass = Eigen::MatrixXd::Zero(n, n);
    for (const auto &point : intersect(slave, master).points)
      {
        const auto                              values = slave.shape_values(point.slave);
        const Eigen::Map<const Eigen::VectorXd> shape(values.data(), n);
        mass += point.weight * shape * shape.transpose();
      }
    return mass;
  }

  /** All properties, for every non-empty set of nodes that carry a multiplier. */
  void expect_dual(const Eigen::MatrixXd &mass)
  {
    ASSERT_GT(mass.sum(), 0.);
    const Eigen::Index    n         = mass.rows();
    const Eigen::VectorXd integrals = mass.rowwise().sum();
    for (unsigned int set = 1; set < (1u << n); ++set)
      {
        std::vector<bool> carries(n);
        for (Eigen::Index i = 0; i < n; ++i)
          carries[i] = set & (1u << i);
        const Eigen::MatrixXd psi     = dual_basis(mass, carries);
        const Eigen::MatrixXd product = psi * mass;
        for (Eigen::Index i = 0; i < n; ++i)
          {
            const double expected = carries[i] ? integrals[i] : 0.;
            EXPECT_EQ(psi.row(i).isZero(0.), !carries[i]) << set;
            for (Eigen::Index j = 0; j < n; ++j)
              EXPECT_NEAR(
                carries[j] ? product(i, j) : 0., i == j ? expected : 0., 1e-12 * integrals.sum())
                << set << ": " << i << j;
          }
        for (Eigen::Index j = 0; j < n; ++j)
          EXPECT_NEAR(psi.col(j).sum(), 1., 1e-12)
            << set << ": the sum of the functions at node " << j;
      }
  }

  const std::vector<Point<2>> unit_square = {{0., 0.}, {1., 0.}, {0., 1.}, {1., 1.}},
                              distorted   = {{-0.1, 0.2}, {1.3, -0.2}, {0.1, 0.9}, {0.9, 1.4}},
                              corner      = {{0.6, -1.}, {2., -1.}, {0.8, 0.5}, {2., 0.5}},
                              strip       = {{-1., 0.4}, {2., 0.3}, {-1., 0.6}, {2., 0.7}},
                              everything  = {{-2., -2.}, {2., -2.}, {-2., 2.}, {2., 2.}};
} // namespace

TEST(DualBasis, OfAnIntervalIsKnown)
{
  const Eigen::MatrixXd psi =
    dual_basis(covered_mass(interval(0., 0.3, 0., -1.), interval(-1., 1., -0.1, 1.)), {true, true});
  EXPECT_LT((psi - (Eigen::MatrixXd(2, 2) << 2., -1., -1., 2.).finished()).norm(), 1e-14);
}

TEST(DualBasis, OfIntervals)
{
  expect_dual(covered_mass(interval(0., 1., 0., -1.), interval(0.9, -1., 0., 1.)));
  expect_dual(covered_mass(interval(1., 0., 0., -1.), interval(0.3, 0.5, 0., 1.)));
}

TEST(DualBasis, OfQuadrilaterals)
{
  for (const auto &slave : {unit_square, distorted})
    for (const auto &master : {everything, distorted, corner, strip})
      expect_dual(covered_mass(quadrilateral(slave, 0., -1.), quadrilateral(master, -0.1, 1.)));
}

// A face with a hanging vertex between its first node and one of the neighbour, which moves it with
// half the weight.
TEST(DualBasis, WithAHangingVertex)
{
  Eigen::MatrixXd parents = Eigen::MatrixXd::Identity(4, 4); // row: node, column: vertex
  parents(0, 1) = parents(1, 1) = 0.5;
  for (const auto &master : {everything, corner})
    {
      const Eigen::MatrixXd mass =
        covered_mass(quadrilateral(unit_square, 0., -1.), quadrilateral(master, -0.1, 1.));
      expect_dual(parents * mass * parents.transpose());
    }
}

// A sliver as narrow as the coupling accepts: the condition of the mass is large, yet the dual
// basis keeps its digits.
TEST(DualBasis, OfASliver)
{
  const Eigen::MatrixXd mass =
    covered_mass(interval(0., 1., 0., -1.), interval(1. - 1.1e-3, 2., 0., 1.));
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(mass).eigenvalues().minCoeff(), 0.);
  expect_dual(mass);
}
