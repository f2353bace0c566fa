// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_mass_near_contact_h
#define signorini_preconditioners_mass_near_contact_h

#include <signorini/preconditioners/preconditioners.h>
#include <signorini/sweeps/sweep_order.h>

namespace signorini
{
  /**
   * The preconditioner of the mass for what begins at a few contact nodes. Their corrections decay
   * within some fifteen cells (reach_of_forces()), so it sees a neighbourhood of them only, and
   * corrections are zero elsewhere; whether that was enough is told by the residual outside. The
   * neighbourhood stays while the nodes stay within a part of it. Where it would be most of the
   * mesh, or where two bodies meet, it is all of it, and stays so. Functions are collective.
   */
  template <int dim>
  class MassNearContact
  {
  public:
    MassNearContact(const ElasticMatrices<dim>    &matrices,
                    const ContactCoordinates<dim> &coordinates);

    /**
     * Before a solution.
     * @param origins  owned nodes where corrections begin
     * @param accuracy accepted error outside over the corrections there; 0: all nodes
     */
    void surround(const std::vector<unsigned int> &origins, double accuracy);

    /** Larger, around the latest nodes, so that ten times less is missed. */
    void widen();

    MaskedPreconditioner &preconditioner() { return *here; }

    /** Counts neighbourhoods: the same number, the same neighbourhood. */
    unsigned int number() const { return n_neighbourhoods; }

    /** Zero outside. */
    void clear_outside(Vector &correction) const;

    /** Of the residual outside, in the norm with the diagonal of M^-1. */
    double norm_outside(const Vector &residual) const;

  private:
    const ElasticMatrices<dim>           &matrices;
    const ContactCoordinates<dim>        &coordinates;
    std::optional<SweepOrder>             all; ///< made when it is first needed
    std::vector<unsigned int>             origins_here, latest_origins;
    double                                accuracy_here = 0.;
    std::vector<double>                   reach; ///< per owned node, unless it is all
    bool                                  is_all           = false; ///< on all processes
    unsigned int                          n_neighbourhoods = 0;
    std::unique_ptr<MaskedPreconditioner> here;

    void surround_anew();
    /** Find `reach`. @return whether that is worth it */
    bool is_small();
    bool contains(unsigned int node) const { return is_all || reach[node] >= accuracy_here; }
  };
} // namespace signorini

#endif
