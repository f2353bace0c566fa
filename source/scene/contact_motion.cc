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

    /** What the key says; `automatic` follows where that is possible. */
    enum class MotionChoice
    {
      automatic,
      follow,
      linearised
    };

    /** Whether no normal ever turns and no obstacle moves. */
    template <int dim>
    bool only_flat_obstacles_at_rest(const Scene<dim> &scene)
    {
      return std::all_of(scene.pairs.begin(), scene.pairs.end(), [&](const PairDescription &pair) {
        return !pair.of_two_bodies() && scene.obstacles[pair.obstacle].shape->is_flat()
               && !scene.obstacles[pair.obstacle].motion;
      });
    }


    /** Why contact of a scene cannot follow the motion; empty if it can. */
    template <int dim>
    std::string why_not_follow(const Scene<dim> &scene)
    {
      const SchemeInfo &scheme = scheme_info(scene.time.scheme);
      if (scheme.moving_contact || (!scheme.penetrates && only_flat_obstacles_at_rest(scene)))
        return "";
      return "Time/Scheme = " + scheme.name + ", which " + scheme.why_linearised;
    }


    /**
     * The schemes that follow the motion and that the scene could take instead of its own.
     */
    template <int dim>
    std::string schemes_that_follow(const Scene<dim> &scene)
    {
      const SchemeInfo &scheme        = scheme_info(scene.time.scheme);
      const bool        with_friction = has_friction(scene.pairs);
      const bool        massless      = scene.time.mass.has_massless_contact_nodes();
      return join(schemes_where([&](const SchemeInfo &info) {
                    return info.moving_contact && info.inertia == scheme.inertia
                           && (info.friction || !with_friction)
                           && info.massless
                                != (massless ? MasslessNodesAre::refused
                                             : MasslessNodesAre::needed);
                  }),
                  ", ");
    }


    /** See Scene::how_to_follow. @param cannot why the scheme does not follow; empty if it does */
    template <int dim>
    std::string how_to_follow(const Scene<dim> &scene, const std::string &cannot)
    {
      if (cannot.empty())
        return set_motion_to_follow;
      return "take one of the schemes " + schemes_that_follow(scene)
             + " (`Time/Scheme`) with `Contact/Motion = follow`, as " + scene.time.scheme
             + " cannot";
    }


    /** What contact follows only where the scene says so; empty if there is nothing of the kind. */
    template <int dim>
    std::string why_only_if_asked(const Scene<dim> &scene)
    {
      // All nodes of a surface would lose their mass.
      if (scene.time.mass.has_massless_contact_nodes())
        return "contact nodes without mass";
      // They settle slowly where the geometry of two bodies follows.
      if (!scheme_info(scene.time.scheme).inertia
          && std::any_of(scene.pairs.begin(), scene.pairs.end(), [](const PairDescription &pair) {
               return pair.of_two_bodies() && pair.slave != pair.master;
             }))
        return "load steps of two bodies";
      return "";
    }


    /** Contact that does not follow needs bodies and obstacles that go with that. */
    template <int dim>
    void check_linearised(const SectionReader &in, const Scene<dim> &scene, const std::string &why)
    {
      const std::string remedy = why.empty()
                                   ? "Set `Motion = follow`"
                                   : "Take one of the schemes " + schemes_that_follow(scene);
      for (const NamedObstacle<dim> &obstacle : scene.obstacles)
        if (obstacle.motion)
          in.fail("Motion",
                  "linearised contact does not know that the obstacle '" + obstacle.name + "' moves"
                    + (why.empty() ? "" : ", and contact cannot follow with " + why) + ". " + remedy
                    + ", or let the obstacle rest.");
      for (const PairDescription &pair : scene.pairs)
        if (pair.slave == pair.master)
          in.fail("Motion",
                  "linearised contact knows no contact of a body with itself, as in `" + pair.name
                    + "`" + (why.empty() ? "" : ", and contact cannot follow with " + why) + ". "
                    + remedy + ", or remove the pair.");
    }
  } // namespace


  template <>
  struct EnumNames<MotionChoice>
  {
    static constexpr EnumName<MotionChoice> table[] = {{MotionChoice::automatic, "automatic"},
                                                       {MotionChoice::follow, "follow"},
                                                       {MotionChoice::linearised, "linearised"}};
  };


  void declare_contact_motion(dealii::ParameterHandler &prm)
  {
    prm.declare_entry(
      "Motion",
      name_of(MotionChoice::automatic),
      choices_of<MotionChoice>(),
      "What normals, gaps and partners of contact nodes belong to. follow: to the motion of each "
      "step, so that bodies slide along curved obstacles and each other, and from one to the next; "
      "linearised: to the initial configuration, once for all, as in small motions; automatic: "
      "follow, but with schemes that cannot, contact nodes without mass, and load steps of two "
      "bodies (a note says so).");
  }


  template <int dim>
  void parse_contact_motion(const SectionReader &in, Scene<dim> &scene)
  {
    const MotionChoice choice        = in.choice<MotionChoice>("Motion");
    const std::string  cannot        = why_not_follow(scene);
    const std::string  only_if_asked = why_only_if_asked(scene);
    scene.how_to_follow              = how_to_follow(scene, cannot);
    if (choice == MotionChoice::follow && !cannot.empty())
      in.fail("Motion",
              "follow does not go with " + cannot + ". Take one of the schemes "
                + schemes_that_follow(scene) + or_linearised);
    if (choice == MotionChoice::follow
        || (choice == MotionChoice::automatic && cannot.empty() && only_if_asked.empty()))
      {
        scene.motion = ContactMotion::follow;
        return;
      }
    check_linearised(in, scene, cannot);
    scene.motion = ContactMotion::linearised;
    if (choice == MotionChoice::automatic)
      scene.why_linearised = !cannot.empty()
                               ? "it cannot follow the motion with " + cannot
                               : "with " + only_if_asked
                                   + " it follows the motion only if `Motion = follow` asks for it";
  }

  template void parse_contact_motion(const SectionReader &, Scene<2> &);
  template void parse_contact_motion(const SectionReader &, Scene<3> &);
} // namespace signorini
