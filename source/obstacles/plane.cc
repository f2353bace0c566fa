// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/obstacles/plane.h>
#include <signorini/prm/check_expressions.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <cmath>
#include <optional>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    const std::string default_extent_direction = "1, 0, 0";
  }


  template <int dim>
  Plane<dim>::Plane(const Point<dim> &point, const Tensor<1, dim> &normal, std::vector<End> ends)
    : point(point)
    , normal(normal / normal.norm())
    , ends(std::move(ends))
  {
  }


  template <int dim>
  ObstacleProjection<dim> Plane<dim>::project(const Point<dim> &p) const
  {
    const Tensor<1, dim>    arm = p - point;
    ObstacleProjection<dim> projection{arm * normal, -normal};
    for (const End &end : ends)
      projection.beyond = std::max(projection.beyond, std::abs(arm * end.tangent) - end.reach);
    return projection;
  }


  template <int dim>
  void declare_plane(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Normal",
      (dim == 2 ? "0, 1" : "0, 0, 1"),
      Patterns::List(Patterns::Double(), dim, dim),
      "Plane: points out of the obstacle, towards the bodies; any length but zero.");
    prm.declare_entry(
      "Extent",
      "",
      Patterns::Anything(),
      dim == 2
        ? "Plane: its length; `Point` is its middle. Empty: without end. The obstacle is what is "
          "below; a node past the end is not carried."
        : "Plane: its two lengths, along `Extent direction` and at right angles to it; `Point` is "
          "its "
          "middle. Empty: without end. The obstacle is what is below; a node past the end is not "
          "carried.");
    if (dim == 3)
      prm.declare_entry("Extent direction",
                        default_extent_direction,
                        Patterns::List(Patterns::Double(), dim, dim),
                        "Plane with `Extent`: direction of the first length; any length but zero. "
                        "Its part along `Normal` does not count.");
  }


  namespace
  {
    template <int dim>
    std::array<Tensor<1, dim>, dim - 1> tangents(const SectionReader  &in,
                                                 const Tensor<1, dim> &normal)
    {
      if constexpr (dim == 2)
        return {{Tensor<1, 2>({-normal[1], normal[0]})}};
      else
        {
          Tensor<1, 3> first = in.direction<3>("Extent direction");
          first /= first.norm();
          first -= (first * normal) * normal;
          if (first.norm() < 1e-6)
            in.fail("Extent direction",
                    "is the direction of `Normal`, and says nothing about the directions in the "
                    "plane. Give one that lies in the plane.");
          first /= first.norm();
          return {{first, cross_product_3d(normal, first)}};
        }
    }


    template <int dim>
    std::vector<typename Plane<dim>::End> parse_ends(const SectionReader  &in,
                                                     const Tensor<1, dim> &normal)
    {
      const std::string text = in.text("Extent");
      if (text.empty())
        {
          if (dim == 3 && in.text("Extent direction") != default_extent_direction)
            in.fail("Extent direction",
                    "has no effect without `Extent`. Give the lengths, or remove it.");
          return {};
        }
      const std::vector<std::string>        lengths = split(text, ',');
      std::vector<typename Plane<dim>::End> ends;
      for (const Tensor<1, dim> &tangent : tangents<dim>(in, normal / normal.norm()))
        {
          const auto length = ends.size() < lengths.size() && lengths.size() == dim - 1
                                ? constant_value(lengths[ends.size()])
                                : std::nullopt;
          if (!length || !(*length > 0.) || !std::isfinite(*length))
            in.fail("Extent",
                    std::string("must be ")
                      + (dim == 2 ? "one length > 0." : "two lengths > 0, separated by a comma."));
          ends.push_back({tangent, *length / 2.});
        }
      return ends;
    }
  } // namespace


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_plane(const SectionReader &in,
                                                        const std::string &)
  {
    const Tensor<1, dim> normal = in.direction<dim>("Normal");
    return std::make_shared<Plane<dim>>(
      in.point<dim>("Point"), normal, parse_ends<dim>(in, normal));
  }


#define INSTANTIATE(dim)                                                                           \
  template class Plane<dim>;                                                                       \
  template void declare_plane<dim>(ParameterHandler &);                                            \
                                                                                                   \
  template std::shared_ptr<const RigidObstacle<dim>> parse_plane(const SectionReader &,            \
                                                                 const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
