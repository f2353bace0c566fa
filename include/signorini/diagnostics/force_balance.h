// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_force_balance_h
#define signorini_diagnostics_force_balance_h

#include <signorini/discretization/discretization.h>
#include <signorini/time/time_scheme.h>

namespace signorini
{
  /** The contact force on one body, by two ways that share nothing but the step. */
  struct ContactForceOnBody
  {
    std::array<double, 3> by_multiplier{}; ///< sum of the nodal contact forces
    std::array<double, 3> by_momentum{};   ///< what changed the momentum, without all other forces
    double momentum_scale = 0.; ///< of the forces in the balance, with which errors are compared
  };

  /**
   * The balance of momentum of each body, P_new - P = tau (load + contact + supports - damping),
   * solved for the contact force in the sense in which the scheme applies it: see doc/output.md.
   * Forces are those of the unknowns: what an oblique obstacle hands on to supports is in neither.
   */
  template <int dim>
  class ForceBalance
  {
  public:
    /** @param balance of the scheme @param has_inertia false: momentum does not change */
    ForceBalance(StepBalance balance, bool has_inertia)
      : balance(balance)
      , has_inertia(has_inertia)
    {
    }

    /**
     * Begin with a state, also on a new mesh, which must live until the next one. Collective.
     * @param load at its time; null: none
     */
    void start(const Discretization<dim> &discretization, const State &state, const Vector *load);

    std::size_t n_bodies() const { return before.size(); }

    /** A step that led to a state, by bodies, the same on all processes. Collective. */
    std::vector<ContactForceOnBody>
    step(const State &state, const StepReport &report, const Vector *load);

  private:
    /** Sums over one body, at the end of a step. */
    struct Sums
    {
      std::array<double, 3> momentum{}, contact{}, load{}, support{};
      std::array<double, 3> moved_mass{}; ///< masses times displacements, where damping needs it
    };

    const StepBalance          balance;
    const bool                 has_inertia;
    const Discretization<dim> *discretization = nullptr;
    std::vector<unsigned int>  body_of_node;
    Vector                     node_masses; ///< row sums of M; empty without damping
    std::vector<Sums>          before;      ///< at the start of the step

    std::vector<Sums> sums(const State &state, const Vector *load, const Vector *support) const;
  };
} // namespace signorini

#endif
