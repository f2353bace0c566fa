// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/schemes/fixed_point.h>
#include <signorini/simulation/following_contact.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Times that a step is made again, and with what acceleration. */
    constexpr unsigned int most_repetitions = 24, few_differences = 3;
    /** Part of a mismatch; if a trial leaves more of the last one, full accuracy must help. */
    constexpr double slow = 0.5;
    /** Part of a mismatch; that a repetition leaves less cannot be relied on. */
    constexpr double lucky = 1e-3;
    /** Mismatch that a step must be expected to have, to be no trial any more. */
    constexpr double aim = 0.3;


    std::string which_step(const State &state, const double step_size)
    {
      std::ostringstream text;
      text << "the step from time " << state.time << " by " << step_size;
      return text.str();
    }


    /** A step, made with one set of normals after the other. */
    class RepeatedStep
    {
    public:
      RepeatedStep(TimeScheme      &scheme,
                   DynamicalSystem &system,
                   const State     &start,
                   double           step_size)
        : scheme(scheme)
        , system(system)
        , contact(*system.capabilities().moving_contact)
        , start(start)
        , step_size(step_size)
        , entries(contact.entries())
      {
        contact.begin_step(
          start, step_size, scheme.needs().statics ? StepNormals::at_end : StepNormals::of_motion);
      }

      ~RepeatedStep() { contact.let_steps_be_trials(false); }

      /**
       * Make the step with the normals of now. @param is_trial see
       * MovingContact::let_steps_be_trials()
       */
      void make(const bool is_trial)
      {
        latest.reset(); // its memory is for the next one
        contact.let_steps_be_trials(is_trial);
        latest.emplace(scheme.make_step(system, start, step_size));
        correctors.add(latest->report.corrector);
        predictors.add(latest->report.predictor);
        increment = latest->state.displacement;
        increment -= start.displacement;
        latest_mismatch = contact.mismatch(increment);
      }

      /**
       * Make it with the normals of its own motion until they agree.
       * @param difference of the latest step from what is wanted, at most 1 at the end
       * @return whether it came to that
       */
      bool repeat(const bool is_trial, const std::function<double()> &difference)
      {
        Vector motion = FixedPoint::make_unknowns(entries.size(), increment.get_mpi_communicator());
        copy_increment(motion);
        FixedPoint fixed_point(
          [&](const Vector &current, Vector &image) {
            follow(current);
            make(is_trial);
            copy_increment(image);
            return difference();
          },
          motion,
          {1., 1., most_repetitions});
        for (const unsigned int depth : {few_differences, 0U})
          if (!fixed_point.converged())
            fixed_point.run(depth);
        return fixed_point.converged();
      }

      /** MovingContact::mismatch() of the latest step. */
      double mismatch() const { return latest_mismatch; }

      bool passes_through() const { return contact.passes_through(increment); }

      TakenStep finish()
      {
        StepReport &report   = latest->report;
        report.corrector     = correctors;
        report.predictor     = predictors;
        report.work_geometry = contact.geometry_work(latest->state.contact_force);
        return std::move(*latest);
      }

    private:
      TimeScheme                      &scheme;
      DynamicalSystem                 &system;
      MovingContact                   &contact;
      const State                     &start;
      const double                     step_size;
      const std::vector<unsigned int> &entries; ///< on which normals depend
      std::optional<TakenStep>         latest;
      Vector                           increment;
      double                           latest_mismatch = 0.;
      SolveReport                      correctors, predictors;

      void follow(const Vector &motion_of_entries)
      {
        Vector motion = increment;
        for (std::size_t i = 0; i < entries.size(); ++i)
          motion.local_element(entries[i]) = motion_of_entries.local_element(i);
        contact.follow(motion);
      }

      void copy_increment(Vector &motion_of_entries) const
      {
        for (std::size_t i = 0; i < entries.size(); ++i)
          motion_of_entries.local_element(i) = increment.local_element(entries[i]);
      }
    };
  } // namespace


  TakenStep
  FollowingContact::make_step(DynamicalSystem &system, const State &start, const double step_size)
  {
    RepeatedStep step(*scheme, system, start, step_size);
    const bool   begins_with_trials = expects_repetitions;
    step.make(begins_with_trials);
    expects_repetitions = step.mismatch() > 1.;

    // Normals need no more digits than what they change has wrong. A step that is made again to
    // full accuracy should be the last one.
    double     before = step.mismatch();
    const auto shrink = [&] {
      const double ratio = step.mismatch() / before;
      contraction        = std::isfinite(ratio) ? std::clamp(ratio, lucky, slow) : slow;
      before             = step.mismatch();
    };
    if (begins_with_trials && before * contraction > aim)
      step.repeat(true, [&] {
        shrink();
        return contraction < slow ? before * contraction / aim : 0.;
      });

    const auto difference = [&] {
      shrink();
      return before;
    };
    if ((begins_with_trials || before > 1.) && !step.repeat(false, difference))
      throw StepError(which_step(start, step_size)
                      + " finds no motion that belongs to its own normals of contact. Take smaller "
                        "steps, let `Time/Step size control` choose them, or set `Contact/Motion = "
                        "linearised` if nothing slides along curved obstacles.");
    if (step.passes_through())
      throw StepError(which_step(start, step_size)
                      + " takes a body through an obstacle. Take smaller steps, or let `Time/Step "
                        "size control` choose them.");
    return step.finish();
  }
} // namespace signorini
