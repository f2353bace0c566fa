// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_goal_estimate_h
#define signorini_step_size_goal_estimate_h

#include <signorini/step_size/embedded_estimate.h>
#include <signorini/step_size/largest_force.h>
#include <signorini/time/error_of_steps.h>

#include <functional>

namespace signorini
{
  /** To which instant of a step its contact force belongs, and how much too late it comes. */
  struct ForceInStep
  {
    double                  before_end = 0.; ///< see force_before_end(), part of the step
    std::function<double()> delay      = {}; ///< see StepReport::force_delay, part of the step
  };

  /**
   * One step, measured by what it leaves open of the contact force: error_of_step(), relative to
   * the largest force that is expected (LargestForce), in the mean of what has been of late. A
   * single step is rejected from twice the tolerance on; a mean above it asks for shorter steps, a
   * fifth of it allows longer ones.
   *
   * - Steps that are shorter than the first size are taken together until they are as long, and
   *   their mean force counts. Else shorter steps would see more and more of the ringing of contact
   *   nodes, and become shorter for that.
   * - A constant force may hide waves that carry the next one. So the square of the embedded
   *   estimate of the motion counts as well (errors of forces are of the size of squared errors in
   *   the energy norm), but for no shorter steps than the first one.
   * - In flight there is no force. If contact may come back, vibrations have to arrive in phase:
   *   each radian may lose the tolerance, as part of the motion.
   */
  class GoalEstimate : public StepEstimate
  {
  public:
    /**
     * @param first      size of the first step
     * @param comes_back whether a flight may end in another contact
     */
    GoalEstimate(TimeScheme  &scheme,
                 const double first,
                 ForceInStep  force_in_step,
                 const bool   comes_back)
      : motion(scheme)
      , first(first)
      , force_in_step(std::move(force_in_step))
      , comes_back(comes_back)
    {
    }

    StepTrial
    attempt(DynamicalSystem &system, const State &start, double span, double tolerance) override;
    void      accept(const State &start, const State &end) override;
    void      take_back() override;
    StepRules rules() const override;
    void      archive(Archive &archive) override;

  private:
    EmbeddedEstimate  motion;
    const double      first;
    const ForceInStep force_in_step;
    const bool        comes_back;
    LargestForce      largest;

    /** The force so far, in stretches that are as long as the first step, or longer. */
    struct Course
    {
      ForceOfStep last, before; ///< the two stretches that were completed last
      ForceOfStep present;      ///< so far: its instant times its size, its force times its size
      double      roughness   = 0.; ///< error over tau^2, of the last but one stretch
      double      mean_square = 0.; ///< of it, what is past fades away
      double      waves       = 0.; ///< in flight: embedded estimate over tau^2

      void begin(double time, double size, double force);
      void add(const ForceOfStep &stretch);
    };
    Course course, course_before; ///< the step that was accepted last
    Course tried;                 ///< with the latest attempt

    double force_at_end = 0.; ///< of the latest attempt

    /** What waves count that the force does not show. @param error theirs, in this step */
    double of_waves(double error, double span, double tolerance) const;

    /** The course with the latest attempt. @param most roughness that counts in the mean */
    Course with(const State &start, const State &end, double force_before, double most) const;
  };
} // namespace signorini

#endif
