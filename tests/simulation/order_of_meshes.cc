// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// When the mesh changes: before the first row, as far as the start wants it; after a step, for the
// next one; with repetitions before the row of the step that asked for it, which is then made again
// and written once. What the change does to the energy is in the row after it, so that the rows
// explain every change of the energy. A change that fails leaves nothing that looks like a state.

#include "../adaptivity/moving_mesh.h"
#include "small_run.h"

#include <signorini/base/user_error.h>

#include <functional>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** Cells near the floor get finer: four levels, because each change refines once. */
  std::vector<Override> adaptive(const std::string &distance, const std::string &repetitions)
  {
    return {{"Adaptivity/Indicator", "distance"},
            {"Adaptivity/Maximum level", "3"},
            {"Adaptivity/Distance", distance},
            {"Adaptivity/Steps between remeshings", "1"},
            {"Adaptivity/Repetitions", repetitions}};
  }

  unsigned int first_change(const std::vector<double> &cells)
  {
    unsigned int row = 1;
    while (row < cells.size() && cells[row] == cells[row - 1])
      ++row;
    return row;
  }

  void expect_explained_energies(const SmallRun &run)
  {
    std::vector<double> explained(run.column("time").size(), 0.);
    for (const std::string part : {"work_contact",
                                   "work_predictor",
                                   "work_friction",
                                   "work_scheme",
                                   "work_external",
                                   "energy_transfer",
                                   "energy_residual"})
      {
        const auto values = run.column(part);
        for (unsigned int n = 0; n < values.size(); ++n)
          explained[n] += values[n];
      }
    const auto energy = run.column("total_energy"), residual = run.column("energy_residual"),
               cells = run.column("cells"), transfer = run.column("energy_transfer");
    for (unsigned int n = 1; n < energy.size(); ++n)
      {
        EXPECT_NEAR(energy[n] - energy[n - 1], explained[n], 1e-13 * energy[0]) << n;
        EXPECT_LT(std::abs(residual[n]), 1e-10 * energy[0]) << n;
        if (cells[n] == cells[n - 1])
          {
            EXPECT_EQ(transfer[n], 0.) << n;
          }
      }
  }

  void expect_all_steps(const SmallRun &run, const unsigned int n_steps)
  {
    const auto step = run.column("step"), time = run.column("time");
    ASSERT_EQ(step.size(), n_steps + 1);
    for (unsigned int n = 0; n <= n_steps; ++n)
      {
        EXPECT_EQ(step[n], n);
        EXPECT_NEAR(time[n], 0.1 / n_steps * n, 1e-13);
      }
  }
} // namespace

TEST(OrderOfMeshes, TheStartIsWrittenOnAMeshThatIsFineEnough)
{
  SmallRun run(adaptive("0.2", "0"));
  run.run();
  const auto cells = run.column("cells");
  EXPECT_GT(cells[0], 4.);
  EXPECT_NEAR(run.column("kinetic_energy")[0], 4., 1e-11) << "the initial velocity on this mesh";
  expect_all_steps(run, 10);
  expect_explained_energies(run);
}

TEST(OrderOfMeshes, AStepThatAsksForAFinerMeshIsMadeAgainOnIt)
{
  SmallRun later(adaptive("0.03", "0")), again(adaptive("0.03", "1"));
  later.run();
  again.run();
  for (const SmallRun *run : {&later, &again})
    {
      EXPECT_EQ(run->column("cells")[0], 4.) << "nothing is near the floor";
      expect_all_steps(*run, 10);
      expect_explained_energies(*run);
    }
  const unsigned int after = first_change(later.column("cells"));
  ASSERT_LT(after, 10u);
  EXPECT_EQ(first_change(again.column("cells")), after - 1);
}

TEST(OrderOfMeshes, StepsOfControlledSizeCountOnce)
{
  std::vector<Override> overrides = adaptive("0.03", "1");
  overrides.insert(overrides.end(),
                   {{"Time/Step size control", "doubling"},
                    {"Time/Minimum step size", "2e-4"},
                    {"Time/Step tolerance", "1e-2"}});
  SmallRun run(overrides);
  run.run();
  const auto step = run.column("step"), time = run.column("time"), size = run.column("step_size");
  for (unsigned int n = 1; n < step.size(); ++n)
    {
      EXPECT_EQ(step[n], n);
      EXPECT_NEAR(time[n] - time[n - 1], size[n], 1e-14) << n;
    }
  EXPECT_EQ(time.back(), 0.1);
  EXPECT_LT(first_change(run.column("cells")), step.size()) << "the mesh shall change";
  expect_explained_energies(run);
  const std::string accepted = std::to_string(step.size() - 1) + " accepted";
  EXPECT_NE(run.text("log.txt").find(" " + accepted), std::string::npos) << run.text("log.txt");
}

TEST(OrderOfMeshes, AChangeThatFailsLeavesNoState)
{
  MovingMesh<2>               moving(contact_scene<2>(box<2>("box", 0.), {floor_at<2>(-1.)}));
  const std::function<void()> fail = [] { throw RunError("no memory for cells"); };
  moving.mesh.triangulation().signals.pre_distributed_refinement.connect(fail);
  EXPECT_THROW(moving.change(), RunError);
  EXPECT_EQ(moving.meshed, nullptr);
}
