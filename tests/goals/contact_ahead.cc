// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Cells ahead of contact have to become as fine as the finest that are in contact, and the sooner
// the more levels they lack: in the plane each level counts twice.

#include <signorini/goals/contact_ahead.h>

#include "box_of_cells.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

TEST(ContactAhead, IsAsFineAsContact)
{
  const Box          box;
  const unsigned int n = box.mesh.triangulation().n_active_cells();
  EXPECT_EQ(contact_ahead(box.mesh, std::vector<bool>(n)).distance, 0.) << "nothing touches";

  std::vector<bool> in_contact(n);
  for (const auto &cell : box.mesh.active_cells())
    in_contact[cell->active_cell_index()] = cell->is_locally_owned() && cell->center()[1] < 0.1;
  const ContactAhead ahead = contact_ahead(box.mesh, in_contact);
  ASSERT_EQ(ahead.levels.size(), 1u);
  EXPECT_EQ(ahead.levels[0], 3u);
  for (const auto &cell : box.mesh.active_cells())
    {
      if (!cell->is_locally_owned())
        continue;
      EXPECT_NEAR(ahead.distance, 0.25 * cell->diameter() / std::sqrt(2.), 1e-14);
      EXPECT_EQ(ahead.lacking(cell), 0u);
    }
  const auto &coarse = box.mesh.triangulation().begin(1);
  EXPECT_EQ(ahead.lacking(coarse), 2u);
}


TEST(ContactAhead, IsRefinedTheSoonerTheCoarser)
{
  const ContactAhead as_it_is{1., {3}};
  ContactAhead       graded = as_it_is;
  graded.grading            = 2.;
  for (unsigned int lacking = 0; lacking < 4; ++lacking)
    {
      EXPECT_EQ(as_it_is.weigh(0.1, lacking), 0.1);
      EXPECT_NEAR(graded.weigh(0.1, lacking), 0.1 * (1 << lacking), 1e-15);
      EXPECT_GE(graded.weigh(graded.least_closeness(), 20), graded.far_enough)
        << "what is less close counts for nothing";
    }
}
