// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The error of the interpolated exact solution is zero, that of standing still is the norm of the
// exact solution, and the errors of all steps sum up in the square with equal weights.

#include "../discretization/bodies.h"

#include <signorini/diagnostics/error_norms.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** Unit square of mass 2 that moves with u = (3 t, 4 t). */
  Scene<2> moving_square()
  {
    Scene<2> scene       = scene_of<2>({box_with_hanging_nodes<2>()});
    scene.exact_solution = {true, {{"3*t", "4*t"}}, {{"3 + sin(x*y)*t", "4"}}};
    return scene;
  }

  State exact_state(const Assembled<2> &assembled, const double time)
  {
    State state;
    state.time = time;
    state.displacement =
      assembled.discretization.interpolate({assembled.scene.exact_solution.displacement}, time);
    state.velocity =
      assembled.discretization.interpolate({assembled.scene.exact_solution.velocity}, time);
    return state;
  }

  State resting_state(const Assembled<2> &assembled, const double time)
  {
    State state;
    state.time         = time;
    state.displacement = assembled.discretization.make_vector();
    state.velocity     = assembled.discretization.make_vector();
    return state;
  }
} // namespace

TEST(ErrorEvaluation, ExactFieldHasNone)
{
  const Assembled<2> assembled(moving_square());
  ErrorEvaluation<2> evaluation(assembled.scene.exact_solution);
  for (const double time : {0.5, 1., 2.})
    {
      const ErrorNorms errors =
        evaluation.evaluate(assembled.discretization, exact_state(assembled, time), 0.1);
      EXPECT_EQ(errors.displacement, 0.);
      EXPECT_EQ(errors.velocity, 0.);
      EXPECT_EQ(errors.relative_displacement, 0.);
      EXPECT_NEAR(errors.displacement_norm, 5. * time * std::sqrt(2.), 1e-12);
    }
}

TEST(ErrorEvaluation, NormIsThatOfTheMass)
{
  const Assembled<2> assembled(moving_square());
  ErrorEvaluation<2> evaluation(assembled.scene.exact_solution);
  State              state = exact_state(assembled, 1.);
  Vector             shift = field<2>(assembled.discretization, {{"0.1", "x"}});
  state.displacement += shift;
  EXPECT_NEAR(evaluation.evaluate(assembled.discretization, state, 0.1).displacement,
              std::sqrt(2. * (0.01 + 1. / 3.)),
              1e-13);
}

TEST(ErrorEvaluation, StepsSumUpInTheSquare)
{
  const Assembled<2> assembled(moving_square());
  ErrorEvaluation<2> evaluation(assembled.scene.exact_solution);
  const ErrorNorms   first =
    evaluation.evaluate(assembled.discretization, resting_state(assembled, 1.), 0.);
  EXPECT_NEAR(first.displacement, 5. * std::sqrt(2.), 1e-12);
  EXPECT_NEAR(first.relative_displacement, 1., 1e-14);
  EXPECT_NEAR(first.relative_velocity, 1., 1e-14);
  const ErrorNorms second =
    evaluation.evaluate(assembled.discretization, exact_state(assembled, 2.), 0.1);
  EXPECT_EQ(second.displacement, 0.);
  EXPECT_NEAR(second.relative_displacement, std::sqrt(1. / 5.), 1e-14)
    << "1^2 of 1^2 + 2^2, in the trapezoidal rule";
  const ErrorNorms third =
    evaluation.evaluate(assembled.discretization, resting_state(assembled, 1.), 0.3);
  EXPECT_NEAR(third.relative_displacement, std::sqrt((1. + 3.) / (5. + 15.)), 1e-14)
    << "three times as long a step";
}
