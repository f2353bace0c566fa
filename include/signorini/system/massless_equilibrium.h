// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_massless_equilibrium_h
#define signorini_system_massless_equilibrium_h

#include <signorini/preconditioners/preconditioners.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>

namespace signorini
{
  /**
   * The static contact problem of the nodes without mass when all others stand still: minimise 1/2
   * u'Au - f'u over their displacements under the condition of non-penetration. It has a solution
   * that depends continuously on the motion of the others (Khenous, Laborde and Renard 2008), and
   * makes the mass-redistributed problem an ordinary differential equation.
   */
  template <int dim>
  class MasslessEquilibrium
  {
  public:
    MasslessEquilibrium(const Discretization<dim>     &discretization,
                        const ContactSurface<dim>     &surface,
                        const ContactCoordinates<dim> &coordinates,
                        const SolverParameters        &parameters);

    /**
     * Collective.
     * @param displacement  u: that of nodes with mass is given, that of the others a first guess
     *                      and then the solution
     * @param load          f
     * @param energy_scale  accepted errors are 1e-24 of this in energy
     * @param contact_force nodal forces on the bodies, r
     */
    SolveReport
    solve(Vector &displacement, const Vector &load, double energy_scale, Vector &contact_force);

  private:
    const Discretization<dim>            &discretization;
    const ContactSurface<dim>            &surface;
    const ContactCoordinates<dim>        &coordinates;
    StepOperator<dim>                     stiffness;
    std::unique_ptr<MaskedPreconditioner> preconditioner;
    PrimalDualActiveSet                   solver;
    ActiveSet                             active;
    std::vector<unsigned int>             fixed_entries; ///< of all nodes with mass
  };
} // namespace signorini

#endif
