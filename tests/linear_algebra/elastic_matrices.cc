// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Mass and stiffness give linear displacements their exact energies, on any mesh and any number of
// processes, because Q1 contains them; rigid motions have no stress; hanging nodes have no
// influence.

#include <gtest/gtest.h>

#include "small_body.h"

using namespace signorini;

template <typename Dim>
class ElasticMatricesOf : public testing::Test
{
public:
  static constexpr int        dim = Dim::value;
  const SmallBody<dim>        body{make_boxes<dim>(1, 1, true), MPI_COMM_WORLD};
  const ElasticMatrices<dim> &matrices = body.matrices;

  Vector product(const Vector &x, const double a, const double b) const
  {
    Vector result(x);
    matrices.apply(result, x, {a, b});
    return result;
  }

  /** 2 x + y, 3 y (, z): strains 2, 3 (, 1) and shear 1/2. */
  Vector linear_field() const
  {
    std::array<std::string, dim> u;
    u[0] = "2*x + y";
    u[1] = "3*y";
    if constexpr (dim == 3)
      u[2] = "z";
    return body.field(u);
  }
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ElasticMatricesOf, Dimensions);

TYPED_TEST(ElasticMatricesOf, LinearDisplacementsHaveTheirExactEnergies)
{
  constexpr int dim          = TypeParam::value;
  const auto   &material     = this->body.scene.bodies[0].material;
  const Vector  u            = this->linear_field();
  const double  trace        = dim == 2 ? 5. : 6.,
               strain_square = 4. + 9. + (dim == 3 ? 1. : 0.) + 2. * 0.25;
  const double volume        = 2.;
  const double elastic =
    volume * (material.lambda() * trace * trace + 2. * material.mu() * strain_square);
  EXPECT_NEAR(u * this->product(u, 0., 1.), elastic, 1e-12 * elastic);
  // Integrals over [0,2] x [0,1] of (2x+y)^2 = 4x^2 + 4xy + y^2, of 9y^2 and z^2
  const double square = 4. * 8. / 3. + 4. * 1. + 2. / 3. + 9. * 2. / 3. + (dim == 3 ? 2. / 3. : 0.);
  EXPECT_NEAR(u * this->product(u, 1., 0.), material.density * square, 1e-12 * square);
}

TYPED_TEST(ElasticMatricesOf, RigidMotionsHaveNoStress)
{
  constexpr int                dim = TypeParam::value;
  std::array<std::string, dim> shift, rotation;
  shift.fill("1");
  rotation.fill("0");
  rotation[0] = "-y";
  rotation[1] = "x";
  // Not even by round-off, however far: A acts on differences.
  Vector far = this->body.field(shift);
  far *= 1e10;
  EXPECT_EQ(this->product(far, 0., 1.).linfty_norm(), 0.);
  Vector inertia = this->product(far, 1., 1e10);
  inertia -= this->product(far, 1., 0.);
  EXPECT_LT(inertia.linfty_norm(), 1e-5); // 1e10 times round-off
  EXPECT_LT(this->product(this->body.field(rotation), 0., 1.).linfty_norm(), 1e-13);
  EXPECT_GT(this->product(this->linear_field(), 0., 1.).linfty_norm(), 0.1);
}

TYPED_TEST(ElasticMatricesOf, SymmetricAndDefinite)
{
  const Vector x = this->body.some_vector(0.), y = this->body.some_vector(1.);
  for (const auto &[a, b] : {std::pair(1., 0.), std::pair(0., 1.), std::pair(2., 0.3)})
    {
      const double scale = x * this->product(x, a, b);
      EXPECT_GT(scale, 0.);
      EXPECT_NEAR(x * this->product(y, a, b), y * this->product(x, a, b), 1e-13 * scale);
    }
}

TYPED_TEST(ElasticMatricesOf, ACombinedProductIsTheSumAndIsCountedOnce)
{
  const ProductCount before = this->matrices.products();
  const Vector       x      = this->body.some_vector(0.);
  Vector             sum = this->product(x, 2., 0.), elastic = this->product(x, 0., 0.3);
  sum += elastic;
  sum -= this->product(x, 2., 0.3);
  EXPECT_LT(sum.linfty_norm(), 1e-13);
  EXPECT_GT(elastic.linfty_norm(), 0.1);
  const ProductCount after = this->matrices.products();
  EXPECT_EQ(after.mass - before.mass, 1u);
  EXPECT_EQ(after.stiffness - before.stiffness, 1u);
  EXPECT_EQ(after.combined - before.combined, 1u);
}

TYPED_TEST(ElasticMatricesOf, AVectorThatIsZeroNearlyEverywhereCostsAPartOfAProduct)
{
  // It reads what acts on one node of each process, and gives the same by linearity.
  constexpr unsigned int dim = TypeParam::value, n_times = 200;
  const Vector           x = this->body.some_vector(0.);
  Vector                 e = x, x_and_e = x;
  e = 0.;
  // One that does not hang, or it has no matrix.
  unsigned int node = this->matrices.pattern.n_owned / 2;
  while (this->body.is_hanging(node))
    ++node;
  for (unsigned int c = 0; c < dim; ++c)
    e.local_element(dim * node + c) = 1. + c;
  x_and_e += e;
  for (const auto &[a, b] : {std::pair(1., 0.), std::pair(0., 1.), std::pair(2., 0.3)})
    {
      Vector difference = this->product(x_and_e, a, b);
      difference -= this->product(x, a, b);
      const ProductCount before = this->matrices.products();
      Vector             of_e(x);
      for (unsigned int k = 0; k < n_times; ++k)
        of_e = this->product(e, a, b);
      const ProductCount after = this->matrices.products();
      EXPECT_GT(of_e.linfty_norm(), 1e-3);
      difference -= of_e;
      EXPECT_LT(difference.linfty_norm(), 1e-12);
      const unsigned long counted = after.mass + after.stiffness + after.combined - before.mass
                                    - before.stiffness - before.combined;
      EXPECT_LT(counted, n_times);
      EXPECT_GT(counted, 0u);
    }
}

TYPED_TEST(ElasticMatricesOf, HangingNodesHaveNoInfluence)
{
  constexpr int      dim       = TypeParam::value;
  const Vector       x         = this->body.some_vector(0.);
  Vector             y         = x;
  const unsigned int n         = this->matrices.pattern.n_owned;
  unsigned int       n_hanging = 0;
  for (unsigned int node = 0; node < n; ++node)
    if (this->body.is_hanging(node))
      {
        ++n_hanging;
        y.local_element(dim * node) = 1e3;
      }
  EXPECT_GT(dealii::Utilities::MPI::sum(n_hanging, MPI_COMM_WORLD), 0u);
  const Vector Kx = this->product(x, 1., 1.), Ky = this->product(y, 1., 1.);
  for (unsigned int i = 0; i < dim * n; ++i)
    {
      EXPECT_EQ(Kx.local_element(i), Ky.local_element(i));
      EXPECT_TRUE(Ky.local_element(i) == 0. || !this->body.is_hanging(i / dim));
    }
}

TYPED_TEST(ElasticMatricesOf, LumpedMassIsDiagonalAndKeepsTheMass)
{
  constexpr int dim    = TypeParam::value;
  auto          scene  = make_boxes<dim>(1, 1, true);
  scene.time.mass.kind = MassKind::lumped;
  const SmallBody<dim>         lumped(scene, MPI_COMM_WORLD);
  std::array<std::string, dim> shift;
  shift.fill("1");
  const Vector ones = lumped.field(shift), x = lumped.some_vector(0.);
  Vector       sums(ones), product(ones);
  lumped.matrices.apply_mass(sums, ones);
  EXPECT_NEAR(ones * sums, dim * 2. * 2., 1e-12); // dim times density times volume
  lumped.matrices.apply_mass(product, x);
  sums.scale(x);
  product -= sums;
  EXPECT_LT(product.linfty_norm(), 1e-14);
}

TYPED_TEST(ElasticMatricesOf, BlocksAreThoseOfTheProduct)
{
  constexpr int         dim = TypeParam::value;
  const SmallBody<dim>  serial(make_boxes<dim>(1, 1, true), MPI_COMM_SELF);
  const auto           &pattern = serial.matrices.pattern;
  const Eigen::MatrixXd K       = dense(
    [&](Vector &y, const Vector &x) {
      serial.matrices.apply(y, x, {2., 0.3});
    },
    serial.discretization.make_vector());
  Eigen::MatrixXd from_blocks = Eigen::MatrixXd::Zero(K.rows(), K.cols());
  for (unsigned int node = 0; node < pattern.n_owned; ++node)
    for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
      {
        const auto entries = serial.matrices.combined_block(node, k, {2., 0.3});
        const Eigen::Map<const Eigen::Matrix<double, dim, dim>> block(entries.data());
        const unsigned int row = dim * node, column = dim * pattern.columns[k];
        from_blocks.template block<dim, dim>(row, column) =
          block; // half of the pairs of nodes suffices
        from_blocks.template block<dim, dim>(column, row) = block.transpose();
      }
  EXPECT_LT((from_blocks - K).norm(), 1e-13 * K.norm());
}

TYPED_TEST(ElasticMatricesOf, DampingIsThatOfEachBody)
{
  constexpr int dim                = TypeParam::value;
  Scene<dim>    scene              = make_boxes<dim>(2, 1, true);
  scene.bodies[0].material.damping = {0.7, 0.};
  scene.bodies[1].material.damping = {0.2, 0.05};
  const SmallBody<dim>        damped(scene, MPI_COMM_WORLD);
  const ElasticMatrices<dim> &matrices = damped.matrices;
  const auto                 &pattern  = matrices.pattern;

  const Vector x = damped.some_vector(0.4);
  Vector       inertia(x), forces(x), expected(x), found(x);
  matrices.apply_mass(inertia, x);
  matrices.apply_stiffness(forces, x);
  for (unsigned int node = 0; node < pattern.n_owned; ++node)
    {
      const bool            is_second = damped.discretization.node_positions()[node][0] > 2.5;
      const RayleighDamping damping   = scene.bodies[is_second].material.damping;
      for (unsigned int i = dim * node; i < dim * (node + 1); ++i)
        expected.local_element(i) =
          damping.mass * inertia.local_element(i) + damping.stiffness * forces.local_element(i);
    }
  matrices.apply_damping(found, x);
  Vector difference = found;
  difference -= expected;
  EXPECT_LT(difference.linfty_norm(), 1e-14 * expected.linfty_norm());

  const MatrixSum sum{2., 0.3, 1.7}; // a product with all three, and the blocks of the sum
  expected *= sum.damping;
  expected.add(sum.mass, inertia, sum.stiffness, forces);
  matrices.apply(found, x, sum);
  difference = found;
  difference -= expected;
  EXPECT_LT(difference.linfty_norm(), 1e-14 * expected.linfty_norm());

  const SmallBody<dim>  serial(scene, MPI_COMM_SELF);
  const auto           &rows = serial.matrices.pattern;
  const Eigen::MatrixXd K =
    dense([&](Vector &y, const Vector &v) { serial.matrices.apply(y, v, sum); },
          serial.discretization.make_vector());
  for (unsigned int node = 0; node < rows.n_owned; ++node)
    for (unsigned int k = rows.row_start[node]; k < rows.row_start[node + 1]; ++k)
      {
        const auto entries = serial.matrices.combined_block(node, k, sum);
        const Eigen::Map<const Eigen::Matrix<double, dim, dim>> block(entries.data());
        const Eigen::MatrixXd                                   of_product =
          K.template block<dim, dim>(dim * node, dim * rows.columns[k]);
        EXPECT_LT((block - of_product).norm(), 1e-14 * K.norm());
      }
}
