// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The guard names each law when a step breaks it, once; it is silent below its limit and about laws
// that the scheme does not prove, and a violation that is not a number is none that is small.

#include <signorini/diagnostics/law_guard.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;

namespace
{
  const std::set<Law> everything(all_laws.begin(), all_laws.end());

  LawReading violation_of(const std::size_t law, const double size)
  {
    LawReading reading;
    reading.time           = 0.25;
    reading.violation[law] = size;
    return reading;
  }

  TEST(LawGuard, EachLawOnce)
  {
    std::set<std::string> diagnoses;
    for (std::size_t law = 0; law < all_laws.size(); ++law)
      {
        LawGuard     guard("contact-implicit", everything, 2e-11);
        const double limit = guard.limit(all_laws[law]);
        EXPECT_TRUE(guard.judge(violation_of(law, 0.9 * limit)).empty());
        const auto found = guard.judge(violation_of(law, 1.1 * limit));
        ASSERT_EQ(found.size(), 1u);
        for (const char *part : {"time 0.25", "contact-implicit", "Output/Guard = warn"})
          EXPECT_NE(found[0].find(part), std::string::npos) << found[0];
        diagnoses.insert(found[0]);
        EXPECT_TRUE(guard.judge(violation_of(law, 2. * limit)).empty()) << "said twice";
      }
    EXPECT_EQ(diagnoses.size(), all_laws.size()) << "two laws have the same diagnosis";
  }

  TEST(LawGuard, OnlyWhatIsProved)
  {
    LawGuard guard("newmark", {Law::no_adhesion}, 2e-11);
    for (std::size_t law = 0; law < all_laws.size(); ++law)
      EXPECT_EQ(guard.judge(violation_of(law, 1.)).size(),
                all_laws[law] == Law::no_adhesion ? 1u : 0u);
  }

  TEST(LawGuard, RoughSolversAreAllowedMore)
  {
    const LawGuard fine("newmark", everything, 2e-11), rough("newmark", everything, 1e-6);
    for (const Law law : all_laws)
      {
        EXPECT_LT(fine.limit(law), 1e-3);
        EXPECT_GT(rough.limit(law), 1e-3);
      }
  }

  // Half of the digits are stiffness at a Courant number of 1e4, but lengths have all of theirs.
  TEST(LawGuard, RoundOffOfForcesIsNoViolation)
  {
    LawGuard guard("newmark", everything, 2e-11);
    for (std::size_t law = 0; law < all_laws.size(); ++law)
      {
        LawReading reading = violation_of(law, 1e-4);
        reading.round_off  = 2e-16 * 1e8 * 100.;
        EXPECT_EQ(guard.judge(reading).size(), all_laws[law] == Law::no_penetration ? 1u : 0u);
      }
  }

  TEST(LawGuard, NoNumberIsNoSmallOne)
  {
    LawGuard guard("newmark", everything, 2e-11);
    EXPECT_EQ(guard.judge(violation_of(1, std::nan(""))).size(), 1u);
  }
} // namespace
