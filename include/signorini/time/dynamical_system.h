// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_dynamical_system_h
#define signorini_time_dynamical_system_h

#include <signorini/base/contact_status.h>
#include <signorini/base/solve_report.h>
#include <signorini/base/types.h>
#include <signorini/time/moving_contact.h>

#include <vector>

namespace signorini
{
  /**
   * The problem of a step:
   * @f[
   *   \text{minimise} \quad \tfrac12 d^T (M + s A + c C) d - b^T d
   * @f]
   * over increments @f$d@f$ with @f$d \cdot \nu \le@f$ `bounds` at the contact nodes and the
   * given values in prescribed entries. The step [start.time, start.time + step_size]
   * determines the prescribed values and the scale of errors.
   */
  struct IncrementProblem
  {
    double           stiffness_factor; ///< s, tau^2/4 for the trapezoidal rule
    double           damping_factor;   ///< c, tau/2 for the trapezoidal rule
    const Vector    &right_hand_side;  ///< b
    const NormalGap &bounds;
    const State     &start; ///< of the step: where prescribed increments begin, and a first guess
    double           step_size;
    double           force_factor; ///< > 0: nodal forces times this are reactions, tau^2/2 for the
                                   ///< trapezoidal rule
    /**
     * Reactions of contact besides those of this problem in the step, to which friction is
     * entitled, too; or null.
     */
    const Vector *further_reaction = nullptr;
  };

  /**
   * The increment and the generalised forces that hold the constraints, all in Cartesian
   * components.
   */
  struct IncrementSolution
  {
    Vector increment;          ///< d
    Vector contact_reaction;   ///< (K d - b) in the contact entries: compression has a negative
                               ///< normal component
    Vector dirichlet_reaction; ///< (K d - b) in the prescribed entries
    /**
     * The contact reaction as one number per contact node that this process owns, compression < 0;
     * zero where open.
     */
    std::vector<double> normal_reaction;
    std::vector<double> slip_length; ///< length of `slip` per contact node; empty without friction
    ActiveSet           status; ///< per contact node: open, slip or stick; empty without friction
    Vector friction_reaction;   ///< like the contact reaction, in tangential directions; empty
                                ///< without friction
    Vector slip; ///< relative tangential increments of closed contact nodes; empty without friction
    /** friction_reaction times increment, exactly zero where nodes stick. */
    double      friction_work = 0.;
    SolveReport effort;
  };

  /** Projections in the norm of the mass: predictors, and velocities of nodes that are held. */
  class MassProjections
  {
  public:
    virtual ~MassProjections() = default;

    /**
     * @f$L^2@f$ projection of a free increment onto the admissible ones: the correction @f$c@f$
     * with minimal @f$\tfrac12 c^T M c@f$ and `(free_increment + c).nu <= bounds`.
     * @param mass_correction @f$M c@f$, the reaction of the projection
     * @return effort; no active node means that the free increment was admissible and @f$c = 0@f$,
     *         found without any solve
     */
    virtual SolveReport project(const Vector    &free_increment,
                                const NormalGap &bounds,
                                double           step_size,
                                Vector          &correction,
                                Vector          &mass_correction) = 0;

    /**
     * @f$L^2@f$ projection of a velocity onto those without relative velocity at some contact
     * nodes: the correction @f$c@f$ with minimal @f$\tfrac12 c^T M c@f$ and [velocity + @f$c@f$] =
     * 0 there, zero in prescribed entries.
     * @param held            per contact node of this process: closed ones lose their normal
     *                        velocity, sticking ones the tangential one
     * @param mass_correction @f$M c@f$, the impulses of these nodes and of prescribed ones
     * @return effort; no active node means that no process holds any, and @f$c = 0@f$
     */
    virtual SolveReport stop_relative_motion(const Vector    &velocity,
                                             const ActiveSet &held,
                                             Vector          &correction,
                                             Vector          &mass_correction) = 0;
  };


  /** Impulses at the contact nodes, given one by one. */
  class NodalImpulses
  {
  public:
    virtual ~NodalImpulses() = default;

    /**
     * The nodal forces f of forces along the normals of the contact nodes: f.w = sum of force
     * times [w].nu.
     */
    virtual Vector normal_forces(const std::vector<double> &forces) const = 0;
  };


  /** Nodes without mass, whose motion is no differential equation: they follow the others. */
  class MasslessNodes
  {
  public:
    virtual ~MasslessNodes() = default;

    /** Entries of vectors (owned, local) that have no mass, whatever acts on them. */
    virtual std::vector<unsigned int> massless_entries() const = 0;

    /**
     * Static contact equilibrium of these entries between the others, which stand still: least
     * @f$\tfrac12 u^T A u - f^T u@f$ with @f$u \cdot \nu \le g@f$.
     * @param displacement  @f$u@f$, changed in the massless entries only; there it is a first guess
     *                      on entry
     * @param load          @f$f@f$
     * @param contact_force @f$r@f$
     */
    virtual SolveReport
    equilibrate_massless(Vector &displacement, const Vector &load, Vector &contact_force) = 0;
  };


  /** Prescribed displacements that may change in time. */
  class MovingDirichletConditions
  {
  public:
    virtual ~MovingDirichletConditions() = default;

    /** Make a velocity zero in the prescribed directions, as where they stand still. */
    virtual void stop_at_dirichlet(Vector &velocity) const = 0;

    /** The part of nodal forces in the prescribed directions. */
    virtual Vector dirichlet_part(const Vector &forces) const = 0;
  };


  /** Viscous forces -C v. */
  class ViscousDamping
  {
  public:
    virtual ~ViscousDamping() = default;

    /** destination = C velocity. */
    virtual void apply_damping(Vector &destination, const Vector &velocity) const = 0;
  };


  /** A step from equilibrium to equilibrium, without inertia. */
  struct LoadStep
  {
    const Vector    &force; ///< b: the loads of the end without A u of the start
    const NormalGap &bounds;
    const State     &start; ///< of the step: where prescribed increments begin, and a first guess
    double           step_size;
  };

  /** Static problems, in which A alone resists. */
  class StaticProblems
  {
  public:
    virtual ~StaticProblems() = default;

    /**
     * Minimise @f$\tfrac12 d^T A d - b^T d@f$ under the conditions of an IncrementProblem; with
     * friction its law with the increments of the step. Motions that neither conditions nor contact
     * hold and no load drives are left out of d.
     * @param solution forces are forces, whatever the size of the step
     * @throws RunError naming the bodies and their motions, if loads drive what nothing holds
     */
    virtual void equilibrate(const LoadStep &step, IncrementSolution &solution) = 0;
  };


  /** What a system can do beyond DynamicalSystem; null: it cannot, or has nothing of the kind. */
  struct Capabilities
  {
    MassProjections                 *projections      = nullptr;
    const NodalImpulses             *impulses         = nullptr;
    MasslessNodes                   *massless_nodes   = nullptr;
    const MovingDirichletConditions *moving_dirichlet = nullptr;
    const ViscousDamping            *damping          = nullptr;
    StaticProblems                  *statics          = nullptr;
    MovingContact                   *moving_contact   = nullptr;
  };


  /**
   * All that every time scheme sees of the bodies. It knows no mesh, no obstacle and no solver; a
   * mass on a spring is a realisation of twenty lines (tests/time/bouncing_mass.h). What only some
   * schemes need is in interfaces of its own: a scheme asks for them, and a system offers them, or
   * the scene is refused before it runs (see check_capabilities()).
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

    /** Add factor times the loads at a time. */
    virtual void add_load(Vector &destination, double factor, double time) = 0;

    /** M^-1 force, zero in prescribed directions and in entries without mass. */
    virtual Vector solve_mass(const Vector &force) = 0;

    virtual NormalGap normal_gap(const Vector &displacement) const = 0;

    /** [w].nu per contact node, of displacements or velocities. */
    virtual NormalGap relative_normal(const Vector &motion) const = 0;

    /**
     * The normal entries of nodal forces of contact, per contact node: what a node bears itself,
     * not what others hand on to it.
     */
    virtual NormalGap own_normal_forces(const Vector &nodal_forces) const = 0;

    /** The unit of length for tolerances: the size of the bodies. */
    virtual double length() const = 0;

    /**
     * Solve the inequality of a step. `solution` is overwritten; the system keeps its own history
     * for first guesses.
     */
    virtual void solve(const IncrementProblem &problem, IncrementSolution &solution) = 0;

    /** None, unless a system says otherwise. */
    virtual Capabilities capabilities() { return {}; }
  };


  /** Add factor times the mean of the loads at both ends of a step. */
  inline void add_mean_load(DynamicalSystem &system,
                            Vector          &destination,
                            const double     factor,
                            const double     start_time,
                            const double     end_time)
  {
    system.add_load(destination, 0.5 * factor, start_time);
    system.add_load(destination, 0.5 * factor, end_time);
  }

  /** The entries without mass; none in a system that offers no such nodes. */
  inline std::vector<unsigned int> massless_entries(DynamicalSystem &system)
  {
    const MasslessNodes *nodes = system.capabilities().massless_nodes;
    return nodes != nullptr ? nodes->massless_entries() : std::vector<unsigned int>();
  }

  /** The motion of obstacles in the step; null if none moves. */
  inline const Vector *obstacle_motion(DynamicalSystem &system)
  {
    const MovingContact *contact = system.capabilities().moving_contact;
    return contact != nullptr ? contact->obstacle_motion() : nullptr;
  }

  /** Whether the step that is made now is the latest one with other conditions of contact. */
  inline bool is_repetition(DynamicalSystem &system)
  {
    const MovingContact *contact = system.capabilities().moving_contact;
    return contact != nullptr && contact->repeats();
  }

  /** Whether of the step that is made now nothing but its motion is wanted, and that roughly. */
  inline bool is_trial(DynamicalSystem &system)
  {
    const MovingContact *contact = system.capabilities().moving_contact;
    return contact != nullptr && contact->steps_are_trials();
  }

  /** What moving obstacles do in the step by forces with which they act on the bodies. */
  inline double obstacle_work(DynamicalSystem &system, const Vector &forces)
  {
    const Vector *motion = obstacle_motion(system);
    return motion != nullptr ? forces * *motion : 0.;
  }

  /**
   * The gaps of the start of a step from the bounds of the step, which know the motion of
   * obstacles, too.
   */
  inline NormalGap gaps_at_start(DynamicalSystem &system, const NormalGap &bounds)
  {
    NormalGap gaps = bounds;
    if (const Vector *motion = obstacle_motion(system))
      {
        const NormalGap moved = system.relative_normal(*motion);
        for (std::size_t k = 0; k < gaps.size(); ++k)
          gaps[k] -= moved[k];
      }
    return gaps;
  }

  /** An increment along the normals of the contact nodes, relative to obstacles that move. */
  inline NormalGap motion_past_obstacles(DynamicalSystem &system, const Vector &increment)
  {
    const Vector *motion = obstacle_motion(system);
    if (motion == nullptr)
      return system.relative_normal(increment);
    Vector past = increment;
    past -= *motion;
    return system.relative_normal(past);
  }

  /** See MovingContact; zero where contact does not follow the motion. */
  inline NormalGap tangential_approach(DynamicalSystem &system, const Vector &free_increment)
  {
    const MovingContact *contact = system.capabilities().moving_contact;
    return contact != nullptr ? contact->tangential_approach(free_increment)
                              : NormalGap(system.relative_normal(free_increment).size(), 0.);
  }

  /** The part of nodal forces in prescribed directions; zero in a system that has none. */
  inline Vector dirichlet_part(DynamicalSystem &system, const Vector &forces)
  {
    const MovingDirichletConditions *dirichlet = system.capabilities().moving_dirichlet;
    return dirichlet != nullptr ? dirichlet->dirichlet_part(forces) : system.make_vector();
  }
} // namespace signorini

#endif
