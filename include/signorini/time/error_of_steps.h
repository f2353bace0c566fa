// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_error_of_steps_h
#define signorini_time_error_of_steps_h

#include <signorini/base/archive.h>

namespace signorini
{
  /** The contact force of a step. */
  struct ForceOfStep
  {
    double instant = 0.; ///< to which it belongs, see force_before_end()
    double size    = 0.; ///< of the step
    double delay   = 0.; ///< see SchemeInfo::force_delay, as a time
    double force   = 0.; ///< sum over the contact nodes
  };

  /** How the force changes at the middle one of three steps. */
  struct ForceDifferences
  {
    double slope = 0., curvature = 0.; ///< divided differences; 0 if two instants coincide
    double size = 0.;                  ///< of the step, or of its neighbour in contact if it flies
  };

  ForceDifferences
  force_differences(const ForceOfStep &before, const ForceOfStep &at, const ForceOfStep &after);

  /**
   * What a step leaves open of the contact force, from its course alone:
   * @f[
   *   \varepsilon = 0.6\, \tau^2 |F''| + \theta |F'|.
   * @f]
   * The first part is what a second order method does to a force that bends or has a kink, the
   * second one that of schemes whose forces come later the longer their steps are, by the delay
   * @f$\theta@f$. Most estimates lie within a factor of three of the errors (doc/step_size.md).
   */
  double error_of_step(const ForceDifferences &force, double size, double delay);

  /**
   * The estimated error of the contact force by the steps of a run, relative to the force, both in
   * @f$L^2@f$ of time: the error of each step, and that of contacts which come too early or too
   * late because of earlier ones. Each contact leaves an error of the speed, which grows in flight.
   */
  class ErrorOfSteps
  {
  public:
    /** Before the first step. */
    void start(double time, double force);

    void add(const ForceOfStep &step);

    /** Whether there was a force, before the last step. */
    bool is_known() const { return squared_force > 0.; }

    double relative_error() const;

    /** Whether most of the error is that of contacts which are too early or too late. */
    bool comes_from_earlier_contacts() const
    {
      return squared_error_of_time + error_of_time() > squared_error;
    }

    void archive(Archive &archive)
    {
      archive(last, before, squared_error, squared_force, squared_error_of_time, contact);
      archive(largest_impulse, error_of_impulses, late);
    }

  private:
    ForceOfStep last, before;
    double      squared_error = 0., squared_force = 0.; ///< times lengths of steps
    double      squared_error_of_time = 0.; ///< by contacts in the past that did not come in time

    /** A contact, sums as above. */
    struct Contact
    {
      double duration = 0., impulse = 0.;
      double squared_error = 0., squared_force = 0., squared_slope = 0.;

      void add(const ForceOfStep &step, double error, const ForceDifferences &force);
    };
    Contact contact;                ///< the present one
    double  largest_impulse   = 0.; ///< of a contact
    double  error_of_impulses = 0.; ///< by all contacts so far
    double  late              = 0.; ///< over the largest impulse: by how much the next one is late

    void end_contact();
    /** Square of the error of the present contact, by its being late, or early. */
    double error_of_time() const;
  };
} // namespace signorini

#endif
