// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_stress_error_h
#define signorini_goals_stress_error_h

#include <signorini/adaptivity/error_indicator.h>
#include <signorini/goals/stress_of_interest.h>
#include <signorini/goals/sums_over_time.h>

namespace signorini
{
  /** What the mesh does to one stress in a run, relative to its largest size so far. */
  template <int dim>
  class StressError
  {
  public:
    explicit StressError(double target)
      : target(target)
    {
    }


    /**
     * A step was judged; a repeated one replaces what was seen of the same time. The first one
     * stands for itself alone, others for the time since the judgement before. Collective.
     * @param maximum_level of cells
     * @param relative_squares what comes of it is added: squared errors of cells in units of what
     *                         they may amount to together, by active_cell_index. Cells that may not
     *                         become finer may make more than the target; others as much then.
     */
    void see(const StressOfInterest<dim>  &stress,
             const Mesh<dim>              &mesh,
             const StepRecord             &step,
             const ContactZones<dim>      &zones,
             const dealii::Vector<double> &squares,
             unsigned int                  maximum_level,
             dealii::Vector<double>       &relative_squares);

    /** Whether there was anything that may be wrong. */
    bool has_seen_stress() const { return history.sums.stress > 0.; }

    /**
     * Estimated error relative to the stress, or to what is usual if that is larger, both L2 in
     * time; 0 if there was no stress. What the error of the contact force brings is beside it.
     */
    double relative_error() const;

    /** As the summary calls the stress. */
    const std::string &name() const { return stress_name; }

    void archive(Archive &archive)
    {
      archive(stress_name, largest);
      history.archive(archive);
    }

  private:
    double      target;
    std::string stress_name;
    double      largest = 0.; ///< stress so far

    struct Sums
    {
      double stress = 0., error = 0.; ///< squared, over time
    };
    SumsOverTime<Sums> history;
  };
} // namespace signorini

#endif
