// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What the enhanced element is for:
//
// - a cantilever, 20 times as long as thick, has the deflection of theory (bending and shear) with
//   two cells in its thickness, and with one, also where its material is hardly compressible. What
//   is missing there is the effect of the clamp, which theory leaves out.
// - A flow without change of volume as displacement has errors of second order, on distorted cells,
//   too, and near incompressibility they are no larger. The standard element has nothing left of
//   the displacement there, and mean dilatation, which bends too softly, has these errors, too.

#include "direct_solution.h"
#include "distorted.h"

#include <signorini/discretization/loads.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** Deflection of the end over that of theory. */
  template <int dim>
  double deflection(const ElementKind  element,
                    const double       poissons_ratio,
                    const unsigned int cells_in_thickness)
  {
    constexpr double     length = 20.;
    BodyDescription<dim> body   = box_of<dim>(element, poissons_ratio);
    box_of(body).repetitions.fill(cells_in_thickness);
    box_of(body).upper_corner[0] = length;
    box_of(body).repetitions[0] *= length;
    body.traction.resize(1);
    body.traction[0].boundary_id          = 1;
    body.traction[0].expressions[dim - 1] = "1"; // the end has the area 1
    const Assembled<dim> beam(body);
    const auto          &discretization = beam.discretization;
    Loads<dim>           loads(discretization);
    const Vector         none = discretization.make_vector();
    const Vector         u    = direct_solution<dim>(
      discretization, loads.at(0.), none, [](const auto &place) { return place[0] < 1e-10; });
    const Material &material = body.material;
    const double E = material.youngs_modulus / (dim == 2 ? 1. - std::pow(poissons_ratio, 2) : 1.);
    const double theory = 4. * std::pow(length, 3) / E + length / (5. / 6. * material.mu());
    return u * loads.at(0.) / theory;
  }

  template <int dim>
  void expect_deflection_of_theory()
  {
    const ElementKind by_default = BodyDescription<dim>().element;
    for (const double nu : {0.3, 0.49, 0.4999})
      {
        EXPECT_GT(deflection<dim>(by_default, nu, 1), 0.97) << nu;
        EXPECT_LT(deflection<dim>(by_default, nu, 1), 1.005) << nu;
        EXPECT_GT(deflection<dim>(by_default, nu, 2), 0.97) << nu;
        EXPECT_LT(deflection<dim>(by_default, nu, 2), 1.005) << nu;
      }
  }

  /**
   * Relative error of the displacement curl psi, psi = sin^2(pi x) sin^2(pi y), in the norm of the
   * mass; in space the same in every plane.
   */
  template <int dim>
  double error_of_flow(const ElementKind  element,
                       const double       poissons_ratio,
                       const unsigned int refinements)
  {
    BodyDescription<dim> body = box_of<dim>(element, poissons_ratio);
    body.refinements          = refinements;
    // f = -mu/rho Laplace u
    const double factor =
      std::pow(dealii::numbers::PI, 3) * 2. * body.material.mu() / body.material.density;
    const std::string            c = std::to_string(factor);
    std::array<std::string, dim> exact;
    exact.fill("0");
    exact[0]           = "pi*sin(pi*x)^2*sin(2*pi*y)";
    exact[1]           = "-pi*sin(2*pi*x)*sin(pi*y)^2";
    body.body_force[0] = c + "*(2*sin(pi*x)^2 - cos(2*pi*x))*sin(2*pi*y)";
    body.body_force[1] = c + "*(cos(2*pi*y) - 2*sin(pi*y)^2)*sin(2*pi*x)";
    const Distorted<dim> box(body, 0.15);
    const auto          &discretization = box.discretization;
    Loads<dim>           loads(discretization);
    const Vector         u = field<dim>(discretization, exact);
    Vector error = direct_solution<dim>(discretization, loads.at(0.), u, [](const auto &place) {
      return !inside_unit_box<dim>(place);
    });
    error -= u;
    return std::sqrt(error * mass_times(discretization, error)
                     / (u * mass_times(discretization, u)));
  }
} // namespace

TEST(Locking, CantileverHasTheDeflectionOfTheory)
{
  expect_deflection_of_theory<2>();
  expect_deflection_of_theory<3>();
}

// The figures of an independent program; the reason for the other elements.
TEST(Locking, OfTheStandardElement)
{
  EXPECT_NEAR(deflection<2>(ElementKind::standard, 0.3, 1), 0.635, 1e-3);
  EXPECT_NEAR(deflection<2>(ElementKind::standard, 0.3, 2), 0.871, 1e-3);
  EXPECT_NEAR(deflection<2>(ElementKind::standard, 0.49, 2), 0.241, 1e-3);
  EXPECT_NEAR(deflection<2>(ElementKind::standard, 0.4999, 2), 0.006, 1e-3);
}

TEST(Locking, OrderOfConvergence)
{
  for (const ElementKind element : all_elements)
    for (const double nu : {0.3, 0.4999})
      {
        if (element == ElementKind::standard && nu > 0.4)
          continue;
        const double coarse = error_of_flow<2>(element, nu, 2),
                     fine   = error_of_flow<2>(element, nu, 3);
        EXPECT_GT(std::log2(coarse / fine), 1.7) << name_of(element) << ' ' << nu;
        EXPECT_LT(fine, 0.03) << name_of(element) << ' ' << nu;
      }
  EXPECT_GT(error_of_flow<2>(ElementKind::standard, 0.4999, 3), 0.5);
  EXPECT_GT(std::log2(error_of_flow<3>(ElementKind::enhanced, 0.4999, 1)
                      / error_of_flow<3>(ElementKind::enhanced, 0.4999, 2)),
            1.5);
}
