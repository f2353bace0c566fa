// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Sweeps of Gauss and Seidel are symmetric, positive definite on the free directions and zero in
// the held ones; the norm with which a rough solve starts is that of P^-1; and the conjugate
// gradients inside, which never form a product with K, solve with K: to single precision from one
// solve, to double precision by refinement. All that holds with hanging nodes, in any units and on
// any number of processes, whose sweeps are the same method in another order: iterations may differ
// by a half on such small meshes.

#include <signorini/linear_algebra/conjugate_gradients.h>
#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/sweeps/symmetric_gauss_seidel.h>

#include <gtest/gtest.h>

#include "../linear_algebra/held_nodes.h"

using namespace signorini;

namespace
{
  /** K = M + s A of a body. */
  template <int dim>
  class Sum : public LinearOperator
  {
  public:
    Sum(const ElasticMatrices<dim> &matrices, const MatrixSum &sum)
      : matrices(matrices)
      , sum(sum)
    {
    }
    void vmult(Vector &destination, const Vector &source) const override
    {
      matrices.apply(destination, source, sum);
    }
    void diagonal(Vector &) const override { FAIL() << "nobody needs it"; }

  private:
    const ElasticMatrices<dim> &matrices;
    const MatrixSum             sum;
  };


  /** Sweeps with some nodes held, as conjugate gradients see them. */
  template <int dim, int block_size>
  class Sweeps : public MaskedPreconditioner
  {
  public:
    Sweeps(const SmallBody<dim> &body, const MatrixSum &sum, const HeldNodes<dim> &held)
      : sweeps(body.matrices, sum)
    {
      sweeps.set_held_nodes(held);
    }
    void set_mask(const Mask &) override {}
    void vmult(Vector &destination, const Vector &source) const override
    {
      sweeps.vmult(destination, source);
    }
    const RoughSolver *rough_solver() const override { return &sweeps; }

    SymmetricGaussSeidel<dim, block_size> sweeps;
  };


  /** The largest component of a vector in a held direction of an owned node. */
  template <int dim>
  double largest_held(const SmallBody<dim> &body, const HeldNodes<dim> &held, const Vector &vector)
  {
    double largest = 0.;
    for (const HeldNode<dim> &node : held)
      for (unsigned int c = 0; c < dim; ++c)
        if (node.held[c] && node.node < body.matrices.pattern.n_owned)
          {
            double component = 0.;
            for (unsigned int d = 0; d < dim; ++d)
              component += node.frame[dim * c + d] * vector.local_element(dim * node.node + d);
            largest = std::max(largest, std::abs(component));
          }
    return largest;
  }


  template <int dim>
  Vector some_free_vector(const SmallBody<dim> &body, const HeldNodes<dim> &held)
  {
    return free_part(held, body.matrices.pattern.n_owned, body.some_vector(0.));
  }
} // namespace

template <typename Dim>
class SymmetricGaussSeidelOf : public testing::Test
{
public:
  static constexpr int dim = Dim::value;

  template <int block_size>
  void expect_laws_of_a_preconditioner(const MatrixSum &sum) const
  {
    const SmallBody<dim>          body(make_boxes<dim>(1, 2, true), MPI_COMM_WORLD);
    const HeldNodes<dim>          held = hold_face(body);
    const Sweeps<dim, block_size> P(body, sum, held);
    const Vector                  x = body.some_vector(0.), y = body.some_vector(1.);
    Vector                        Px(x), Py(x);
    P.vmult(Px, x);
    P.vmult(Py, y);
    EXPECT_GT(x * Px, 0.);
    EXPECT_NEAR(x * Py, y * Px, 1e-5 * std::sqrt((x * Px) * (y * Py)));
    EXPECT_LT(largest_held(body, held, Px), 1e-6 * Px.linfty_norm());
    EXPECT_NEAR(P.sweeps.start(x), std::sqrt(x * Px), 1e-5 * std::sqrt(x * Px));
    EXPECT_GT(dealii::Utilities::MPI::sum(held.size(), MPI_COMM_WORLD), 2u);
  }

  /** One rough solve. */
  template <int block_size>
  void expect_rough_solution(const Scene<dim> &scene, const MatrixSum &sum) const
  {
    const SmallBody<dim>    body(scene, MPI_COMM_WORLD);
    const HeldNodes<dim>    held = hold_face(body);
    Sweeps<dim, block_size> P(body, sum, held);
    const Vector            x = some_free_vector(body, held);
    Vector                  b(x), found(x);
    Sum<dim>(body.matrices, sum).vmult(b, x);
    P.sweeps.start(b);
    P.sweeps.solve(found, 1e-5, 1000);
    EXPECT_LT(largest_held(body, held, found), 1e-6 * found.linfty_norm());
    found -= x;
    EXPECT_LT(found.l2_norm(), 1e-3 * x.l2_norm());
  }

  /** Refined. @return iterations */
  template <int block_size>
  unsigned int expect_solution(const Scene<dim> &scene, const MatrixSum &sum) const
  {
    const SmallBody<dim>    body(scene, MPI_COMM_WORLD);
    const HeldNodes<dim>    held = hold_face(body);
    const unsigned int      n    = body.matrices.pattern.n_owned;
    Sweeps<dim, block_size> P(body, sum, held);
    const Sum<dim>          K(body.matrices, sum);
    const Vector            x = some_free_vector(body, held);
    Vector                  b(x), found(x), rest(x);
    K.vmult(b, x);
    found               = 0.;
    Vector     residual = b;
    const auto report =
      ConjugateGradients().solve(K, P, found, residual, 1e-11 * P.sweeps.start(b), 0., 1000, false);
    EXPECT_TRUE(report.converged);
    rest = found;
    rest -= x;
    // The held directions are held to single precision; outside, whoever knows them makes it exact.
    EXPECT_LT(free_part(held, n, rest).l2_norm(), 1e-6 * x.l2_norm());
    K.vmult(rest, found);
    rest -= b;
    rest += residual;
    EXPECT_LT(rest.l2_norm(), 1e-13 * b.l2_norm()) << "the residual is the true one";
    return report.iterations;
  }
};

using GaussSeidelDimensions =
  testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SymmetricGaussSeidelOf, GaussSeidelDimensions);

TYPED_TEST(SymmetricGaussSeidelOf, SymmetricPositiveAndZeroWhereHeld)
{
  this->template expect_laws_of_a_preconditioner<1>({1., 0.});
  for (const double stiffness_factor : {0.01, 1., 1e4}) // up to very large Courant numbers
    this->template expect_laws_of_a_preconditioner<TypeParam::value>({1., stiffness_factor});
}

TYPED_TEST(SymmetricGaussSeidelOf, SolvesByItself)
{
  constexpr int dim = TypeParam::value;
  for (const bool hanging_nodes : {false, true})
    {
      const Scene<dim> scene = make_boxes<dim>(1, 2, hanging_nodes);
      this->template expect_rough_solution<1>(scene, {1., 0.});
      this->template expect_rough_solution<dim>(scene, {1., 0.01});
      EXPECT_LT(this->template expect_solution<1>(scene, {1., 0.}), 40u);
      EXPECT_LT(this->template expect_solution<dim>(scene, {1., 0.01}), 60u);
      this->template expect_solution<dim>(scene, {1., 1.});
    }
}

TYPED_TEST(SymmetricGaussSeidelOf, UnitsDoNotMatter)
{
  constexpr int      dim    = TypeParam::value;
  Scene<dim>         scene  = make_boxes<dim>(1, 2);
  const unsigned int before = this->template expect_solution<dim>(scene, {1., 0.01});
  for (const double unit : {1e-140, 1e140})
    {
      scene.bodies[0].material.youngs_modulus = 3. * unit;
      scene.bodies[0].material.density        = 2. * unit;
      EXPECT_NEAR(this->template expect_solution<dim>(scene, {1., 0.01}), before, 1.);
    }
}

TYPED_TEST(SymmetricGaussSeidelOf, OneProcessMayHaveAllOfTheSmallCells)
{
  // All processes have to agree about scales, norms, and when to stop.
  constexpr int dim            = TypeParam::value;
  Scene<dim>    scene          = make_boxes<dim>(1, 2, true);
  scene.bodies[0].refine_where = dim == 2 ? "0.5 - x - y" : "0.5 - x - y - z";
  for (const unsigned int refinements : {1, 3})
    {
      scene.bodies[0].local_refinements = refinements;
      EXPECT_LT(this->template expect_solution<1>(scene, {1., 0.}), 60u);
      EXPECT_LT(this->template expect_solution<dim>(scene, {1., 0.001}), 120u);
    }
}

TYPED_TEST(SymmetricGaussSeidelOf, ReleasedNodesAreAsIfTheyHadNeverBeenHeld)
{
  constexpr int                dim = TypeParam::value;
  const SmallBody<dim>         body(make_boxes<dim>(1, 1), MPI_COMM_WORLD);
  const Vector                 x = body.some_vector(0.);
  Vector                       before(x), meanwhile(x), after(x);
  SymmetricGaussSeidel<dim, 1> sweeps(body.matrices, {1., 0.});
  sweeps.vmult(before, x);
  sweeps.set_held_nodes(hold_face(body));
  sweeps.vmult(meanwhile, x);
  sweeps.set_held_nodes({});
  sweeps.vmult(after, x);
  after -= before;
  meanwhile -= before;
  EXPECT_EQ(after.linfty_norm(), 0.);
  EXPECT_GT(meanwhile.linfty_norm(), 0.01 * before.linfty_norm());
}

TYPED_TEST(SymmetricGaussSeidelOf, ProcessesChangeTheOrderOnly)
{
  constexpr int dim        = TypeParam::value;
  const auto    iterations = [](const MPI_Comm communicator) {
    const SmallBody<dim>   body(make_boxes<dim>(1, 3), communicator);
    const MatrixSum        sum{1., 0.05};
    const Sweeps<dim, dim> P(body, sum, {});
    const Sum<dim>         K(body.matrices, sum);
    const Vector           b = body.some_vector(0.);
    Vector                 x(b), residual(b);
    x = 0.;
    ConjugateGradients gradients;
    return gradients.solve(K, P, x, residual, 1e-10 * P.sweeps.start(b), 0., 1000).iterations;
  };
  const unsigned int alone = iterations(MPI_COMM_SELF), together = iterations(MPI_COMM_WORLD);
  EXPECT_GT(alone, 5u);
  EXPECT_LE(together, alone + alone / 2);
}

TYPED_TEST(SymmetricGaussSeidelOf, BodiesApartAreSolvedApart)
{
  // Three bodies, of which nothing happens to the first, and little to the last: each is solved as
  // if it were alone, and what they all need is left out of the sweeps over the others.
  constexpr int                dim = TypeParam::value;
  const MatrixSum              sum{1., 0.05};
  const SmallBody<dim>         bodies(make_boxes<dim>(3, 2), MPI_COMM_WORLD);
  const Sweeps<dim, dim>       P(bodies, sum, {});
  Vector                       x = bodies.some_vector(0.), b(x), found(x);
  std::array<std::string, dim> amplitude;
  amplitude.fill("(x > 2.5)*((x < 5.5) + 1e-4*(x > 5.5))");
  const Vector amplitudes = bodies.field(amplitude);
  x.scale(amplitudes);
  Sum<dim>(bodies.matrices, sum).vmult(b, x);
  P.sweeps.start(b);
  const auto report = P.sweeps.solve(found, 1e-5, 1000);
  EXPECT_TRUE(report.reached);
  EXPECT_GT(report.saved_iterations, 1.2 / 3. * report.iterations);
  EXPECT_LT(report.saved_iterations, 2. / 3. * report.iterations);
  for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
    if (amplitudes.local_element(i) == 0.)
      {
        EXPECT_EQ(found.local_element(i), 0.);
      }
  found -= x;
  EXPECT_LT(found.l2_norm(), 1e-3 * x.l2_norm());

  // A single body with the same motion takes as many iterations.
  const SmallBody<dim>   one(make_boxes<dim>(1, 2), MPI_COMM_WORLD);
  const Sweeps<dim, dim> Q(one, sum, {});
  const Vector           y = one.some_vector(0.);
  Vector                 c(y), found_alone(y);
  Sum<dim>(one.matrices, sum).vmult(c, y);
  Q.sweeps.start(c);
  const auto alone = Q.sweeps.solve(found_alone, 1e-5, 1000);
  EXPECT_EQ(alone.saved_iterations, 0.);
  EXPECT_NEAR(report.iterations, alone.iterations, 2.);
}
