// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A run warns about what locks, and about nothing else: slender bodies with one or two standard
// cells in their thickness, in any direction and with faces counted in any order, and standard
// cells of a hardly compressible material.

#include "../shapes/shape_of.h"

#include <signorini/simulation/element_warnings.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  BodyDescription<3> plate(const unsigned int cells_in_thickness, const ElementKind element)
  {
    BodyDescription<3> body;
    body.name                 = "plate";
    box_of(body).upper_corner = {6., 1., 6.};
    box_of(body).repetitions  = {{6, cells_in_thickness, 6}};
    body.element              = element;
    return body;
  }

  std::string warnings(const std::vector<BodyDescription<3>> &bodies)
  {
    std::string all;
    for (const std::string &warning : element_warnings(Mesh<3>(bodies, MPI_COMM_WORLD)))
      all += warning + "\n";
    return all;
  }

  bool warns(const BodyDescription<3> &body)
  {
    return !warnings({body}).empty();
  }
} // namespace

TEST(ElementWarnings, OfAThicknessThatIsNotResolved)
{
  EXPECT_TRUE(warns(plate(1, ElementKind::standard)));
  EXPECT_TRUE(warns(plate(2, ElementKind::standard)));
  EXPECT_TRUE(warns(plate(2, ElementKind::mean_dilatation)));
  EXPECT_FALSE(warns(plate(3, ElementKind::standard)));
  EXPECT_FALSE(warns(plate(1, ElementKind::enhanced)));

  BodyDescription<3> refined = plate(1, ElementKind::standard);
  refined.refinements        = 1;
  EXPECT_TRUE(warns(refined));
  refined.refinements = 2;
  EXPECT_FALSE(warns(refined));

  BodyDescription<3> block   = plate(1, ElementKind::standard);
  box_of(block).upper_corner = {4., 1., 4.};
  EXPECT_FALSE(warns(block)) << "not slender";
}

TEST(ElementWarnings, NameTheBody)
{
  BodyDescription<3> other      = plate(1, ElementKind::enhanced);
  other.name                    = "other";
  box_of(other).lower_corner[1] = 2.;
  box_of(other).upper_corner[1] = 3.;
  const std::string text        = warnings({plate(1, ElementKind::standard), other});
  EXPECT_NE(text.find("body 'plate' has one or two cells"), std::string::npos) << text;
  EXPECT_EQ(text.find("other"), std::string::npos) << text;
}

TEST(ElementWarnings, OfNearIncompressibility)
{
  BodyDescription<3> ball;
  ball.name                    = "ball";
  ball.shape                   = std::make_shared<BallShape<3>>();
  ball.refinements             = 1;
  ball.material.poissons_ratio = 0.46;
  EXPECT_FALSE(warns(ball));
  ball.element = ElementKind::standard;
  EXPECT_NE(warnings({ball}).find("nearly incompressible"), std::string::npos);
  ball.material.poissons_ratio = 0.4;
  EXPECT_FALSE(warns(ball));
}
