// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Two blocks with matching meshes and friction, all relative entries of which are held, are one
// block: every preconditioner finds the solution of the single block, and the incomplete factor,
// which holds these entries within its sweeps, does it in as many iterations.

#include "two_bodies.h"

#include <signorini/preconditioners/preconditioners.h>
#include <signorini/preconditioners/step_operator.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  BodyDescription<3>
  part(const std::string &name, const double lower, const double upper, const unsigned int layers)
  {
    return block<3>(name, {0., 0., lower}, {1., 1., upper}, {{4, 3, layers}});
  }

  Scene<3> tied()
  {
    Scene<3> scene          = stacked<3>(part("upper", 0., 1., 4), part("lower", -1., 0., 4));
    scene.pairs[0].friction = {FrictionKind::coulomb, "0.3", "", true};
    return scene;
  }

  struct Solution
  {
    std::vector<double> products; ///< with some fields, weighted with the mass
    unsigned int        iterations;
  };

  /** Of (a M + b A) u = M f with relative entries zero. */
  Solution solve(const Discretization<3>     &discretization,
                 const ContactCoordinates<3> &coordinates,
                 const std::string           &preconditioner_name,
                 const double                 mass_factor,
                 const double                 stiffness_factor)
  {
    const auto           &matrices = discretization.matrices();
    const StepOperator<3> matrix(matrices, coordinates, {mass_factor, stiffness_factor});
    const auto            preconditioner =
      preconditioner_name == "mass"
                   ? make_mass_preconditioner(matrices, coordinates)
                   : make_preconditioner(*value_named<PreconditionerKind>(preconditioner_name),
                              matrices,
                              coordinates,
                              {mass_factor, stiffness_factor});
    const std::vector<std::array<std::string, 3>> fields{
      {{"sin(3*x) + z", "y*z", "cos(2*z + x)"}}, {{"1", "z", "x"}}, {{"z*z", "y", "sin(4*z)"}}};
    Vector force = mass_times(discretization, field<3>(discretization, fields[0])),
           u = discretization.make_vector(), residual = u;
    coordinates.force_to_contact(force);
    ActiveSet           none;
    PrimalDualActiveSet solver({50, 10000});
    const auto         &tied_entries = coordinates.relative_entries();
    const auto          report       = solver.solve({matrix,
                                                     *preconditioner,
                                                     force,
                                                     {},
                                                     {},
                                                     tied_entries,
                                                     std::vector<double>(tied_entries.size(), 0.),
                                                     1e-10,
                                                     0.},
                                     none,
                                     u,
                                     residual);
    coordinates.displacement_to_cartesian(u);
    Solution   result{{}, report.linear_iterations};
    const auto weighted = mass_times(discretization, u);
    for (const auto &expressions : fields)
      result.products.push_back(field<3>(discretization, expressions) * weighted);
    return result;
  }

  void expect_one_block(const std::string &preconditioner,
                        const double       stiffness_factor,
                        const double       angle)
  {
    SCOPED_TRACE(preconditioner + " at " + std::to_string(angle));
    const TwoBodies<3>           bodies(tied(), turn<3>(angle));
    const MappedAssembled<3>     block(scene_of<3>({part("block", -1., 1., 8)}), turn<3>(angle));
    const DirichletConditions<3> dirichlet(block.discretization);
    const ContactSurface<3>      surface(block.discretization, dirichlet, {}, {});
    const ContactCoordinates<3>  coordinates(block.discretization, surface, dirichlet);
    const Solution               found = solve(bodies.discretization,
                                 bodies.coordinates,
                                 preconditioner,
                                 1.,
                                 stiffness_factor),
                   expected =
                     solve(block.discretization, coordinates, preconditioner, 1., stiffness_factor);
    for (unsigned int k = 0; k < expected.products.size(); ++k)
      EXPECT_NEAR(found.products[k], expected.products[k], 1e-9) << k;
    EXPECT_GT(std::abs(expected.products[0]), 0.01);
    if (preconditioner == "incomplete-cholesky")
      {
        EXPECT_LE(found.iterations, expected.iterations + 2);
      }
  }
} // namespace

TEST(TiedBodies, AreOneBlock)
{
  for (const double angle : {0., 0.7})
    {
      for (const std::string preconditioner :
           {"jacobi", "symmetric-gauss-seidel", "incomplete-cholesky", "ml"})
        expect_one_block(preconditioner, 0.01, angle);
      expect_one_block("mass", 0., angle);
    }
}
