// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/simulation/usual_mistakes.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** Whether anything but initial velocities and body forces moves the bodies. */
    template <int dim>
    bool is_driven(const Scene<dim> &scene)
    {
      const auto drives = [](const BodyDescription<dim> &body) {
        return !body.traction.empty()
               || std::any_of(
                 body.dirichlet.begin(), body.dirichlet.end(), [](const auto &condition) {
                   return has_time(condition.expressions);
                 });
      };
      return std::any_of(scene.bodies.begin(), scene.bodies.end(), drives)
             || std::any_of(scene.obstacles.begin(),
                            scene.obstacles.end(),
                            [](const auto &obstacle) { return obstacle.motion != nullptr; });
    }


    /** Nothing stops the mass of contact nodes but the step's own force, which gives it back. */
    bool forces_alternate(const SchemeInfo &scheme)
    {
      return scheme.inertia && !scheme.predictor && scheme.massless != MasslessNodesAre::needed
             && scheme.balance != StepBalance::end;
    }
  } // namespace


  template <int dim>
  std::vector<std::string> usual_mistakes(const Scene<dim> &scene, const Preflight &preflight)
  {
    std::vector<std::string> mistakes;
    if (has_friction(scene.pairs) && forces_alternate(scheme_info(scene.time.scheme)))
      mistakes.push_back("contact forces of `Time/Scheme = " + scene.time.scheme
                         + "` alternate from step to step, and Coulomb's bound with them: nodes "
                           "stick and slip by turns. Set `Time/Scheme = "
                         + scheme_table().front().name + "`.");
    if (preflight.has_inertia && !scene.pairs.empty() && preflight.impacts.empty()
        && !is_driven(scene))
      mistakes.push_back("no pair meets before `Time/End time` if the bodies fly on as they start. "
                         "Check the initial velocities, body forces and distances, or give the run "
                         "more time.");
    return mistakes;
  }


  template std::vector<std::string> usual_mistakes(const Scene<2> &, const Preflight &);
  template std::vector<std::string> usual_mistakes(const Scene<3> &, const Preflight &);
} // namespace signorini
