// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_force_estimate_h
#define signorini_step_size_force_estimate_h

#include <signorini/step_size/embedded_estimate.h>
#include <signorini/step_size/largest_force.h>

namespace signorini
{
  /**
   * One step, measured by the contact forces @f$r@f$ alone while there is no contact, and by them
   * and the motion in contact. With the size @f$\tau'@f$ and the forces @f$r'@f$ of the last step
   * @f[
   *   \varepsilon_\text{force} = \left(\frac\tau{\tau_0}\right)^2
   *                              \frac{|r - r'|_1}{\tfrac12 (1 + \tau'/\tau) R},
   *   \quad \varepsilon = \max(\varepsilon_\text{force}, \text{embedded estimate}).
   * @f]
   *
   * - The change of forces over one step is what a force that is constant over its step cannot
   *   show. For the error in @f$L^2@f$ of time alone steps would go with its -2/3rd power; the
   *   square of @f$\tau@f$ makes that -1/3: local slopes follow vibrations, whose next swing they
   *   do not foretell.
   * - @f$R@f$ is the force that changes are measured by, see LargestForce.
   * - A constant force may hide waves that carry the next one; so the motion counts, too, but not
   *   in flight: what vibrates there is the business of its next contact.
   */
  class ForceEstimate : public StepEstimate
  {
  public:
    /**
     * @param unit      tau_0 > 0, in which sizes are measured
     * @param dimension components of the force on a node
     */
    ForceEstimate(TimeScheme &scheme, const double unit, const unsigned int dimension)
      : motion(scheme)
      , unit(unit)
      , dimension(dimension)
    {
    }

    StepTrial
    attempt(DynamicalSystem &system, const State &start, double span, double tolerance) override;
    void      accept(const State &start, const State &end) override;
    void      take_back() override;
    StepRules rules() const override;
    void      archive(Archive &archive) override
    {
      motion.archive(archive);
      largest.archive(archive);
    }

  private:
    EmbeddedEstimate motion;
    const double     unit;
    unsigned int     dimension;
    LargestForce     largest;

    /** |r|_1: the magnitudes at all nodes, of both bodies, all pairs, and friction. */
    double size_of(const Vector &force) const;
  };
} // namespace signorini

#endif
