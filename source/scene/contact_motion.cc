// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// `Contact/Motion`: which scenes contact can follow.

#include <signorini/base/spelling.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    const std::string or_linearised = ", or set `Motion = linearised`.";

    /** Whether no normal ever turns and no obstacle moves. */
    template <int dim>
    bool only_flat_obstacles_at_rest(const Scene<dim> &scene)
    {
      return std::all_of(scene.pairs.begin(), scene.pairs.end(), [&](const PairDescription &pair) {
        return !pair.of_two_bodies() && scene.obstacles[pair.obstacle].shape->is_flat()
               && !scene.obstacles[pair.obstacle].motion;
      });
    }
  } // namespace


  void declare_contact_motion(dealii::ParameterHandler &prm)
  {
    prm.declare_entry(
      "Motion",
      name_of(ContactMotion::linearised),
      choices_of<ContactMotion>(),
      "What normals, gaps and obstacles of contact nodes belong to. linearised: to the initial "
      "configuration, once for all, as in small motions; follow: to the motion of each step, so "
      "that nodes slide along curved obstacles and from one to the next.");
  }


  template <int dim>
  ContactMotion parse_contact_motion(const SectionReader &in, const Scene<dim> &scene)
  {
    const ContactMotion motion = in.choice<ContactMotion>("Motion");
    if (motion == ContactMotion::linearised)
      {
        for (const NamedObstacle<dim> &obstacle : scene.obstacles)
          if (obstacle.motion)
            in.fail("Motion",
                    "linearised contact does not know that the obstacle '" + obstacle.name
                      + "' moves. Set `Motion = follow`, or let the obstacle rest.");
        for (const PairDescription &pair : scene.pairs)
          if (pair.slave == pair.master)
            in.fail("Motion",
                    "linearised contact knows no contact of a body with itself, as in `" + pair.name
                      + "`. Set `Motion = follow`, or remove the pair.");
        return motion;
      }
    const std::string head = name_of(motion) + std::string(" ");
    if (const SchemeInfo &scheme = scheme_info(scene.time.scheme);
        !scheme.moving_contact && (scheme.penetrates || !only_flat_obstacles_at_rest(scene)))
      in.fail(
        "Motion",
        head + "does not go with Time/Scheme = " + scheme.name + ", which " + scheme.why_linearised
          + ". Take one of the schemes "
          + join(schemes_where([](const SchemeInfo &info) { return info.moving_contact; }), ", ")
           + or_linearised);
    return motion;
  }

  template ContactMotion parse_contact_motion(const SectionReader &, const Scene<2> &);
  template ContactMotion parse_contact_motion(const SectionReader &, const Scene<3> &);
} // namespace signorini
