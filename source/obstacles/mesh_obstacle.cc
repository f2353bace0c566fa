// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/model/placement.h>
#include <signorini/obstacles/mesh_obstacle.h>
#include <signorini/obstacles/surface_crossing.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double touching = 1e-10; ///< over the size of the surface
  }


  template <int dim>
  MeshObstacle<dim>::MeshObstacle(std::shared_ptr<const FacetedSurface<dim>> shape,
                                  std::string                                path)
    : FacetedObstacle<dim>(shape)
    , path(std::move(path))
    , meeting(shape->n_sides())
  {
    bool any = false;
    for (unsigned int f = 0; f < shape->facets().size(); ++f)
      for (unsigned int i = 0; i < dim; ++i)
        if (shape->is_inner_corner(f, i))
          {
            const auto &facet = shape->facets()[f];
            meeting[facet.side].insert(shape->facets()[facet.neighbours[i]].side);
            any = true;
          }
    for (unsigned int side = 0; any && side < shape->n_sides(); ++side)
      parts.push_back(std::make_shared<FacetedObstacle<dim>>(shape, side));
  }


  template <int dim>
  std::vector<unsigned int> MeshObstacle<dim>::sides_near(const Point<dim> &start,
                                                          const Point<dim> &end,
                                                          const double      reach) const
  {
    if (parts.empty())
      return {};
    const double       tolerance = touching * this->surface->size();
    const unsigned int own = this->side_at(start), last = this->side_at(end);
    const auto         gap = [&](const unsigned int side) {
      const auto way = parts[side]->project(start);
      return way.is_carried(tolerance) && way.gap >= -tolerance
                       ? way.gap
                       : std::numeric_limits<double>::infinity();
    };
    if (meeting[own].empty() || !(gap(own) <= reach))
      return {};
    std::set<std::pair<double, unsigned int>> others;
    for (const unsigned int side : this->sides_around(start, reach + tolerance))
      if (meeting[own].count(side) > 0)
        if (const double height = gap(side); height <= reach + tolerance)
          others.emplace(side == last ? 0. : height, side);
    const auto is_last = [&](const auto &other) { return other.second == last; };
    if (others.empty() || (own != last && std::none_of(others.begin(), others.end(), is_last)))
      return {};
    std::vector<unsigned int> result = {own};
    for (const auto &[height, side] : others)
      if (result.size() < dim)
        result.push_back(side);
    return result;
  }


  template <int dim>
  std::vector<std::array<Point<dim>, dim>> MeshObstacle<dim>::facets() const
  {
    std::vector<std::array<Point<dim>, dim>> result;
    for (unsigned int f = 0; f < this->surface->facets().size(); ++f)
      result.push_back(this->surface->corners(f));
    return result;
  }


  template <int dim>
  void declare_mesh_obstacle(ParameterHandler &prm)
  {
    prm.declare_entry(
      "File",
      "",
      Patterns::Anything(),
      dim == 2 ? "Mesh: a line (.obj, or .vtk, legacy up to 4.2, text), or a mesh of "
                 "cells as for bodies, whose boundary counts; absolute or relative to "
                 "the folder of the scene. A closed line has the obstacle inside."
               : "Mesh: a surface of triangles or polygons (.stl, .obj, or .vtk, legacy up to 4.2, "
                 "text), or a mesh of cells as for bodies, whose boundary counts; absolute or "
                 "relative to the folder of the scene. A closed surface has the obstacle inside.");
    prm.declare_entry(
      "Open",
      "false",
      Patterns::Bool(),
      dim == 2 ? "Mesh: the line ends. The obstacle is to the left of it, as one goes from "
                 "the first point of a segment to the second; a node past the end is not "
                 "carried."
               : "Mesh: the surface ends. The bodies are where the corners of triangles "
                 "are seen counterclockwise; a node past the end is not carried.");
    prm.declare_entry("Scale",
                      "1",
                      Patterns::Double(),
                      "Mesh: all coordinates of the file are multiplied by this number > 0, first "
                      "of all.");
    if (dim == 2)
      prm.declare_entry("Rotation",
                        "0",
                        Patterns::Double(),
                        "Mesh: angle in degrees, counter-clockwise, by which the obstacle is "
                        "turned from the start on, about the centre of the box around it.");
    else
      prm.declare_entry("Rotation",
                        "0, 0, 0",
                        Patterns::List(Patterns::Double(), dim, dim),
                        "Mesh: angles in degrees by which the obstacle is turned from the start "
                        "on, about the centre of the box around it: about the x axis first, then "
                        "about the y axis, then about the z axis (axes of space).");
    prm.declare_entry("Translation",
                      (dim == 2 ? "0, 0" : "0, 0, 0"),
                      Patterns::List(Patterns::Double(), dim, dim),
                      "Mesh: vector (length) by which the obstacle is moved from the start on, "
                      "after the rotation.");
  }


  namespace
  {
    template <int dim>
    void place_mesh(const SectionReader &in, FacetMesh<dim> &mesh)
    {
      const double            scale = in.positive_number("Scale", "it changes the unit of length");
      std::vector<Point<dim>> used;
      for (auto &vertex : mesh.vertices)
        vertex *= scale;
      for (const auto &facet : mesh.facets)
        for (const unsigned int v : facet)
          used.push_back(mesh.vertices[v]);
      const Placement<dim> placement(
        in.angles<dim>("Rotation"), BoundingBox<dim>(used).center(), in.point<dim>("Translation"));
      for (auto &vertex : mesh.vertices)
        vertex = placement.place(vertex);
    }
  } // namespace


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_mesh_obstacle(const SectionReader &in,
                                                                const std::string &)
  {
    const std::string key = "File", path = in.path(key);
    if (in.text(key).empty())
      in.fail(key, "an obstacle of shape `mesh` needs a surface. Give the name of a mesh file.");
    const auto refuse_user_errors = [&](const std::string &prefix, const auto &action) {
      try
        {
          return action();
        }
      catch (const UserError &error)
        {
          in.fail(key, prefix + error.what());
        }
    };
    auto mesh = refuse_user_errors("", [&] { return read_facet_mesh<dim>(path); });
    place_mesh(in, mesh);
    const auto surface = refuse_user_errors(path + ": ", [&] {
      auto built = std::make_shared<FacetedSurface<dim>>(mesh, in.flag("Open"));
      check_that_nothing_crosses(*built);
      return built;
    });
    if (in.flag("Bodies inside"))
      surface->turn_inside_out();
    return std::make_shared<MeshObstacle<dim>>(surface, path);
  }


#define INSTANTIATE(dim)                                                                           \
  template class MeshObstacle<dim>;                                                                \
  template void declare_mesh_obstacle<dim>(ParameterHandler &);                                    \
                                                                                                   \
  template std::shared_ptr<const RigidObstacle<dim>> parse_mesh_obstacle(const SectionReader &,    \
                                                                         const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
