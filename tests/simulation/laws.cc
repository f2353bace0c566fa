// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Steps of a scheme keep all laws that it proves, far below the limits of the guard; a step that is
// broken on purpose breaks just the law that it should, and a run with such a step stops there with
// a diagnosis, its state written, unless the scene says that it shall go on.

#include "small_run.h"

#include <signorini/base/user_error.h>
#include <signorini/schemes/contact_stabilized_newmark.h>
#include <signorini/simulation/law_watch.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** What is done to a step. */
  using Mischief = std::function<void(State &, StepReport &)>;

  /** Makes one of its steps, the eighth, in contact and slipping, worse than it was. */
  class BrokenScheme : public TimeScheme
  {
  public:
    explicit BrokenScheme(Mischief mischief)
      : mischief(std::move(mischief))
    {
    }

    TakenStep
    make_step(DynamicalSystem &system, const State &start, const double step_size) override
    {
      TakenStep step = scheme.make_step(system, start, step_size);
      if (step.state.step == 8)
        mischief(step.state, step.report);
      return step;
    }

    Needs needs() const override { return scheme.needs(); }

  private:
    ContactStabilizedNewmark scheme{true, TrapezoidalRule(1.)};
    const Mischief           mischief;
  };

  void shift_down(State &state)
  {
    for (unsigned int i = 1; i < state.displacement.locally_owned_size(); i += 2)
      state.displacement.local_element(i) -= 1e-4;
  }

  /** Each law with a step that breaks it, and words of its diagnosis. */
  struct Crime
  {
    Law         law;
    Mischief    mischief;
    const char *words;
  };

  const std::vector<Crime> crimes = {
    {Law::no_gain,
     [](State &, StepReport &report) {
       // more than predictor and friction have taken
       report.work_contact = 1e-4 - report.work_predictor - report.work_friction;
     },
     "have added energy"},
    {Law::energy_identity,
     [](State &state, StepReport &) { state.velocity *= 1.001; },
     "do not explain its change of energy"},
    {Law::no_adhesion,
     [](State &state, StepReport &) { state.contact_force *= -1.; },
     "pulled instead of pressed"},
    {Law::coulomb,
     [](State &state, StepReport &) { state.friction.force *= 1.01; },
     "exceeds its bound"},
    {Law::no_penetration,
     [](State &state, StepReport &) { shift_down(state); },
     "inside of what it touches"},
    {Law::momentum,
     [](State &state, StepReport &) { state.momentum *= 1.001; },
     "change of its momentum"}};

  std::vector<Override> with_friction(const std::string &guard)
  {
    return {{"Time/Scheme", "contact-stabilized"},
            {"Contact/box[2] : floor/Friction coefficient", "0.2"},
            {"Contact/Motion", "linearised"},
            {"Bodies/box/Initial velocity", "1; -2"},
            {"Output/Guard", guard}};
  }

  /** The violations of all laws in the eighth step. */
  LawReading reading_of(const Mischief &mischief)
  {
    SmallRun            run(with_friction("stop"));
    const Scene<2>     &scene = run.scene();
    std::ostringstream  table;
    dealii::TimerOutput timer(
      MPI_COMM_SELF, table, dealii::TimerOutput::never, dealii::TimerOutput::wall_times);
    Mesh<2>        mesh(scene.bodies, MPI_COMM_WORLD);
    MeshedScene<2> meshed(mesh, scene, scene.time.n_steps(), timer);
    State          state = initial_state(meshed.discretization);
    meshed.system.apply_mass(state.momentum, state.velocity);
    meshed.system.apply_stiffness(state.internal_force, state.displacement);
    meshed.system.see({8., 8.});
    EnergyLedger ledger;
    ledger.open(state, nullptr);
    LawWatch<2> watch(scene);
    watch.start(meshed, BodyMotion<2>(meshed.discretization), state);
    BrokenScheme scheme(mischief);
    LawReading   reading;
    while (state.step < 8)
      {
        StepReport report = scheme.advance(meshed.system, state, scene.time.step_size);
        report.step_size  = scene.time.step_size;
        reading           = watch.read(state,
                             report,
                             ledger.book(state, report, nullptr),
                             contact_summary(meshed.surface, meshed.discretization, state),
                             10.);
      }
    return reading;
  }
} // namespace

TEST(Laws, AreKept)
{
  const LawReading reading = reading_of([](State &state, StepReport &) {
    double force = 0.;
    for (const double f : state.friction.force)
      force = std::max(force, std::abs(f));
    EXPECT_GT(dealii::Utilities::MPI::max(force, MPI_COMM_WORLD), 0.) << "there is no friction";
  });
  for (const double violation : reading.violation)
    EXPECT_LT(violation, 1e-9);
}

TEST(Laws, EachIsFoundBroken)
{
  for (const Crime &crime : crimes)
    {
      const LawReading reading = reading_of(crime.mischief);
      LawGuard         guard("any", std::set<Law>(all_laws.begin(), all_laws.end()), 2e-11);
      bool             found = false;
      for (const std::string &diagnosis : guard.judge(reading))
        found = found || diagnosis.find(crime.words) != std::string::npos;
      EXPECT_TRUE(found) << crime.words;
    }
}

TEST(Laws, ARunStopsAtABrokenOne)
{
  for (const Crime &crime : crimes)
    {
      SmallRun run(with_friction("stop"));
      try
        {
          run.run(std::make_unique<BrokenScheme>(crime.mischief));
          ADD_FAILURE() << "no diagnosis: " << crime.words;
        }
      catch (const RunError &error)
        {
          EXPECT_NE(std::string(error.what()).find("a law is broken"), std::string::npos);
          EXPECT_EQ(run.column("step").back(), 8.);
          EXPECT_NEAR(run.times_of_fields().back(), 0.08, 1e-9) << "the state is not written";
        }
      MPI_Barrier(MPI_COMM_WORLD);
    }
}

TEST(Laws, ARunGoesOnIfItShall)
{
  SmallRun run(with_friction("warn"));
  run.run(std::make_unique<BrokenScheme>(crimes[0].mischief));
  EXPECT_EQ(run.column("step").back(), 10.);
  EXPECT_NE(run.text("log.txt").find("warning: at time 0.08 a law is broken"), std::string::npos);
}
