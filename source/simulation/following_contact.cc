// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/schemes/fixed_point.h>
#include <signorini/simulation/following_contact.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    /** Times that a step is made again, and with what acceleration. */
    constexpr unsigned int most_repetitions = 24, few_differences = 3;


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

      /** Make the step with the normals of now. @return MovingContact::mismatch() */
      double make()
      {
        end    = start;
        report = scheme.advance(system, end, step_size);
        correctors.add(report.corrector);
        predictors.add(report.predictor);
        increment = end.displacement;
        increment -= start.displacement;
        return contact.mismatch(increment);
      }

      /** The same with the normals of the motion `current` of the entries. */
      double make_again(const Vector &current, Vector &image)
      {
        Vector motion = increment;
        for (std::size_t i = 0; i < entries.size(); ++i)
          motion.local_element(entries[i]) = current.local_element(i);
        contact.follow(motion);
        const double mismatch = make();
        copy_increment(image);
        return mismatch;
      }

      /** The motion of the entries on which normals depend. */
      void copy_increment(Vector &motion) const
      {
        for (std::size_t i = 0; i < entries.size(); ++i)
          motion.local_element(i) = increment.local_element(entries[i]);
      }

      Vector make_unknowns() const
      {
        return FixedPoint::make_unknowns(entries.size(), increment.get_mpi_communicator());
      }

      bool passes_through() const { return contact.passes_through(increment); }

      StepReport finish(State &state)
      {
        swap(state, end);
        report.corrector = correctors;
        report.predictor     = predictors;
        report.work_geometry = contact.geometry_work(state.contact_force);
        return report;
      }

    private:
      TimeScheme                     &scheme;
      DynamicalSystem                &system;
      MovingContact                  &contact;
      const State                    &start;
      const double                    step_size;
      const std::vector<unsigned int> entries;
      State                           end;
      Vector                          increment;
      StepReport                      report;
      SolveReport                     correctors, predictors;
    };
  } // namespace


  StepReport
  FollowingContact::advance(DynamicalSystem &system, State &state, const double step_size)
  {
    RepeatedStep step(*scheme, system, state, step_size);
    if (step.make() > 1.)
      {
        Vector first = step.make_unknowns();
        step.copy_increment(first);
        FixedPoint fixed_point(
          [&](const Vector &current, Vector &image) { return step.make_again(current, image); },
          first,
          {1., 1., most_repetitions});
        for (const unsigned int depth : {few_differences, 0U})
          if (!fixed_point.converged())
            fixed_point.run(depth);
        if (!fixed_point.converged())
          {
            std::ostringstream message;
            message << which_step(state, step_size)
                    << " finds no motion that belongs to its own normals of contact. Take smaller "
                       "steps, let `Time/Step size control` choose them, or set `Contact/Motion = "
                       "linearised` if nothing slides along curved obstacles.";
            throw StepError(message.str());
          }
      }
    if (step.passes_through())
      throw StepError(which_step(state, step_size)
                      + " takes a body through an obstacle. Take smaller steps, or let `Time/Step "
                        "size control` choose them.");
    return step.finish(state);
  }
} // namespace signorini
