// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/table_of_kinds.h>
#include <signorini/shapes/ball_shape.h>
#include <signorini/shapes/box_shape.h>
#include <signorini/shapes/cylinder_shape.h>
#include <signorini/shapes/mesh_file_shape.h>
#include <signorini/shapes/round_shapes.h>
#include <signorini/shapes/shape_table.h>

namespace signorini
{
  namespace
  {
    template <int dim>
    std::vector<BodyShapeKind<dim>> &table()
    {
      static std::vector<BodyShapeKind<dim>> shapes{
        {"ball",
         "balls",
         "ball (in 2d: a disc; boundary id 0)",
         declare_round_shapes<dim>,
         {"Centre", "Radius"},
         parse_ball_shape<dim>},
        {"box",
         "boxes",
         "box (boundary ids 0, 1: x-, x+; 2, 3: y-, y+; 4, 5: z-, z+)",
         declare_box_shape<dim>,
         {"Lower corner", "Upper corner", "Repetitions", "Cap radius", "Cap boundary"},
         parse_box_shape<dim>},
        {"cylinder",
         "cylinders",
         "cylinder (3d; boundary ids 0 mantle, 1 bottom, 2 top)",
         declare_round_shapes<dim>,
         {"Centre", "Radius", "Length", "Axis", "Axial cells"},
         parse_cylinder_shape<dim>},
        {"file",
         "bodies from mesh files",
         "file (a mesh; boundary ids of the file)",
         declare_mesh_file_shape,
         {"File", "Part", "Scale"},
         parse_mesh_file_shape<dim>}};
      return shapes;
    }
  } // namespace


  template <int dim>
  const std::vector<BodyShapeKind<dim>> &body_shapes()
  {
    return table<dim>();
  }


  template <int dim>
  void add_body_shape(const BodyShapeKind<dim> &shape)
  {
    add_kind(table<dim>(), shape, "shape of bodies");
  }


  template const std::vector<BodyShapeKind<2>> &body_shapes();
  template const std::vector<BodyShapeKind<3>> &body_shapes();
  template void                                 add_body_shape(const BodyShapeKind<2> &);
  template void                                 add_body_shape(const BodyShapeKind<3> &);
} // namespace signorini
