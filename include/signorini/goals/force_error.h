// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_force_error_h
#define signorini_goals_force_error_h

#include <signorini/adaptivity/error_indicator.h>
#include <signorini/contact/contact_surface.h>
#include <signorini/goals/sums_over_time.h>
#include <signorini/time/state.h>

#include <string>
#include <vector>

namespace signorini
{
  /** What the error of the contact force in one step is estimated from. */
  struct ForceReading
  {
    double time                  = 0.;
    double step_size             = 0.; ///< that ended there; 0: none
    double force                 = 0.; ///< sum of normal contact forces, positive
    double elastic_energy        = 0.; ///< of all bodies
    double energy_before_contact = 0.; ///< the same where the step began, if without contact
    double squared_error   = 0.; ///< sum of squared indicators: of the error in the energy norm
    double at_limit        = 0.; ///< the part of the cells that may not become finer
    double of_uniform_mesh = 0.; ///< the same if all cells had level 0
    double n_cells         = 0.;
    double n_near          = 0.; ///< cells near the contact of their body
    double n_free          = 0.; ///< cells of bodies that touch nothing
    double n_coarsest      = 0.; ///< cells of level 0
    double of_approach     = 0.; ///< energy_of_slow_approach()

    /**
     * What the force may rise to soon: with the root of all energy that may become elastic, as if
     * contact were linear, and at most to twice as much as now.
     */
    double expected_force() const;
  };

  /**
   * Of a step, the state at its end and its indicators, by active_cell_index.
   * Collective; the same on all processes. @param maximum_level of cells
   */
  template <int dim>
  ForceReading force_reading(const Discretization<dim>    &discretization,
                             const ContactSurface<dim>    &surface,
                             const StepRecord             &step,
                             const dealii::Vector<double> &indicator,
                             unsigned int                  maximum_level);

  /**
   * What the mesh does to the contact force of a run.
   *
   * The force is the derivative of the elastic energy E by the approach of the bodies, and E of a
   * solution with finite elements is wrong by half the squared error in the energy norm. Relative
   * errors of both are of one size, so that the force of a step has about the error
   *
   *   |error of F| = F eta^2 / (effectivity 2 E),
   *
   * where eta^2 is the squared estimate *at rest* of the balance of the step: with inertia as a
   * load that is known, as for the elliptic reconstruction of Makridakis and Nochetto (SIAM J.
   * Numer. Anal. 41, 2003). The constant was measured (doc/adaptivity.md).
   */
  class ForceError
  {
  public:
    ForceError(double target, unsigned int dim);

    /** Squared estimates in units of the squared error in the energy norm, which is 2 E of it. */
    static constexpr double effectivity(const unsigned int dim) { return dim == 2 ? 24. : 75.; }

    /** A step was judged; a repeated one replaces what was seen of the same time. */
    void see(const ForceReading &reading);

    /**
     * The root of the energy that the estimate of the latest step must not exceed, so that its
     * error is the target in units of the largest force so far or to be expected; but what cells
     * that may not become finer make may come from others, too. Without contact it is the largest
     * one so far, and without any beyond bounds.
     */
    double tolerance() const;

    /**
     * The part of the squared tolerance that was the least in the last three quarters of the time
     * in contact, between 1/16 and 1: it follows the elastic energy, which in an impact rises and
     * falls again. What is coarsened should not be missed then. A contact that stays forgets how it
     * began, and leaves coarse cells where it has gone on.
     */
    double least_part_of_tolerance() const;

    bool has_seen_contact() const { return largest_force > 0.; }

    /** Whether there is contact, and has been with a like force in the judgement before. */
    bool is_settled() const { return latest.force > 0. && latest.force < 2. * previous_force; }

    /** Whether the force is more than half of the largest one so far. */
    bool is_high() const { return latest.force > 0.5 * largest_force; }

    /** Estimated error of the force relative to the force, both L2 in time. 0 without contact. */
    double relative_error() const;

    /** The level of a uniform mesh with this error, and how many cells it would have. */
    double uniform_level() const;
    double uniform_cells() const;

    /** The mean while there was contact. */
    double mean_cells() const;

    /** For the end of the run: an entry of the summary. */
    std::string summary() const;

    void archive(Archive &archive)
    {
      archive(latest, previous_force, largest_force, largest_tolerance, tolerances);
      archive(n_contacts, n_contacts_before, largest_energy, energy_before_contact);
      history.archive(archive);
    }

  private:
    double       target;
    unsigned int dim;
    ForceReading latest;
    double       previous_force    = 0.; ///< in the judgement before
    double       largest_force     = 0.;
    double       largest_tolerance = 0.;
    unsigned int n_contacts = 0, n_contacts_before = 0; ///< the latter: at the judgement before
    double       largest_energy = 0., energy_before_contact = 0.; ///< elastic ones

    struct Tolerance
    {
      double time = 0., value = 0.;
    };
    std::vector<Tolerance> tolerances; ///< since contact began

    struct Sums
    {
      double force = 0., error = 0., of_uniform_mesh = 0.; ///< squared, over time
      double time = 0., n_coarsest = 0.;
      double cells = 0., near = 0., free = 0.; ///< numbers times the time
    };
    SumsOverTime<Sums> history;
  };
} // namespace signorini

#endif
