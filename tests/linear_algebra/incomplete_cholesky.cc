// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Where no fill is dropped (one cell, or several that are not connected) the incomplete factor is
// the exact one to single precision, also with held directions at the node that is eliminated last.
// On any mesh and any number of processes it is symmetric, positive definite on the free directions
// and zero in the held ones.

#include <gtest/gtest.h>

#include "held_nodes.h"

using namespace signorini;

template <typename Dim>
class IncompleteCholeskyOf : public testing::Test
{
public:
  static constexpr int    dim = Dim::value;
  static constexpr double a = 1.5, b = 0.2;

  /** Compare factors of M (block_size 1) or a M + b A (block_size dim) with the dense inverse. */
  template <int block_size>
  void expect_exact(const SmallBody<dim>            &body,
                    const HeldNodes<dim>            &held,
                    const std::vector<unsigned int> &eliminate_last) const
  {
    const double          stiffness_factor = block_size == 1 ? 0. : b;
    const Vector          like             = body.discretization.make_vector();
    const Eigen::MatrixXd K                = dense(
      [&](Vector &y, const Vector &x) {
        body.matrices.apply(y, x, {a, stiffness_factor});
      },
      like);
    IncompleteCholesky<dim, block_size> factor(
      body.matrices, {a, stiffness_factor}, eliminate_last);
    factor.set_held_nodes(held);
    const Eigen::MatrixXd approximate =
      dense([&](Vector &y, const Vector &x) { factor.vmult(y, x); }, like);
    const Eigen::MatrixXd exact = inverse_on_free_directions<dim>(K, held);
    EXPECT_LT((approximate - exact).norm(), 2e-6 * exact.norm());
  }

  void expect_exact_factors(const SmallBody<dim>            &body,
                            const HeldNodes<dim>            &held,
                            const std::vector<unsigned int> &eliminate_last) const
  {
    expect_exact<1>(body, held, eliminate_last);
    expect_exact<dim>(body, held, eliminate_last);
  }

  HeldNodes<dim> hold_face(const SmallBody<dim> &body, std::vector<unsigned int> &nodes) const
  {
    const HeldNodes<dim> held = signorini::hold_face<dim>(body);
    for (const HeldNode<dim> &node : held)
      nodes.push_back(node.node);
    return held;
  }
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(IncompleteCholeskyOf, Dimensions);

TYPED_TEST(IncompleteCholeskyOf, OneCellIsInvertedExactly)
{
  constexpr int        dim = TypeParam::value;
  const SmallBody<dim> cell(make_boxes<dim>(1, 0), MPI_COMM_SELF);
  this->expect_exact_factors(cell, {}, {});
  this->expect_exact_factors(cell, {}, {0, 2});
}

TYPED_TEST(IncompleteCholeskyOf, HeldDirectionsOfTheLastNodeAreExact)
{
  constexpr int        dim = TypeParam::value;
  const SmallBody<dim> cell(make_boxes<dim>(1, 0), MPI_COMM_SELF);
  this->expect_exact_factors(
    cell, {held_in_turned_frame<dim>(1, 0.7, first_direction<dim>())}, {1});
  auto all_but_one     = all_directions<dim>();
  all_but_one[dim - 1] = false;
  this->expect_exact_factors(cell, {held_in_turned_frame<dim>(2, -0.3, all_but_one)}, {2});
}

TYPED_TEST(IncompleteCholeskyOf, SeveralLastNodesHeldInAllDirectionsAreExact)
{
  constexpr int        dim = TypeParam::value;
  const SmallBody<dim> cell(make_boxes<dim>(1, 0), MPI_COMM_SELF);
  const auto           all = all_directions<dim>();
  this->expect_exact_factors(
    cell, {held_in_turned_frame<dim>(0, 0.7, all), held_in_turned_frame<dim>(3, 0.1, all)}, {0, 3});
}

TYPED_TEST(IncompleteCholeskyOf, BodiesThatAreNotConnectedAreInvertedOneByOne)
{
  constexpr int        dim = TypeParam::value;
  const SmallBody<dim> cells(make_boxes<dim>(2, 0), MPI_COMM_SELF);
  const unsigned int   second = 1 + dealii::GeometryInfo<dim>::vertices_per_cell;
  this->expect_exact_factors(cells,
                             {held_in_turned_frame<dim>(1, 0.7, first_direction<dim>()),
                              held_in_turned_frame<dim>(second, -1.1, first_direction<dim>())},
                             {1, second});
}

TYPED_TEST(IncompleteCholeskyOf, SymmetricPositiveAndZeroWhereHeld)
{
  constexpr int             dim = TypeParam::value;
  const SmallBody<dim>      body(make_boxes<dim>(1, 2, true), MPI_COMM_WORLD);
  std::vector<unsigned int> nodes;
  const HeldNodes<dim>      held = this->hold_face(body, nodes);
  const Vector              x = body.some_vector(0.), y = body.some_vector(1.);
  Vector                    Px(x), Py(x);
  for (const double stiffness_factor : {0.01, 1., 1e4}) // up to very large Courant numbers
    {
      IncompleteCholesky<dim, dim> factor(body.matrices, {1., stiffness_factor}, nodes);
      factor.set_held_nodes(held);
      factor.vmult(Px, x);
      factor.vmult(Py, y);
      const double scale = std::sqrt((x * Px) * (y * Py)), largest = Px.linfty_norm();
      EXPECT_GT(x * Px, 0.);
      EXPECT_NEAR(x * Py, y * Px, 1e-5 * scale);
      for (const HeldNode<dim> &node : held)
        for (unsigned int c = 0; c < dim; ++c)
          if (node.held[c] && node.node < body.matrices.pattern.n_owned)
            {
              double component = 0.;
              for (unsigned int d = 0; d < dim; ++d)
                component += node.frame[dim * c + d] * Px.local_element(dim * node.node + d);
              EXPECT_NEAR(component, 0., 1e-6 * largest);
            }
    }
  EXPECT_GT(dealii::Utilities::MPI::sum(held.size(), MPI_COMM_WORLD), 2u);
}

TYPED_TEST(IncompleteCholeskyOf, ReleasedNodesAreAsIfTheyHadNeverBeenHeld)
{
  constexpr int              dim = TypeParam::value;
  const SmallBody<dim>       body(make_boxes<dim>(1, 1), MPI_COMM_WORLD);
  std::vector<unsigned int>  nodes;
  const HeldNodes<dim>       held = this->hold_face(body, nodes);
  const Vector               x    = body.some_vector(0.);
  Vector                     before(x), meanwhile(x), after(x);
  IncompleteCholesky<dim, 1> factor(body.matrices, {1., 0.}, nodes);
  factor.vmult(before, x);
  factor.set_held_nodes(held);
  factor.vmult(meanwhile, x);
  factor.set_held_nodes({});
  factor.vmult(after, x);
  after -= before;
  meanwhile -= before;
  EXPECT_EQ(after.linfty_norm(), 0.);
  EXPECT_GT(meanwhile.linfty_norm(), 0.01 * before.linfty_norm());
  EXPECT_EQ(factor.n_applications(), 3u);
}

TYPED_TEST(IncompleteCholeskyOf, HangingNodesHaveNoInfluence)
{
  constexpr int                dim = TypeParam::value;
  const SmallBody<dim>         body(make_boxes<dim>(1, 1, true), MPI_COMM_WORLD);
  IncompleteCholesky<dim, dim> factor(body.matrices, {1., 0.1}, {});
  const Vector                 x         = body.some_vector(0.);
  Vector                       y         = x, Px(x), Py(x);
  const unsigned int           n         = body.matrices.pattern.n_owned;
  unsigned int                 n_hanging = 0;
  for (unsigned int node = 0; node < n; ++node)
    if (body.is_hanging(node))
      {
        ++n_hanging;
        y.local_element(dim * node) = 0.5;
      }
  EXPECT_GT(dealii::Utilities::MPI::sum(n_hanging, MPI_COMM_WORLD), 0u);
  factor.vmult(Px, x);
  factor.vmult(Py, y);
  const double largest = Px.linfty_norm();
  for (unsigned int i = 0; i < dim * n; ++i)
    {
      const double expected = body.is_hanging(i / dim) ? Py.local_element(i) : Px.local_element(i);
      EXPECT_NEAR(Py.local_element(i), expected, 1e-6 * largest);
    }
}
