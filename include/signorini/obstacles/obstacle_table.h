// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_obstacle_table_h
#define signorini_obstacles_obstacle_table_h

#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/prm/section_reader.h>

#include <vector>

namespace signorini
{
  /** A shape that a scene can give to an obstacle: `set Shape = <name>`. */
  template <int dim>
  struct ObstacleShape
  {
    const char *name;
    const char *summary; ///< what it is, for the list of all keys

    /** Declares its keys, but for `Point`. Shapes may share keys. */
    void (*declare)(dealii::ParameterHandler &prm);

    std::vector<std::string> keys; ///< all that it looks at

    /** @param name of the obstacle. @throws UserError for values that make no obstacle */
    std::shared_ptr<const RigidObstacle<dim>> (*parse)(const SectionReader &in,
                                                       const std::string   &name);
  };

  /** All shapes; the first one is the default. */
  template <int dim>
  const std::vector<ObstacleShape<dim>> &obstacle_shapes();

  /** One more, from a plug-in. @throws UserError if its name is taken */
  template <int dim>
  void add_obstacle_shape(const ObstacleShape<dim> &shape);
} // namespace signorini

#endif
