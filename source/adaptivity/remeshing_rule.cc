// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/remeshing_rule.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /**
     * Of a change of the mesh, in losses of a step. It takes the time of about seven steps with
     * contact, but the error of a step stays in the motion and is lost to those that follow, too:
     * runs with 2 reach a given error sooner than those with 1, 3 or 7 (doc/adaptivity.md).
     */
    constexpr double steps_per_change = 2.;

    /** So that sums that differ by round-off, from other numbers of processes, decide alike. */
    constexpr double of_sums = 1e-9;
  } // namespace


  RemeshingRule::RemeshingRule(const AdaptivityParameters &parameters)
    : steps_between(parameters.repetitions > 0 ? std::max(parameters.steps_between, 1u)
                                               : parameters.steps_between)
    , next_judgement(std::max(steps_between, 1u))
  {
  }


  bool RemeshingRule::pays(const MeshChange  &change,
                           const unsigned int step,
                           const unsigned int longest_wait)
  {
    const double n_steps = step - last_judgement;
    last_judgement       = step;
    if (steps_between > 0)
      {
        next_judgement = step + steps_between;
        return change.any();
      }
    if (step == 0) // no step has been made: a change costs nothing, and the estimate is none
      {
        next_judgement = 1;
        return change.any();
      }
    if (is_new)
      squared_estimate_of_new_mesh = change.estimate * change.estimate;
    is_new            = false;
    const double loss = loss_of_a_step(change);
    lost += n_steps * loss;
    const double left = steps_per_change - lost - of_sums;
    next_judgement    = step + 1;
    if ((change.refines() && change.is_urgent) || (change.any() && left <= 0.))
      return true;
    if (left > loss)
      next_judgement =
        step
        + static_cast<unsigned int>(std::min(left / std::max(loss, of_sums), double(longest_wait)));
    return false;
  }


  double RemeshingRule::loss_of_a_step(const MeshChange &change) const
  {
    if (!change.any())
      return 0.;
    const double square = change.estimate * change.estimate;
    const double growth = square > squared_estimate_of_new_mesh
                            ? std::min(square / std::max(squared_estimate_of_new_mesh, 1e-300),
                                       steps_per_change / of_sums)
                            : 1.;
    return (change.refines() ? change.error_part * growth : 0.) + change.spared_part;
  }


  void RemeshingRule::mesh_changes(const unsigned int step)
  {
    lost           = 0.;
    is_new         = true;
    last_judgement = step;
    if (steps_between == 0)
      next_judgement = step + 1;
  }
} // namespace signorini
