// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_dynamical_system_h
#define signorini_time_dynamical_system_h

#include <signorini/base/contact_status.h>
#include <signorini/base/solve_report.h>
#include <signorini/base/types.h>
#include <signorini/time/state.h>

#include <vector>

namespace signorini
{
  /** Distances gamma = g - u.nu of the contact nodes that this process owns; also bounds for normal increments. */
  using NormalGap = std::vector<double>;

  /**
   * minimise 1/2 d'(M + s A) d - b'd over increments d with d.nu <= bound at the contact nodes and the prescribed
   * increments at supports. The step [start.time, start.time + step_size] determines supports and the scale of errors.
   */
  struct IncrementProblem
  {
    double           stiffness_factor; ///< s, tau^2/4 for the trapezoidal rule
    const Vector    &right_hand_side;  ///< b
    const NormalGap &bounds;
    const State     &start; ///< the motion before the step: what supports are measured from, and a first guess
    double           step_size;
    double           force_factor = 0.; ///< nodal forces times this are reactions: tau^2/2 for the trapezoidal rule
    /** Reactions of contact besides those of this problem in the step, to which friction is entitled, too; null: none. */
    const Vector *further_reaction = nullptr;
  };

  /** The increment and the generalised forces that hold the constraints, all in Cartesian components. */
  struct IncrementSolution
  {
    Vector increment;        ///< d
    Vector contact_reaction; ///< (K d - b) in the contact entries: compression has a negative normal component
    Vector support_reaction; ///< (K d - b) in the entries of supports
    /** The contact reaction as one number per contact node that this process owns, compression < 0; zero where open. */
    std::vector<double> normal_reaction;
    std::vector<double> slip_length; ///< length of `slip` per contact node; empty without friction
    ActiveSet           status;      ///< per contact node: open, slip or stick; empty without friction
    Vector      friction_reaction;   ///< like the contact reaction, in tangential directions; empty without friction
    Vector      slip;                ///< relative tangential increments of closed contact nodes; empty without friction
    double      friction_work = 0.;  ///< friction_reaction times increment, exactly zero where nodes stick
    SolveReport effort;
  };

  /**
   * All that a time scheme sees of the bodies. It knows no mesh, no obstacle and no solver; a bouncing mass is a realisation
   * of twenty lines (tests/time).
   */
  class DynamicalSystem
  {
  public:
    virtual ~DynamicalSystem() = default;

    virtual Vector make_vector() const = 0;

    /** destination = M source. */
    virtual void apply_mass(Vector &destination, const Vector &source) const = 0;

    /** destination = A source. */
    virtual void apply_stiffness(Vector &destination, const Vector &source) const = 0;

    /** Add factor times the mean of the loads at both ends of a step; @return false if there are none. */
    virtual bool add_mean_load(Vector &destination, double factor, double start_time, double end_time) = 0;

    /** Add factor times the loads at a time; @return false if there are none. */
    virtual bool add_load(Vector &destination, const double factor, const double time)
    {
      return add_mean_load(destination, factor, time, time);
    }

    virtual NormalGap normal_gap(const Vector &displacement) const = 0;

    /** [w].nu per contact node, of displacements or velocities. */
    virtual NormalGap relative_normal(const Vector &motion) const = 0;

    /** The nodal forces f of forces along the normals of the contact nodes: f.w = sum of force times [w].nu. */
    virtual Vector normal_forces(const std::vector<double> &forces) const = 0;

    /** The unit of length for tolerances: the size of the bodies. */
    virtual double length() const = 0;

    /** M^-1 force, zero in the directions of supports and in entries without mass. */
    virtual Vector solve_mass(const Vector &force) = 0;

    /** Solve the inequality of a step. `solution` is overwritten; the system keeps its own history for first guesses. */
    virtual void solve(const IncrementProblem &problem, IncrementSolution &solution) = 0;

    /**
     * L2 projection of a free increment onto the admissible ones: the correction c with minimal 1/2 c'Mc and
     * (free_increment + c).nu <= bound.
     * @param mass_correction M c, the reaction of the projection
     * @return effort; no active node means that the free increment was admissible and c = 0, found without any solve
     */
    virtual SolveReport project(const Vector    &free_increment,
                                const NormalGap &bounds,
                                double           step_size,
                                Vector          &correction,
                                Vector          &mass_correction) = 0;

    /**
     * L2 projection of a velocity onto those without relative velocity at some contact nodes: the correction c with minimal 1/2 c'Mc
     * and [velocity + c] = 0 there, zero at supports.
     * @param held            per contact node of this process: closed ones lose their normal velocity, sticking ones the tangential one
     * @param mass_correction M c, the impulses of these nodes and of supports
     * @return effort; no active node means that no process holds any, and c = 0
     */
    virtual SolveReport stop_relative_motion(const Vector    &velocity,
                                             const ActiveSet &held,
                                             Vector          &correction,
                                             Vector          &mass_correction) = 0;

    /** Entries of vectors (owned, local) that have no mass, whatever acts on them. */
    virtual std::vector<unsigned int> massless_entries() const { return {}; }

    /**
     * Static contact equilibrium of the massless entries between the others, which stand still: least 1/2 u'Au - f'u with u.nu <= g.
     * @param displacement  u, changed in the massless entries only; there it is a first guess on entry
     * @param load          f
     * @param contact_force r
     */
    virtual SolveReport equilibrate_massless(Vector &displacement, const Vector &load, Vector &contact_force);

    /** Whether prescribed displacements change in a span of time. Collective. */
    virtual bool supports_move(double /*start_time*/, double /*end_time*/) const { return false; }

    /** Zero in the directions of supports: the velocity beside supports that stand still. */
    virtual void stop_at_supports(Vector & /*velocity*/) const {}

    /** The part of nodal forces that acts in the directions of supports. Zero for systems without supports. */
    virtual Vector support_part(const Vector &forces) const
    {
      Vector none = forces;
      none        = 0.;
      return none;
    }

    /** The time that a wave takes through the smallest cell: much shorter steps resolve nothing. Zero: there are no cells. Collective. */
    virtual double shortest_wave_time() const { return 0.; }
  };
} // namespace signorini

#endif
