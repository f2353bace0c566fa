// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/table_of_kinds.h>
#include <signorini/obstacles/box_obstacle.h>
#include <signorini/obstacles/level_set.h>
#include <signorini/obstacles/mesh_obstacle.h>
#include <signorini/obstacles/obstacle_table.h>
#include <signorini/obstacles/plane.h>
#include <signorini/obstacles/round_obstacle.h>

namespace signorini
{
  using Keys = std::vector<std::string>;

  namespace
  {
    template <int dim>
    std::vector<ObstacleShape<dim>> &table()
    {
      static std::vector<ObstacleShape<dim>> shapes{
        {"plane",
         "plane",
         declare_plane<dim>,
         dim == 2 ? Keys{"Point", "Normal", "Extent"}
                  : Keys{"Point", "Normal", "Extent", "Extent direction"},
         parse_plane<dim>},
        {"sphere",
         "sphere (in 2d: a circle)",
         declare_sphere<dim>,
         {"Centre", "Radius", "Bodies inside"},
         parse_sphere<dim>},
        {"cylinder",
         "cylinder (3d, of infinite length)",
         declare_cylinder<dim>,
         {"Point", "Radius", "Bodies inside", "Axis"},
         parse_cylinder<dim>},
        {"box",
         "box (2d: rectangle) along the axes",
         declare_box<dim>,
         {"Lower corner", "Upper corner"},
         parse_box<dim>},
        {"mesh",
         dim == 2 ? "mesh (a line from a file)" : "mesh (a surface from a file)",
         declare_mesh_obstacle<dim>,
         {"File", "Open", "Bodies inside", "Scale", "Rotation", "Translation"},
         parse_mesh_obstacle<dim>},
        {"function",
         "function (the zero set of an expression)",
         declare_level_set,
         {"Signed distance"},
         parse_level_set<dim>}};
      return shapes;
    }
  } // namespace


  template <int dim>
  const std::vector<ObstacleShape<dim>> &obstacle_shapes()
  {
    return table<dim>();
  }


  template <int dim>
  void add_obstacle_shape(const ObstacleShape<dim> &shape)
  {
    add_kind(table<dim>(), shape, "shape of obstacles");
  }


  template const std::vector<ObstacleShape<2>> &obstacle_shapes();
  template const std::vector<ObstacleShape<3>> &obstacle_shapes();
  template void                                 add_obstacle_shape(const ObstacleShape<2> &);
  template void                                 add_obstacle_shape(const ObstacleShape<3> &);
} // namespace signorini
