// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// When steps are solved for contact nodes alone: in the plane, if the factor is used often enough.
// The order is the one that was measured (doc/performance.md); the edges are not tested.

#include <signorini/condensation/condensation_choice.h>

#include <gtest/gtest.h>

using namespace signorini;

TEST(CondensationChoice, IsForThePlane)
{
  CondensationCost cost{2, 10000, 10., {1e-3, 1000, false}, 200};
  EXPECT_TRUE(condensation_pays(cost));
  cost.dim = 3;
  EXPECT_FALSE(condensation_pays(cost));
  cost.dim            = 2;
  cost.courant_number = 0.5;
  EXPECT_FALSE(condensation_pays(cost)) << "a few iterations are enough";
  cost.courant_number = 10.;
  cost.n_dofs         = 10000000;
  EXPECT_FALSE(condensation_pays(cost)) << "for the memory";
  cost.n_dofs            = 10000;
  cost.n_contact_entries = 2000;
  EXPECT_FALSE(condensation_pays(cost)) << "the matrix that is left is full";
  cost.n_dofs = 1000000;
  EXPECT_TRUE(condensation_pays(cost)) << "beside a large one it is small";
  cost.n_dofs            = 10000;
  cost.n_contact_entries = 200;
  cost.n_parts           = 2;
  EXPECT_FALSE(condensation_pays(cost)) << "iterations leave out what nothing happens to";
}

TEST(CondensationChoice, PaysAfterFewerSolutionsWhereTheyAreDear)
{
  CondensationCost cost{2, 10000, 4., {1e-3, 20, false}, 200};
  EXPECT_FALSE(condensation_pays(cost));
  cost.use.with_friction = true;
  EXPECT_TRUE(condensation_pays(cost));
  cost.use.with_friction = false;
  cost.courant_number    = 100.;
  EXPECT_TRUE(condensation_pays(cost));
  cost.use.steps = 1;
  EXPECT_FALSE(condensation_pays(cost));
}
