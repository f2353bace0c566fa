// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/body_shape.h>
#include <signorini/model/cap.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
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
    dealii::types::boundary_id parse_face(const SectionReader &in, const BodyDescription<dim> &body)
    {
      std::vector<std::string> valid;
      for (const dealii::types::boundary_id id : boundary_ids(body))
        valid.push_back(std::to_string(id));
      const auto position = std::find(valid.begin(), valid.end(), in.text("Cap boundary"));
      if (position == valid.end())
        in.fail("Cap boundary",
                "must be the boundary id of the face that `Cap radius` curves: " + join(valid)
                  + ".");
      return position - valid.begin();
    }
  } // namespace

  template <int dim>
  void parse_cap(const SectionReader &in, BodyDescription<dim> &body)
  {
    body.cap_radius = in.number("Cap radius");
    if (body.shape != BodyShape::box)
      {
        const std::string remedy = "only a face of a box can be curved, but this body has `Shape = "
                                   + name_of(body.shape) + "`. Remove this key, or use a box.";
        if (body.cap_radius != 0.)
          in.fail("Cap radius", remedy);
        if (!in.text("Cap boundary").empty())
          in.fail("Cap boundary", remedy);
        return;
      }
    if (body.cap_radius < 0.)
      in.fail("Cap radius",
              "must not be negative: a cap bulges outwards. Give a positive radius, or 0 for a "
              "flat face.");
    if (body.cap_radius == 0.)
      return;
    body.cap_boundary    = parse_face(in, body);
    const double invalid = Cap<dim>(body).largest_invalid_radius();
    if (!(body.cap_radius > invalid))
      {
        std::ostringstream message;
        message << "the cap does not fit: it must reach all edges of the face " << body.cap_boundary
                << " and must not reach the opposite face. Give a radius larger than " << invalid
                << '.';
        in.fail("Cap radius", message.str());
      }
  }

#define INSTANTIATE(dim)                                                                           \
  template void declare_cap<dim>(dealii::ParameterHandler &);                                      \
  template void parse_cap(const SectionReader &, BodyDescription<dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
