// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Where nodes slip, sweeps solve with K + E: rows of tangential entries have Q x_t - q (K x)_n
// besides. What GMRES finds with them in single precision, and refinement in double precision, is
// the solution of exactly this system, on any number of processes: with a slip that is about to
// turn (Q a thousand times as large as K), one with negative curvature, and strong friction. Held
// nodes and slipping ones whose normal is free are among them.

#include <signorini/linear_algebra/refinement.h>
#include <signorini/sweeps/symmetric_gauss_seidel.h>

#include <gtest/gtest.h>

#include "../linear_algebra/held_nodes.h"

using namespace signorini;

namespace
{
  /** K + E in Cartesian components. */
  template <int dim>
  class SlipMatrix : public LinearOperator
  {
  public:
    SlipMatrix(const SmallBody<dim>             &body,
               const MatrixSum                  &sum,
               const std::vector<NodeSlip<dim>> &slipping)
      : body(body)
      , sum(sum)
      , slipping(slipping)
    {
    }
    void vmult(Vector &destination, const Vector &source) const override
    {
      body.matrices.apply(destination, source, sum);
      for (const NodeSlip<dim> &node : slipping)
        {
          dealii::Tensor<1, dim> x, row;
          for (unsigned int c = 0; c < dim; ++c)
            {
              x[c]   = source.local_element(dim * node.node + c);
              row[c] = destination.local_element(dim * node.node + c);
            }
          const auto change = node.stiffness * x - (node.normal * row) * node.coupling;
          for (unsigned int c = 0; c < dim; ++c)
            destination.local_element(dim * node.node + c) += change[c];
        }
    }
    void diagonal(Vector &) const override { FAIL() << "nobody needs it"; }

  private:
    const SmallBody<dim>             &body;
    const MatrixSum                   sum;
    const std::vector<NodeSlip<dim>> &slipping;
  };


  /** The owned nodes of the face x = 0 slip, in turned frames; some are not held. */
  template <int dim>
  struct SlippingFace
  {
    HeldNodes<dim>             held;
    std::vector<NodeSlip<dim>> slipping;

    /** @param turning, coupling the sizes of Q in terms of K, and of q */
    SlippingFace(const SmallBody<dim> &body,
                 const MatrixSum      &sum,
                 const double          turning,
                 const double          coupling)
    {
      const NodePattern &pattern = body.matrices.pattern;
      for (unsigned int node = 0; node < pattern.n_local; ++node)
        if (const auto &position = body.discretization.node_positions()[node];
            std::abs(position[0]) < 1e-12 && !body.is_hanging(node))
          {
            const auto held_node =
              held_in_turned_frame<dim>(node, 0.4 + position[1], first_direction<dim>());
            if (position[1] < 0.9)
              held.push_back(held_node);
            if (node >= pattern.n_owned || position[1] < 0.1)
              continue;
            NodeSlip<dim> slip{node, {}, {}, {}};
            const double size = body.matrices.combined_block(node, pattern.row_start[node], sum)[0];
            for (unsigned int c = 0; c < dim; ++c)
              slip.normal[c] = held_node.frame[c];
            const auto tangent = [&](const unsigned int row) {
              dealii::Tensor<1, dim> result;
              for (unsigned int c = 0; c < dim; ++c)
                result[c] = held_node.frame[dim * row + c];
              return result;
            };
            slip.coupling  = coupling * tangent(1);
            slip.stiffness = turning * size * outer_product(tangent(dim - 1), tangent(dim - 1));
            if (dim == 3) // not symmetric
              slip.stiffness += 0.2 * size * outer_product(tangent(1), tangent(2));
            slipping.push_back(slip);
          }
    }
  };


  /** Forces in held directions are not for single precision, see FactorCoordinates::to_factor(). */
  template <int dim>
  class WithoutHeldForces : public RoughSolver
  {
  public:
    WithoutHeldForces(const SymmetricGaussSeidel<dim, dim> &sweeps,
                      const HeldNodes<dim>                 &held,
                      const unsigned int                    n_owned)
      : sweeps(sweeps)
      , held(held)
      , n_owned(n_owned)
    {
    }
    double start(const Vector &residual) const override
    {
      return sweeps.start(free_part(held, n_owned, residual));
    }
    Report
    solve(Vector &correction, const double reduction, const unsigned int maximum) const override
    {
      return sweeps.solve(correction, reduction, maximum);
    }

  private:
    const SymmetricGaussSeidel<dim, dim> &sweeps;
    const HeldNodes<dim>                 &held;
    const unsigned int                    n_owned;
  };


  /** Refined to ten digits. @return iterations */
  template <int dim>
  unsigned int expect_solution(const double turning, const double coupling, const double unit = 1.)
  {
    Scene<dim> scene                        = make_boxes<dim>(1, 3);
    scene.bodies[0].material.youngs_modulus = 3. * unit;
    scene.bodies[0].material.density        = 2. * unit;
    const SmallBody<dim>           body(scene, MPI_COMM_WORLD);
    const MatrixSum                sum{1., 0.01};
    const SlippingFace<dim>        face(body, sum, turning, coupling);
    const SlipMatrix<dim>          matrix(body, sum, face.slipping);
    SymmetricGaussSeidel<dim, dim> sweeps(body.matrices, sum);
    sweeps.set_held_nodes(face.held);
    sweeps.set_slip(face.slipping);

    const Vector b = body.some_vector(0.);
    Vector       x(b), residual(b), rest(b);
    x                                    = 0.;
    const unsigned int           n_owned = body.matrices.pattern.n_owned;
    const WithoutHeldForces<dim> solver(sweeps, face.held, n_owned);
    const double                 norm = solver.start(b);
    const auto report = Refinement().solve(solver, matrix, x, residual, [&](double) {
      return SolverLimits{1e-10 * norm, 0., 1000, false};
    });
    EXPECT_TRUE(report.converged);
    // Judged without the sweeps: what is left acts on the held directions only.
    matrix.vmult(rest, x);
    rest -= b;
    rest = free_part(face.held, n_owned, rest);
    EXPECT_LT(rest.l2_norm(), 1e-8 * b.l2_norm()) << "Q " << turning << ", q " << coupling;
    EXPECT_GT(dealii::Utilities::MPI::sum(face.slipping.size(), MPI_COMM_WORLD), 2u);
    return report.iterations;
  }
} // namespace

template <typename Dim>
class SweepsWithSlip : public testing::Test
{
};

using SlipDimensions =
  testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SweepsWithSlip, SlipDimensions);

TYPED_TEST(SweepsWithSlip, SolveTheSystemOfTheLinearisedLaw)
{
  constexpr int      dim            = TypeParam::value;
  const unsigned int without        = expect_solution<dim>(0., 0.);
  const unsigned int with_friction  = expect_solution<dim>(0., 0.3);
  const unsigned int about_to_turn  = expect_solution<dim>(1000., 0.3);
  const unsigned int negative_parts = expect_solution<dim>(-0.2, 0.3);
  EXPECT_GT(without, 5u);
  for (const unsigned int n : {with_friction, about_to_turn, negative_parts})
    EXPECT_LT(n, 2 * without) << "with friction an iteration is worth as much";
  expect_solution<dim>(0., 2.);
}

TYPED_TEST(SweepsWithSlip, UnitsDoNotMatter)
{
  constexpr int      dim    = TypeParam::value;
  const unsigned int before = expect_solution<dim>(10., 0.3);
  for (const double unit : {1e-140, 1e140})
    EXPECT_NEAR((expect_solution<dim>(10., 0.3, unit)), before, 1.);
}

TYPED_TEST(SweepsWithSlip, NothingSlipsAnyMoreOnceOthersAreHeld)
{
  constexpr int                  dim = TypeParam::value;
  const SmallBody<dim>           body(make_boxes<dim>(1, 2), MPI_COMM_WORLD);
  const MatrixSum                sum{1., 0.01};
  const SlippingFace<dim>        face(body, sum, 1., 0.3);
  SymmetricGaussSeidel<dim, dim> sweeps(body.matrices, sum);
  const Vector                   b = body.some_vector(0.);
  Vector                         before(b), after(b);
  sweeps.set_held_nodes(face.held);
  sweeps.vmult(before, b);
  const double norm = sweeps.start(b);
  sweeps.set_slip(face.slipping);
  EXPECT_NE(sweeps.start(b), norm);
  sweeps.solve(after, 1e-3, 100);
  sweeps.set_held_nodes(face.held);
  sweeps.vmult(after, b);
  after -= before;
  EXPECT_EQ(after.linfty_norm(), 0.);
  EXPECT_EQ(sweeps.start(b), norm);
}
