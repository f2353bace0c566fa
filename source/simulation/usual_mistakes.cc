// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/spelling.h>
#include <signorini/simulation/usual_mistakes.h>

#include <algorithm>
#include <cmath>
#include <sstream>

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


    /** Courant number of steps in which a wave goes so far that nodes feel each other's stiffness.
     */
    constexpr double long_step = 40.;

    /** A body with less than its inverse of the stiffness can carry another one. */
    constexpr double much_stiffer = 30.;

    template <int dim>
    double youngs_modulus(const Scene<dim> &scene, const unsigned int body)
    {
      return scene.bodies[body].material.youngs_modulus;
    }


    /** A pair with its sides exchanged, as a scene writes it. */
    std::string exchanged(const std::string &pair)
    {
      const std::size_t colon = pair.find(':');
      return trim(pair.substr(colon + 1)) + " : " + trim(pair.substr(0, colon));
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


  template <int dim>
  std::vector<std::string> stiff_slaves(const Scene<dim> &scene, const double courant_number)
  {
    std::vector<std::string> result;
    if (scheme_info(scene.time.scheme).inertia && courant_number <= long_step)
      return result;
    for (const PairDescription &pair : scene.pairs)
      {
        const double ratio = pair.of_two_bodies() ? youngs_modulus(scene, pair.slave)
                                                      / youngs_modulus(scene, pair.master)
                                                  : 0.;
        if (ratio <= much_stiffer)
          continue;
        std::ostringstream text;
        text << "the pair '" << pair.name << "' names the body first that is " << std::round(ratio)
             << " times as stiff. Each of its nodes has to fit the soft surface, which takes the "
                "solvers many times the iterations, and meshes for a target more cells. Write "
                "`Pairs = "
             << exchanged(pair.name) << "`.";
        result.push_back(text.str());
      }
    return result;
  }


  template std::vector<std::string> usual_mistakes(const Scene<2> &, const Preflight &);
  template std::vector<std::string> usual_mistakes(const Scene<3> &, const Preflight &);
  template std::vector<std::string> stiff_slaves(const Scene<2> &, double);
  template std::vector<std::string> stiff_slaves(const Scene<3> &, double);
} // namespace signorini
