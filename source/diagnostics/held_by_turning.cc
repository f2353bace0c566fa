// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/body_motion.h>
#include <signorini/diagnostics/held_by_turning.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    /** Of the moment of friction: what soft bodies that are held reach by their deformation. */
    constexpr double most_out_of_balance = 0.5;
    constexpr double hardly_turned       = 1e-3; ///< radians: what a body does by its deformation
    /** Of the moments of all forces of friction. */
    constexpr double round_off          = 1e-6;
    constexpr double radians_per_degree = 3.14159265358979324 / 180.;
  } // namespace


  template <int dim>
  std::vector<std::string> held_by_turning(const Discretization<dim> &discretization,
                                           const State               &equilibrium)
  {
    std::vector<std::string> result;
    if (equilibrium.friction.force.size() == 0)
      return result;
    const BodyMotion<dim>     motion(discretization);
    const std::vector<double> of_friction = motion.moments(equilibrium.friction.force),
                              by_turning  = motion.moments(equilibrium.contact_force,
                                                          &equilibrium.displacement),
                              angles      = motion.rotation(equilibrium.displacement);
    const double all_moments =
      equilibrium.friction.force.l1_norm() * discretization.mesh().body_size();
    for (unsigned int body = 0; body < angles.size(); ++body)
      if (by_turning[body] > most_out_of_balance * of_friction[body]
          && of_friction[body] > round_off * all_moments && angles[body] > hardly_turned)
        {
          std::ostringstream text;
          text.precision(3);
          text
            << "Time/Start = equilibrium holds the body '"
            << discretization.mesh().bodies()[body].name << "' because it turned by "
            << angles[body] / radians_per_degree
            << " degrees: linear strains let what bears it resist that, as if it lay on a flat. A "
               "round body rolls, or spins up. Set `Start = given`.";
          result.push_back(text.str());
        }
    return result;
  }


  template std::vector<std::string> held_by_turning(const Discretization<2> &, const State &);
  template std::vector<std::string> held_by_turning(const Discretization<3> &, const State &);
} // namespace signorini
