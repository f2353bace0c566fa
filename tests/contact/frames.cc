// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A contact frame is orthonormal, with the normal first, so that the change of coordinates keeps
// lengths; a prescribed direction is one of its tangents, so that both conditions hold single
// entries.

#include "contact_scene.h"

#include <signorini/surfaces/contact_frame.h>

#include <gtest/gtest.h>

using namespace signorini;
using dealii::Tensor;

namespace
{
  template <int dim>
  double product_of_rows(const std::array<double, dim * dim> &frame,
                         const unsigned int                   i,
                         const unsigned int                   j)
  {
    double sum = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      sum += frame[dim * i + c] * frame[dim * j + c];
    return sum;
  }

  template <int dim>
  void expect_orthonormal(const std::array<double, dim * dim> &frame, const Tensor<1, dim> &normal)
  {
    for (unsigned int c = 0; c < dim; ++c)
      EXPECT_DOUBLE_EQ(frame[c], normal[c]);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        EXPECT_NEAR(product_of_rows<dim>(frame, i, j), i == j ? 1. : 0., 1e-15)
          << normal << ": " << i << " " << j;
  }

  std::vector<Tensor<1, 3>> normals()
  {
    std::vector<Tensor<1, 3>> result;
    for (const double x : {-1., 0., 1e-9, 0.3})
      for (const double y : {-0.7, 0., 1.})
        for (const double z : {-1., 0., 1e-14, 2.})
          if (const Tensor<1, 3> normal({x, y, z}); normal.norm() > 0.1)
            result.push_back(normal / normal.norm());
    return result;
  }

  /** Whether a row of the frame is plus or minus the axis, without any round-off. */
  bool has_axis(const std::array<double, 9> &frame, const unsigned int axis)
  {
    return std::abs(frame[3 + axis]) == 1. || std::abs(frame[6 + axis]) == 1.;
  }
} // namespace

TEST(ContactFrame, IsOrthonormal)
{
  for (const Tensor<1, 3> &normal : normals())
    expect_orthonormal<3>(contact_frame(normal), normal);
  for (double angle = 0.; angle < 6.; angle += 0.5)
    {
      const Tensor<1, 2> normal({std::cos(angle), std::sin(angle)});
      expect_orthonormal<2>(contact_frame(normal), normal);
    }
}

TEST(ContactFrame, IsRightHanded)
{
  for (const Tensor<1, 3> &normal : normals())
    {
      const auto         frame = contact_frame(normal);
      const Tensor<1, 3> first({frame[3], frame[4], frame[5]}),
        second({frame[6], frame[7], frame[8]});
      EXPECT_NEAR(dealii::cross_product_3d(normal, first) * second, 1., 1e-15);
    }
}

TEST(ContactFrame, TakesInTangentialDirichletConditions)
{
  const Tensor<1, 3>    oblique({0.6, 0., 0.8}), down({0., 0., -1.});
  std::array<double, 9> frame;
  ASSERT_TRUE(contact_frame_with_dirichlet<3>(oblique, {{false, true, false}}, frame));
  expect_orthonormal<3>(frame, oblique);
  EXPECT_TRUE(has_axis(frame, 1));
  ASSERT_TRUE(contact_frame_with_dirichlet<3>(down, {{true, true, false}}, frame));
  expect_orthonormal<3>(frame, down);
  EXPECT_TRUE(has_axis(frame, 0) && has_axis(frame, 1));

  std::array<double, 4> flat;
  ASSERT_TRUE(contact_frame_with_dirichlet<2>(Tensor<1, 2>({0., -1.}), {{true, false}}, flat));
  expect_orthonormal<2>(flat, Tensor<1, 2>({0., -1.}));
}

TEST(ContactFrame, RefusesDirichletConditionsThatAreNotTangential)
{
  std::array<double, 9> frame;
  EXPECT_FALSE(
    contact_frame_with_dirichlet<3>(Tensor<1, 3>({0., 0., -1.}), {{false, false, true}}, frame));
  EXPECT_FALSE(
    contact_frame_with_dirichlet<3>(Tensor<1, 3>({0.6, 0., 0.8}), {{true, true, false}}, frame));
  std::array<double, 4> flat;
  EXPECT_FALSE(contact_frame_with_dirichlet<2>(Tensor<1, 2>({0.6, 0.8}), {{true, false}}, flat));
}

TEST(ContactFrame, StaysWithoutDirichletConditions)
{
  const Tensor<1, 3>    oblique({0.6, 0., 0.8});
  const auto            free  = contact_frame(oblique);
  std::array<double, 9> frame = free;
  ASSERT_TRUE(contact_frame_with_dirichlet<3>(oblique, {{false, false, false}}, frame));
  EXPECT_EQ(frame, free);
}

// In a corner the normals of two or three obstacles are the first rows of a frame, and the rest is
// at right angles to them. Forces have components by the dual frame: products of forces and
// displacements stay what they are.
TEST(ContactFrame, OfACornerHasTheNormalsAsRows)
{
  const std::vector<Tensor<1, 3>> all = {
    Tensor<1, 3>({0., 0., -1.}), Tensor<1, 3>({0.6, 0., -0.8}), Tensor<1, 3>({0., 0.8, 0.6})};
  for (unsigned int n = 1; n <= 3; ++n)
    {
      const std::vector<Tensor<1, 3>> some(all.begin(), all.begin() + n);
      const auto                      frame = oblique_frame<3>(some), dual = dual_frame<3>(frame);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            double product = 0.;
            for (unsigned int c = 0; c < 3; ++c)
              product += frame[3 * i + c] * dual[3 * j + c];
            EXPECT_NEAR(product, i == j, 1e-15);
            EXPECT_EQ(i < n ? frame[3 * i + j] : 0., i < n ? all[i][j] : 0.);
            if (i >= n || j >= n)
              {
                EXPECT_NEAR(product_of_rows<3>(frame, i, j), i == j, 1e-15);
              }
          }
      if (n == 1)
        expect_orthonormal<3>(frame, all[0]);
      // What is held spans the same directions in the orthonormal frame.
      const std::array<bool, 3> held        = {{false, true, n == 3}};
      const auto                orthonormal = orthonormal_frame<3>(frame, held);
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_EQ(orthonormal[3 + c], frame[3 + c]) << "held ones come first";
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          EXPECT_NEAR(product_of_rows<3>(orthonormal, i, j), i == j, 1e-15);
    }
}
