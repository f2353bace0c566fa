// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The nodes without mass are in equilibrium with nodes that have mass, wherever these are: forces
// f - A u + r vanish there, r pushes along the normal and only where the gap is closed, and what
// has mass or a Dirichlet condition does not move. The problem is convex: any guess leads to the
// same solution.

#include "../mass/redistributed.h"

#include <signorini/system/massless_equilibrium.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  struct Resting : public Redistributed<dim>
  {
    explicit Resting(const Scene<dim> &scene)
      : Redistributed<dim>(scene, "zero")
      , coordinates(this->discretization, this->surface, this->dirichlet)
      , equilibrium(this->discretization, this->surface, coordinates, this->scene.solver)
      , is_massless(this->discretization.matrices().pattern.n_owned, false)
    {
      for (const unsigned int node : this->discretization.matrices().massless_nodes)
        is_massless[node] = true;
    }

    const ContactCoordinates<dim> coordinates;
    MasslessEquilibrium<dim>      equilibrium;
    std::vector<bool>             is_massless;
  };

  template <int dim>
  void expect_equilibrium(Resting<dim> &problem, const Vector &start, const Vector &load)
  {
    const auto  &discretization = problem.discretization;
    const double energy = start * stiffness_times(discretization, start), E = 500.;
    Vector       displacement = start, force;
    problem.equilibrium.solve(displacement, load, energy, force);

    Vector balance = load;
    balance -= stiffness_times(discretization, displacement);
    balance += force;
    problem.coordinates.force_to_contact(balance);
    std::vector<bool> is_held(discretization.locally_owned().n_elements(), false);
    for (const unsigned int entry : problem.coordinates.dirichlet_entries())
      is_held[entry] = true;
    Vector change = displacement;
    change -= start;
    problem.coordinates.displacement_to_contact(change);
    for (unsigned int i = 0; i < is_held.size(); ++i)
      if (problem.is_massless[i / dim] && !is_held[i])
        EXPECT_NEAR(balance.local_element(i), 0., 1e-10 * E);
      else
        EXPECT_NEAR(change.local_element(i), 0., problem.is_massless[i / dim] ? 1e-16 : 0.);

    Vector contact = force;
    problem.coordinates.force_to_contact(contact);
    const std::vector<double> gap    = problem.surface.normal_gap(displacement);
    unsigned int              closed = 0, open = 0;
    for (unsigned int k = 0; k < gap.size(); ++k)
      {
        double    &normal = contact.local_element(problem.coordinates.normal_entries()[k]);
        const bool pushes = normal < -1e-8 * E;
        EXPECT_GE(gap[k], -1e-13);
        EXPECT_LE(normal, 0.);
        EXPECT_LT(std::abs(gap[k] * normal), 1e-12 * E);
        ++(pushes ? closed : open);
        normal = 0.;
      }
    EXPECT_EQ(contact.linfty_norm(), 0.) << "forces along the normal of contact nodes only";
    EXPECT_GT(dealii::Utilities::MPI::sum(closed, MPI_COMM_WORLD), 0u);
    EXPECT_GT(dealii::Utilities::MPI::sum(open, MPI_COMM_WORLD), 0u);

    // From another guess, another active set, and when nothing is known about the energy.
    Vector shift = discretization.make_vector(), other_force;
    for (unsigned int i = 0; i < is_held.size(); ++i)
      if (problem.is_massless[i / dim] && !is_held[i])
        shift.local_element(i) = 0.3 * std::sin(7. * i);
    problem.coordinates.displacement_to_cartesian(shift);
    Vector other = start;
    other += shift;
    MasslessEquilibrium<dim>(
      discretization, problem.surface, problem.coordinates, problem.scene.solver)
      .solve(other, load, 0., other_force);
    other -= displacement;
    other_force -= force;
    EXPECT_LT(other.linfty_norm(), 1e-11);
    EXPECT_LT(other_force.linfty_norm(), 1e-9 * E);
  }

  /** Weight along all axes, of a size that bends the surface. */
  template <int dim>
  Vector some_load(const Discretization<dim> &discretization)
  {
    return irregular_field(discretization, 5.);
  }
} // namespace

TEST(MasslessEquilibrium, OfATiltedBoxOnAPlane)
{
  Resting<2> in_2d(box_on_floor<2>(4));
  expect_equilibrium(in_2d,
                     field<2>(in_2d.discretization, {{"0.1*y", "0.05 - 0.1*x + 0.02*y*y"}}),
                     some_load(in_2d.discretization));
  Resting<3> in_3d(box_on_floor<3>(3));
  expect_equilibrium(
    in_3d,
    field<3>(in_3d.discretization, {{"0.1*z", "0.02*z*z", "0.05 - 0.1*x + 0.04*y"}}),
    some_load(in_3d.discretization));
}

TEST(MasslessEquilibrium, OfABoxAlongAWall)
{
  Scene<2> scene            = box_on_floor<2>(4);
  scene.bodies[0].dirichlet = {{0, {{"0", "-"}}}};
  Resting<2> problem(scene);
  expect_equilibrium(problem,
                     field<2>(problem.discretization, {{"0.1*x*y", "0.05 - 0.1*x"}}),
                     some_load(problem.discretization));
}

TEST(MasslessEquilibrium, OfABallOnAPlane)
{
  Resting<3> problem(contact_scene<3>(ball<3>(2), {floor_at<3>(0.)}));
  expect_equilibrium(problem,
                     field<3>(problem.discretization, {{"0.1*z", "0", "-0.2"}}),
                     some_load(problem.discretization));
}
