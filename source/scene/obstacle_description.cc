// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/obstacles/obstacle_table.h>
#include <signorini/prm/unused_keys.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <map>

namespace signorini
{
  template <int dim>
  void declare_obstacle(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    std::vector<std::string> names, summaries;
    for (const ObstacleShape<dim> &shape : obstacle_shapes<dim>())
      {
        names.emplace_back(shape.name);
        summaries.emplace_back(shape.summary);
      }
    prm.declare_entry("Shape",
                      names.front(),
                      Selection(join(names, "|")),
                      "One of: " + join(summaries, ", ") + ".");
    prm.declare_entry(
      "Point",
      (dim == 2 ? "0, 0" : "0, 0, 0"),
      List(Double(), dim, dim),
      "Plane: a point of its surface, with `Extent` the middle of it; cylinder: a point "
      "of its axis (length).");
    for (const ObstacleShape<dim> &shape : obstacle_shapes<dim>())
      shape.declare(prm);
  }


  namespace
  {
    template <int dim>
    void refuse_keys_of_others(const SectionReader &in, const ObstacleShape<dim> &own)
    {
      dealii::ParameterHandler declared;
      declare_obstacle<dim>(declared);
      std::map<std::string, std::vector<std::string>> owners;
      for (const ObstacleShape<dim> &shape : obstacle_shapes<dim>())
        for (const std::string &key : shape.keys)
          owners[key].emplace_back(shape.name);
      for (const auto &[key, shapes] : owners)
        if (std::find(own.keys.begin(), own.keys.end(), key) == own.keys.end())
          refuse_without_effect(in, key, declared, "the shape " + join(shapes, " or "), "Shape");
    }
  } // namespace


  template <int dim>
  NamedObstacle<dim> parse_obstacle(const SectionReader &in, const std::string &name)
  {
    if (!in.given())
      in.fail("",
              "`Obstacles/Names` lists this obstacle, but it has no subsection. Add `subsection "
                + name + " ... end` in section Obstacles, or remove the name from the list.");
    const auto &shapes = obstacle_shapes<dim>();
    const auto  shape =
      std::find_if(shapes.begin(), shapes.end(), [&](const ObstacleShape<dim> &candidate) {
        return candidate.name == in.text("Shape");
      });
    refuse_keys_of_others(in, *shape);
    return {name, shape->parse(in, name)};
  }


#define INSTANTIATE(dim)                                                                           \
  template void               declare_obstacle<dim>(dealii::ParameterHandler &);                   \
  template NamedObstacle<dim> parse_obstacle<dim>(const SectionReader &, const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
