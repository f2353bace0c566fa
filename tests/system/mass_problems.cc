// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Corrections of velocities and increments at contact nodes are solved for near them only. They
// must be those of the whole body, to the tolerance, wherever contact is and goes; zero far away,
// or nothing was saved; and a neighbourhood that is too small is noticed and becomes larger.

#include "../contact/contact_scene.h"

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/mass/mass_solver.h>
#include <signorini/system/mass_problems.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double accepted = 1e-11;

  /** A column of bricks on a floor, ten times as high as wide. */
  template <int dim>
  Scene<dim> column()
  {
    BodyDescription<dim> body = box<dim>();
    for (unsigned int d = 0; d < dim; ++d)
      {
        box_of(body).lower_corner[d] = 0.;
        box_of(body).upper_corner[d] = d + 1 < dim ? 1. : 10.;
        box_of(body).repetitions[d]  = d + 1 < dim ? 6 : 60;
      }
    body.refinements = 0;
    return contact_scene<dim>(body, {floor_at<dim>(0.)}, {2 * (dim - 1)});
  }

  template <int dim>
  struct Column : public ContactProblem<dim>
  {
    Column()
      : ContactProblem<dim>(column<dim>())
      , coordinates(this->discretization, this->surface, this->dirichlet)
      , timer(std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times)
      , problems(this->discretization, this->surface, coordinates, parameters(), {}, timer)
      , solver(this->discretization.matrices(), {})
    {
    }

    static SolverParameters parameters()
    {
      SolverParameters result;
      result.tolerance = accepted;
      return result;
    }

    /** The entry that the floor stops at a contact node. */
    unsigned int entry(const std::size_t contact_node) const
    {
      return coordinates.normal_entries()[contact_node] / dim * dim + dim - 1;
    }

    /** With values at some entries, the one that needs no force elsewhere. */
    Vector exact(const std::vector<unsigned int> &held, const Vector &values) const
    {
      const auto &matrices = this->discretization.matrices();
      Vector      force    = mass_times(this->discretization, values);
      force *= -1.;
      Vector result = MassSolver<dim>(matrices, held).solve(force);
      result += values;
      return result;
    }

    /** The error in the norm of the mass; far away the correction must be zero. */
    void expect(const Vector &correction, const Vector &expected)
    {
      Vector error = correction;
      error -= expected;
      EXPECT_LT(std::sqrt(error * mass_times(this->discretization, error)), 2. * accepted);
      std::array<std::string, dim> far;
      far.fill(dim == 2 ? "y > 7" : "z > 7");
      Vector above = field<dim>(this->discretization, far);
      above.scale(correction);
      EXPECT_EQ(above.linfty_norm(), 0.);
      EXPECT_GT(correction.linfty_norm(), 1e-3);
    }

    ContactCoordinates<dim> coordinates;
    dealii::TimerOutput     timer;
    MassProblems<dim>       problems;
    const MassSolver<dim>   solver;
  };

  template <int dim>
  std::array<std::string, dim> downwards(const std::string &speed)
  {
    std::array<std::string, dim> result;
    result.fill("0");
    result[dim - 1] = "-(" + speed + ")";
    return result;
  }

  /** Of a motion that would bring a few nodes below the floor. */
  template <int dim>
  void expect_projection(Column<dim> &column, const std::string &speed)
  {
    const Vector    free = field<dim>(column.discretization, downwards<dim>(speed));
    const NormalGap bounds(column.surface.nodes().size(), 0.);
    Vector          c, Mc;
    const auto      report = column.problems.project({free, bounds, 1., 2., false, false}, c, Mc);
    EXPECT_GT(report.n_active, 0u);

    std::vector<unsigned int> held;
    Vector                    values      = column.discretization.make_vector();
    const auto                is_held     = column.problems.held_by_projection();
    double                    least_force = 0.;
    for (std::size_t k = 0; k < is_held.size(); ++k)
      if (is_held[k])
        {
          held.push_back(column.entry(k));
          values.local_element(held.back()) = -free.local_element(held.back());
          least_force                       = std::min(least_force, Mc.local_element(held.back()));
        }
      else
        {
          EXPECT_GT(free.local_element(column.entry(k)) + c.local_element(column.entry(k)), -1e-11);
        }
    EXPECT_GT(least_force, -accepted);
    column.expect(c, column.exact(held, values));
  }

  /** Of some nodes of the lower side. */
  template <int dim>
  void expect_stopped(Column<dim> &column, const std::string &speed, const std::string &where)
  {
    const Vector velocity = field<dim>(column.discretization, downwards<dim>(speed)),
                 marked   = field<dim>(column.discretization, downwards<dim>(where));
    ActiveSet                 is_held(column.surface.nodes().size(), 0);
    std::vector<unsigned int> held;
    Vector                    values = column.discretization.make_vector();
    for (std::size_t k = 0; k < is_held.size(); ++k)
      if (marked.local_element(column.entry(k)) < -0.5)
        {
          is_held[k] = contact_status::slip;
          held.push_back(column.entry(k));
          values.local_element(held.back()) = -velocity.local_element(held.back());
        }
    Vector c, Mc;
    column.problems.stop_relative_motion(velocity, is_held, 2., c, Mc);
    column.expect(c, column.exact(held, values));
  }

  template <typename D>
  class MassNearContactOf : public testing::Test
  {
  };
  using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
  TYPED_TEST_SUITE(MassNearContactOf, Dimensions);
} // namespace

TYPED_TEST(MassNearContactOf, CorrectionsAreThoseOfTheWholeBody)
{
  Column<TypeParam::value> column;
  // At one edge, at the other one, everywhere, and a thousand times slower.
  expect_projection(column, "x < 0.3");
  expect_projection(column, "x > 0.7");
  expect_projection(column, "1 + 0.3*cos(5*x)");
  expect_projection(column, "0.001*(x < 0.3)*(1 + x)");
  expect_stopped(column, "1 + x", "x < 0.1");
  expect_stopped(column, "sin(7*x) + y", "1");
}

TYPED_TEST(MassNearContactOf, ToldTooLittleItNotices)
{
  constexpr int             dim = TypeParam::value;
  Column<dim>               column;
  const auto               &matrices = column.discretization.matrices();
  MassNearContact<dim>      near(matrices, column.coordinates);
  std::vector<unsigned int> held, nodes;
  Vector                    values = column.discretization.make_vector();
  for (std::size_t k = 0; k < column.surface.nodes().size(); ++k)
    {
      held.push_back(column.entry(k));
      nodes.push_back(held.back() / dim);
      values.local_element(held.back()) = 1.;
    }
  near.surround(nodes, 1.);
  const unsigned int first = near.number();
  near.surround(nodes, 1.);
  EXPECT_EQ(near.number(), first);

  // The exact solution within each neighbourhood, by conjugate gradients over all its entries.
  const Vector        expected = column.exact(held, values);
  std::vector<double> missed;
  for (unsigned int k = 0; k < 9; ++k)
    {
      Vector rest = expected;
      near.clear_outside(rest);
      rest -= expected; // minus what is outside
      const Vector of_rest = mass_times(column.discretization, rest);
      missed.push_back(std::sqrt(dot(rest, of_rest)));
      Vector residual = mass_times(column.discretization, expected);
      residual += of_rest;
      // What norm_outside() says is the error, up to a small factor.
      EXPECT_LT(missed.back(), 10. * near.norm_outside(residual) + 1e-15);
      EXPECT_GT(missed.back(), 0.05 * near.norm_outside(residual));
      near.widen();
    }
  for (unsigned int k = 1; k < missed.size(); ++k)
    EXPECT_LE(missed[k], missed[k - 1]);
  EXPECT_LT(missed.back(), 1e-5 * missed.front());
}

TEST(MassNearContactOfFewCells, ProcessesWithoutNodesTakePart)
{
  // Four cells are one family, which processes do not share; corrections that are far below what is
  // accepted need no neighbourhood at all, so that a part of the nodes is outside of it. Nobody may
  // wait for the process without nodes, nor go on without it.
  BodyDescription<2> body  = box<2>();
  box_of(body).repetitions = {{1, 1}};
  body.refinements         = 1;
  const ContactProblem<2>     problem(contact_scene<2>(body, {floor_at<2>(0.)}, {2}));
  const ContactCoordinates<2> coordinates(
    problem.discretization, problem.surface, problem.dirichlet);
  const auto               &matrices = problem.discretization.matrices();
  MassNearContact<2>        near(matrices, coordinates);
  std::vector<unsigned int> nodes;
  for (const unsigned int entry : coordinates.normal_entries())
    nodes.push_back(entry / 2);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    {
      EXPECT_EQ(dealii::Utilities::MPI::min(matrices.pattern.n_owned, MPI_COMM_WORLD), 0u);
    }
  const Vector residual =
    mass_times(problem.discretization, field<2>(problem.discretization, {{"1 + x", "y"}}));
  for (unsigned int k = 0; k < 3; ++k)
    {
      near.surround(nodes, 1e6);
      EXPECT_EQ(near.number(), 1u);
      EXPECT_GT(near.norm_outside(residual), 0.1);
    }
  unsigned int n_wider = 0;
  for (; near.norm_outside(residual) > 0. && n_wider < 20; ++n_wider)
    near.widen();
  EXPECT_LT(n_wider, 20u);
}
