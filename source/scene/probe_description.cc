// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace signorini
{
  template <int dim>
  void declare_probe(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Point",
                      dim == 2 ? "0, 0" : "0, 0, 0",
                      List(Double(), dim, dim),
                      "Place in the undeformed body (length). Without `Body` the probe is the node "
                      "of a contact surface that is closest to it.");
    prm.declare_entry("Body",
                      "",
                      Anything(),
                      "Name of a body: the probe is this point of it, inside or on its surface, "
                      "and its table has position, displacement, velocity and stress.");
  }

  template <int dim>
  void parse_probe(const SectionReader &in, const std::string &name, Scene<dim> &scene)
  {
    if (!in.given("Point"))
      in.fail(
        "Point",
        "the probe `" + name + "` has no place. Add `subsection " + name
          + "` with `set Point = ...` in section Probes, or remove the name from `Probes/Names`.");
    const dealii::Point<dim> point = in.point<dim>("Point");
    const std::string        body  = in.text("Body");
    if (body.empty())
      {
        if (scene.pairs.empty())
          in.fail("Point",
                  "without `Body` a probe is a node of a contact surface, but the scene has no "
                  "contact pair. Set `Body` for a point of a body, or remove the probe.");
        scene.probes.push_back({name, point});
        return;
      }
    std::vector<std::string> names;
    for (const BodyDescription<dim> &description : scene.bodies)
      names.push_back(description.name);
    const auto found = std::find(names.begin(), names.end(), body);
    if (found == names.end())
      in.fail("Body", "there is no body `" + body + "`. " + suggestion(body, names));
    scene.point_probes.push_back(
      {name, body, static_cast<unsigned int>(found - names.begin()), point});
  }

  template void declare_probe<2>(dealii::ParameterHandler &);
  template void declare_probe<3>(dealii::ParameterHandler &);
  template void parse_probe(const SectionReader &, const std::string &, Scene<2> &);
  template void parse_probe(const SectionReader &, const std::string &, Scene<3> &);
} // namespace signorini
