// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_alternation_h
#define signorini_diagnostics_alternation_h

#include <signorini/base/archive.h>
#include <signorini/contact/contact_surface.h>

namespace signorini
{
  /** Velocities that are watched, always the same ones on a mesh, and whose they are. */
  struct WatchedVelocities
  {
    std::vector<double>       values;
    std::vector<unsigned int> bodies;
  };

  /** Of contact nodes, along their normals. @param velocity of all nodes */
  template <int dim>
  WatchedVelocities normal_velocities(const ContactSurface<dim> &surface, const Vector &velocity);

  /** Of nodes whose displacement is prescribed and depends on time. @param velocity of all nodes */
  template <int dim>
  WatchedVelocities prescribed_velocities(const DirichletConditions<dim> &dirichlet,
                                          const Vector                   &velocity);

  /**
   * Watches whether velocities change their sign from step to step: what the trapezoidal rule makes
   * of vibrations that are much faster than a step, and of jumps of prescribed velocities. Forces
   * of contact and paths do not show it, velocities and stresses do.
   *
   * (-1)^n (v_n - 2 v_{n-1} + v_{n-2}) / 4 is the amplitude of a velocity (-1)^n a. Its mean over a
   * number of steps keeps that, and forgets motions that the steps resolve and the jump of a node
   * that hits something, which appears twice with opposite signs.
   */
  class Alternation
  {
  public:
    static constexpr unsigned int n_steps = 16; ///< of a mean

    /** @param must_last whether the least of two means in sequence counts */
    explicit Alternation(const bool must_last = false)
      : must_last(must_last)
    {
    }

    /** The nodes are others now: begin anew. Speeds that were reached are kept. */
    void forget();

    /**
     * @param velocities at the end of a step
     * @param typical_speed of the motion as a whole
     * @return per body, after each `n_steps` steps: the largest amplitude over the largest speed
     * that the body's watched velocities have in the mean of steps, or that is typical; 0 in all
     * other steps. Collective.
     */
    std::vector<double> add(const WatchedVelocities &velocities,
                            double                   typical_speed,
                            unsigned int             n_bodies,
                            MPI_Comm                 communicator);

    /** What forget() keeps. */
    void archive(Archive &archive) { archive(fastest, latest_means); }

  private:
    const bool          must_last;
    unsigned int        n_added = 0;        ///< since the nodes are these
    std::vector<double> before, last, sums; ///< of watched velocities, their amplitude
    std::vector<double> fastest;            ///< of bodies, so far: in the mean of steps
    std::vector<double> latest_means;       ///< what judge() found last

    std::vector<double>
    judge(const std::vector<unsigned int> &bodies, double typical_speed, MPI_Comm communicator);
  };
} // namespace signorini

#endif
