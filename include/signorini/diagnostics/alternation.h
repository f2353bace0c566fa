// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_alternation_h
#define signorini_diagnostics_alternation_h

#include <signorini/base/archive.h>
#include <signorini/contact/contact_surface.h>

namespace signorini
{
  /**
   * Watches whether contact nodes have velocities that change their sign from step to step: what
   * the trapezoidal rule makes of vibrations that are much faster than a step. Forces and paths do
   * not show it, velocities and stresses do.
   *
   * (-1)^n (v_n - 2 v_{n-1} + v_{n-2}) / 4 is the amplitude of a velocity (-1)^n a. Its mean over a
   * number of steps keeps that, and forgets motions that the steps resolve and the jump of a node
   * that hits something, which appears twice with opposite signs.
   */
  template <int dim>
  class Alternation
  {
  public:
    static constexpr unsigned int n_steps = 16; ///< of a mean

    /** The nodes are others now: begin anew. Speeds that were reached are kept. */
    void forget();

    /**
     * @param velocity of all nodes at the end of a step
     * @param typical_speed of the motion as a whole
     * @return per body, after each `n_steps` steps: the largest amplitude of a contact node over
     * the largest speed that the body's contact nodes have in the mean of steps, or that is
     * typical; 0 in all other steps. Collective.
     */
    std::vector<double> add(const ContactSurface<dim> &surface,
                            const Vector              &velocity,
                            double                     typical_speed,
                            unsigned int               n_bodies,
                            MPI_Comm                   communicator);

    /** What forget() keeps. */
    void archive(Archive &archive) { archive(fastest); }

  private:
    unsigned int        n_added = 0; ///< since the nodes are these
    std::vector<double> before, last,
      sums;                      ///< of contact nodes: normal velocities, their amplitude
    std::vector<double> fastest; ///< of bodies, so far: in the mean of steps

    std::vector<double>
    judge(const ContactSurface<dim> &surface, double typical_speed, MPI_Comm communicator);
  };
} // namespace signorini

#endif
