// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/box_shape.h>
#include <signorini/shapes/cap.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace signorini
{
  template <int dim>
  void declare_box_shape(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const List point(Double(), dim, dim);
    prm.declare_entry(
      "Lower corner", dim == 2 ? "0, 0" : "0, 0, 0", point, "Box: smallest coordinates (length).");
    prm.declare_entry(
      "Upper corner", dim == 2 ? "1, 1" : "1, 1, 1", point, "Box: largest coordinates (length).");
    prm.declare_entry(
      "Repetitions",
      dim == 2 ? "1, 1" : "1, 1, 1",
      List(Integer(), dim, dim),
      "Box: number of coarse cells in each direction, at most a million together. Cells should be "
      "nearly cubes. Every process keeps all coarse cells: make fine meshes by Refinements.");
  }


  template <int dim>
  void declare_cap(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Cap radius",
                      "0",
                      Double(),
                      std::string("Box: radius (length) of the ") + (dim == 2 ? "circle" : "sphere")
                        + " that the face `Cap boundary` becomes part of. It bulges outwards: its "
                          "centre stays where it is and its edges recede. 0: all faces are flat.");
    prm.declare_entry(
      "Cap boundary",
      "",
      Anything(),
      "Box: boundary id of the face that becomes curved, if `Cap radius` is given.");
  }


  namespace
  {
    template <int dim>
    dealii::types::boundary_id parse_face(const SectionReader &in, const BoxShape<dim> &box)
    {
      std::vector<std::string> valid;
      for (const dealii::types::boundary_id id : box.boundary_ids())
        valid.push_back(std::to_string(id));
      const auto position = std::find(valid.begin(), valid.end(), in.text("Cap boundary"));
      if (position == valid.end())
        in.fail("Cap boundary",
                "must be the boundary id of the face that `Cap radius` curves: " + join(valid)
                  + ".");
      return position - valid.begin();
    }


    template <int dim>
    void parse_cap(const SectionReader &in, BoxShape<dim> &box)
    {
      box.cap_radius = in.number("Cap radius");
      if (box.cap_radius < 0.)
        in.fail("Cap radius",
                "must not be negative: a cap bulges outwards. Give a positive radius, or 0 for a "
                "flat face.");
      if (box.cap_radius == 0.)
        return;
      box.cap_boundary     = parse_face(in, box);
      const double invalid = Cap<dim>(box).largest_invalid_radius();
      if (!(box.cap_radius > invalid))
        {
          std::ostringstream message;
          message << "the cap does not fit: it must reach all edges of the face "
                  << box.cap_boundary
                  << " and must not reach the opposite face. Give a radius larger than " << invalid
                  << '.';
          in.fail("Cap radius", message.str());
        }
    }
  } // namespace


  template <int dim>
  std::shared_ptr<const BodyShape<dim>> parse_box_shape(const SectionReader &in)
  {
    constexpr unsigned int max_repetitions         = 1000000;
    const std::string      directions              = "xyz";
    const auto             box                     = std::make_shared<BoxShape<dim>>();
    std::tie(box->lower_corner, box->upper_corner) = in.corners<dim>();
    const dealii::Point<dim> repetitions           = in.point<dim>("Repetitions");
    for (unsigned int d = 0; d < dim; ++d)
      {
        if (repetitions[d] < 1 || repetitions[d] > max_repetitions)
          in.fail("Repetitions",
                  std::string("a box needs at least one cell in ") + directions[d]
                    + " direction and at most a million. Give positive integers.");
        box->repetitions[d] = static_cast<unsigned int>(repetitions[d]);
      }
    parse_cap(in, *box);
    return box;
  }


  template void declare_box_shape<2>(dealii::ParameterHandler &);
  template void declare_box_shape<3>(dealii::ParameterHandler &);
  template void declare_cap<2>(dealii::ParameterHandler &);
  template void declare_cap<3>(dealii::ParameterHandler &);

  template std::shared_ptr<const BodyShape<2>> parse_box_shape(const SectionReader &);
  template std::shared_ptr<const BodyShape<3>> parse_box_shape(const SectionReader &);
} // namespace signorini
