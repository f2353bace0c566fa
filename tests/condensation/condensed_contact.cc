// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Steps that are solved for the contact nodes alone have the solutions that iterations on all nodes
// find: the same nodes are closed, and the difference in the energy norm is what both may leave.
// That holds whatever the factor had been made for: nodes that come into contact later are taken
// in, and prescribed displacements, hanging nodes, friction and the other body count.

#include "../multigrid/level_problems.h"

#include <signorini/condensation/condensed_contact.h>
#include <signorini/preconditioners/preconditioners.h>
#include <signorini/variational_inequality/make_solver.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double tolerance = 1e-10; ///< of energy norms, in that of the solution

  template <int dim>
  struct Step : public LevelProblem<dim>
  {
    Step(const Scene<dim> &scene, const double courant_number, const double friction_coefficient)
      : LevelProblem<dim>(scene)
      , sum(this->step(courant_number))
      , product(this->matrices(), this->coordinates, sum)
      , preconditioner(make_preconditioner(PreconditionerKind::symmetric_gauss_seidel,
                                           this->matrices(),
                                           this->coordinates,
                                           sum))
      , with_friction(friction_coefficient > 0.)
      , solver(make())
      , condensed(this->matrices(), this->coordinates, sum, make())
    {
      if (with_friction)
        for (const auto &entries : this->coordinates.tangential_entries())
          friction.push_back({entries, {friction_coefficient}});
    }

    std::unique_ptr<ConstrainedSolver> make() const
    {
      return make_solver(with_friction, InequalityMethod::active_set, ActiveSetLimits());
    }

    /** Call action with a problem: all falls by a distance, disturbed, and bounds are gaps. */
    template <typename Action>
    void with_problem(const double distance, const Action &action)
    {
      Vector fall = irregular_field(this->discretization, 4.);
      fall *= 0.05 * distance;
      for (unsigned int i = dim - 1; i < fall.locally_owned_size(); i += dim)
        if (!this->matrices().pattern.is_empty(i / dim))
          fall.local_element(i) -= distance;
      Vector force(fall);
      this->matrices().apply_mass(force, fall);
      this->coordinates.force_to_contact(force);
      std::vector<double> bounds, prescribed(this->coordinates.dirichlet_entries().size());
      for (const ContactNode<dim> &node : this->surface.nodes())
        bounds.push_back(node.gap);
      for (std::size_t j = 0; j < prescribed.size(); ++j)
        prescribed[j] = 0.1 * distance * std::sin(1. + j);

      const double             size = std::sqrt(fall * force);
      const ConstrainedProblem problem{product,
                                       *preconditioner,
                                       force,
                                       this->coordinates.normal_entries(),
                                       bounds,
                                       this->coordinates.dirichlet_entries(),
                                       prescribed,
                                       0.1 * tolerance * size,
                                       1e-12,
                                       friction};
      action(problem, size);
    }

    /** In the norm of K. */
    double norm(const Vector &x) const
    {
      Vector forces(x);
      product.vmult(forces, x);
      return std::sqrt(std::abs(forces * x));
    }

    /** @return how many nodes are closed */
    unsigned int expect_agreement(const double distance)
    {
      unsigned int n_closed = 0;
      with_problem(distance, [&](const ConstrainedProblem &problem, const double size) {
        const Vector nothing = this->discretization.make_vector();
        Vector       x = nothing, x_of_all = nothing, residual = nothing, residual_of_all = nothing;
        ActiveSet    active(problem.upper_bounds.size(), 0), active_of_all = active;
        x = irregular_field(this->discretization, 3.); // any guess will do
        x *= 0.1 * distance;
        condensed.solve(problem, active, x, residual);
        solver->solve(problem, active_of_all, x_of_all, residual_of_all);

        EXPECT_EQ(active, active_of_all);
        Vector difference = x;
        difference -= x_of_all;
        EXPECT_LE(norm(difference), tolerance * size);
        const Vector &force = problem.right_hand_side;
        Vector        exact(force);
        product.vmult(exact, x);
        exact.sadd(-1., 1., force);
        exact -= residual;
        EXPECT_LE(exact.linfty_norm(), 1e-12 * force.linfty_norm()) << "the residual is b - K x";
        for (const char status : active)
          n_closed += contact_status::is_closed(status);
      });
      return n_closed;
    }

    /** What a second solution from the first one changes is the error of the first. */
    void expect_accuracy(const double distance)
    {
      with_problem(distance, [&](const ConstrainedProblem &problem, const double size) {
        Vector    x = this->discretization.make_vector(), residual = x;
        ActiveSet active(problem.upper_bounds.size(), 0);
        condensed.solve(problem, active, x, residual);
        Vector again = x;
        condensed.solve(problem, active, again, residual);
        again -= x;
        EXPECT_LE(norm(again), tolerance * size);
      });
    }

    const MatrixSum                       sum;
    StepOperator<dim>                     product;
    std::unique_ptr<MaskedPreconditioner> preconditioner;
    const bool                            with_friction;
    Friction                              friction;
    std::unique_ptr<ConstrainedSolver>    solver;
    CondensedContact<dim>                 condensed;
  };

  template <int dim>
  void expect_agreement(const Scene<dim>          &scene,
                        const std::vector<double> &distances,
                        const std::vector<double> &courant_numbers = {3., 30.})
  {
    for (const double courant_number : courant_numbers)
      for (const double friction_coefficient : {0., 0.3})
        {
          Step<dim>    step(scene, courant_number, friction_coefficient);
          unsigned int n_closed = 0;
          for (const double distance : distances)
            n_closed = step.expect_agreement(distance);
          EXPECT_GT(n_closed, 2U) << "nothing was tested";
        }
  }
} // namespace

TEST(CondensedContact, AgreesWithIterationsOnAllNodes)
{
  expect_agreement<2>(ball_on_floor<2>(4), {0.02, 0.1});
  expect_agreement<3>(ball_on_floor<3>(2), {0.05, 0.2});
  expect_agreement<2>(adaptive_box_on_floor<2>(), {0.1});
  expect_agreement<3>(adaptive_box_on_floor<3>(), {0.1});
}

TEST(CondensedContact, AgreesBetweenTwoBodies)
{
  expect_agreement<2>(blocks_on_each_other<2>(3, 10.), {0.1}, {3.});
}

TEST(CondensedContact, TakesInNodesThatCloseLater)
{
  Step<2>            step(ball_on_floor<2>(6), 2., 0.);
  const unsigned int few = step.expect_agreement(1e-4);
  EXPECT_EQ(step.condensed.n_factors(), 1U);
  const unsigned int many = step.expect_agreement(0.4);
  EXPECT_GT(many, few + 40);
  EXPECT_GT(step.condensed.n_factors(), 1U);
  const unsigned int before = step.condensed.n_factors();
  step.expect_agreement(1e-4);
  step.expect_agreement(0.4);
  EXPECT_EQ(step.condensed.n_factors(), before) << "the factor knows them all";
}

TEST(CondensedContact, IsAccurateInLongSteps)
{
  // One solution with the factor has an error of 2e-9 here.
  Step<2> step(ball_on_floor<2>(5), 1e5, 0.);
  step.expect_accuracy(0.1);
}
