// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/obstacles/box_tree.h>
#include <signorini/obstacles/faceted_surface.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double same_vertex = 1e-6; ///< distance over the size: files have seven digits
    constexpr double no_area     = 1e-9; ///< of a facet, over the square of its longest edge
    constexpr double no_volume   = 1e-9; ///< of a surface, over the cube of its size
    /**
     * Sine of the angle between the normals at a crease. Two normals at a node have to be
     * independent.
     */
    constexpr double crease = 0.02;

    template <int dim>
    std::string facet_name()
    {
      return dim == 2 ? "segment" : "triangle";
    }


    /** Not of unit length: twice the area (2d: the length). */
    Tensor<1, 2> outward(const std::array<Point<2>, 2> &corners)
    {
      const Tensor<1, 2> along = corners[1] - corners[0];
      return Tensor<1, 2>({along[1], -along[0]});
    }

    Tensor<1, 3> outward(const std::array<Point<3>, 3> &corners)
    {
      return cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
    }


    template <int dim>
    std::array<Point<dim>, dim> corners_of(const std::vector<Point<dim>>       &points,
                                           const std::array<unsigned int, dim> &vertices)
    {
      std::array<Point<dim>, dim> corners;
      for (unsigned int v = 0; v < dim; ++v)
        corners[v] = points[vertices[v]];
      return corners;
    }


    /** For each point the first one at the same place. */
    template <int dim>
    std::vector<unsigned int> first_at_place(const std::vector<Point<dim>> &points,
                                             const double                   tolerance)
    {
      std::vector<BoundingBox<dim>> boxes;
      for (const Point<dim> &point : points)
        boxes.push_back(box_around(std::array<Point<dim>, 1>{{point}}));
      const BoxTree<dim>        tree(boxes);
      std::vector<unsigned int> result(points.size());
      for (unsigned int p = 0; p < points.size(); ++p)
        {
          unsigned int first = p;
          tree.for_each_near(points[p], tolerance, [&](const unsigned int other) {
            if (other < first && points[p].distance(points[other]) <= tolerance)
              first = other;
          });
          result[p] = first < p ? result[first] : p;
        }
      return result;
    }


    /**
     * The facets that can be reached from one across ridges, and that become known by it.
     * @param joins whether a facet not yet known may be reached across the ridge of another one
     */
    template <int dim, typename Joins>
    std::vector<unsigned int> flood(const FacetedSurface<dim> &surface,
                                    const unsigned int         start,
                                    std::vector<bool>         &known,
                                    const Joins               &joins)
    {
      std::vector<unsigned int> piece = {start};
      known[start]                    = true;
      for (std::size_t k = 0; k < piece.size(); ++k)
        for (unsigned int ridge = 0; ridge < dim; ++ridge)
          if (const unsigned int other = surface.facets()[piece[k]].neighbours[ridge];
              other != FacetedSurface<dim>::none && !known[other] && joins(piece[k], ridge))
            {
              known[other] = true;
              piece.push_back(other);
            }
      return piece;
    }
  } // namespace


  template <int dim>
  FacetedSurface<dim>::FacetedSurface(FacetMesh<dim> mesh, const bool open)
  {
    use_vertices(mesh);
    connect(open);
    orient();
    if (!has_rim())
      orient_by_volume();
    find_planes();
    find_sides();
  }


  template <int dim>
  void FacetedSurface<dim>::measure(const std::vector<typename FacetMesh<dim>::Facet> &facets)
  {
    std::vector<Point<dim>> used;
    for (const auto &facet : facets)
      for (const unsigned int v : facet)
        used.push_back(points[v]);
    const auto corners = BoundingBox<dim>(used).get_boundary_points();
    diameter           = corners.first.distance(corners.second);
    for (unsigned int c = 0; c < dim; ++c)
      largest = std::max({largest, std::abs(corners.first[c]), std::abs(corners.second[c])});
  }


  template <int dim>
  void FacetedSurface<dim>::use_vertices(FacetMesh<dim> &mesh)
  {
    points = std::move(mesh.vertices);
    measure(mesh.facets);
    const auto first = first_at_place(points, same_vertex * diameter);
    at_vertex.resize(points.size());
    for (std::size_t f = 0; f < mesh.facets.size(); ++f)
      {
        Facet facet;
        for (unsigned int v = 0; v < dim; ++v)
          facet.vertices[v] = first[mesh.facets[f][v]];
        auto sorted = facet.vertices;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
          continue; // shrunk to an edge or a point, without which nothing is missing
        const auto   places  = corners_of<dim>(points, facet.vertices);
        const auto   normal  = outward(places);
        const double area    = normal.norm();
        double       longest = 0.;
        for (unsigned int v = 0; v < dim; ++v)
          longest = std::max(longest, places[v].distance(places[(v + 1) % dim]));
        if (!(area > no_area * std::pow(longest, dim - 1)))
          {
            std::ostringstream message;
            message << facet_name<dim>() << " " << f + 1 << " (counted from 1) with the corner ("
                    << places[0]
                    << ") is degenerate: its corners lie on a line, and it has no normal. Mesh the "
                       "surface again, or let a mesh program repair it.";
            throw UserError(message.str());
          }
        facet.normal = normal / area;
        facet.origin = places[0];
        facet.neighbours.fill(none);
        facet.side = 0;
        for (const unsigned int v : facet.vertices)
          at_vertex[v].push_back(all.size());
        all.push_back(facet);
      }
    if (all.empty())
      throw UserError("all of its facets are smaller than round-off. Check the units.");
  }


  template <int dim>
  std::array<Point<dim>, dim> FacetedSurface<dim>::corners(const unsigned int facet) const
  {
    return corners_of<dim>(points, all[facet].vertices);
  }


  template <int dim>
  double FacetedSurface<dim>::angle_at(const unsigned int facet, const Point<dim> &point) const
  {
    const auto at = corners(facet);
    const auto v  = std::find(at.begin(), at.end(), point) - at.begin();
    if (dim == 2 || v == dim)
      return 1.;
    const Tensor<1, dim> first = at[(v + 1) % dim] - point, second = at[(v + 2) % dim] - point;
    return std::acos(std::clamp(first * second / (first.norm() * second.norm()), -1., 1.));
  }


  template <int dim>
  std::string FacetedSurface<dim>::place(const unsigned int facet, const unsigned int ridge) const
  {
    Point<dim> middle;
    for (unsigned int v = 0; v < dim; ++v)
      if (v != ridge)
        middle += 1. / (dim - 1) * points[all[facet].vertices[v]];
    std::ostringstream text;
    text << "(" << middle << ")";
    return text.str();
  }


  template <int dim>
  void FacetedSurface<dim>::connect(const bool open)
  {
    using Ridge                  = std::array<unsigned int, dim - 1>;
    const std::string ridge_name = dim == 2 ? "point" : "edge";
    std::map<Ridge, std::vector<std::pair<unsigned int, unsigned int>>> ridges;
    for (unsigned int f = 0; f < all.size(); ++f)
      for (unsigned int i = 0; i < dim; ++i)
        {
          Ridge ridge;
          for (unsigned int v = 0, k = 0; v < dim; ++v)
            if (v != i)
              ridge[k++] = all[f].vertices[v];
          std::sort(ridge.begin(), ridge.end());
          ridges[ridge].emplace_back(f, i);
        }
    std::string hole;
    for (const auto &[ridge, at] : ridges)
      if (at.size() > 2)
        throw UserError("at " + place(at[0].first, at[0].second) + " " + std::to_string(at.size())
                        + " " + facet_name<dim>() + "s share one " + ridge_name
                        + ", so that it is the boundary of nothing. Remove facets inside of the "
                          "obstacle and repeated ones.");
      else if (at.size() == 2)
        for (unsigned int k = 0; k < 2; ++k)
          all[at[k].first].neighbours[at[k].second] = at[1 - k].first;
      else if (n_rim_ridges++ == 0)
        hole = place(at[0].first, at[0].second);
    if (has_rim() && !open)
      throw UserError("it is not closed: " + std::to_string(n_rim_ridges) + " " + ridge_name
                      + (n_rim_ridges > 1 ? "s have" : " has") + " a " + facet_name<dim>()
                      + " on one side only, the first one at " + hole
                      + ". Close the holes, or set `Open = true` for a surface that ends.");
    if (!has_rim() && open)
      throw UserError("it has no end, but `Open` says so. Remove `Open`.");
  }


  template <int dim>
  bool FacetedSurface<dim>::agree(const unsigned int facet, const unsigned int ridge) const
  {
    const Facet &own = all[facet], &other = all[own.neighbours[ridge]];
    // The vertices of the ridge in their order around the facet, which is turned across it; in 2d
    // the one vertex is the end of a segment and the start of the next.
    const unsigned int first = own.vertices[(ridge + 1) % dim];
    const auto         at    = std::find(other.vertices.begin(), other.vertices.end(), first);
    const unsigned int place = at - other.vertices.begin();
    if constexpr (dim == 2)
      return place == ridge;
    else
      return other.vertices[(place + 1) % 3] != own.vertices[(ridge + 2) % 3];
  }


  template <int dim>
  void FacetedSurface<dim>::flip(const unsigned int facet)
  {
    Facet &own = all[facet];
    std::swap(own.vertices[0], own.vertices[1]);
    std::swap(own.neighbours[0], own.neighbours[1]);
    own.normal *= -1.;
  }


  template <int dim>
  void FacetedSurface<dim>::orient()
  {
    std::vector<bool> known(all.size(), false);
    for (unsigned int start = 0; start < all.size(); ++start)
      {
        if (known[start])
          continue;
        unsigned int n_flipped = 0;
        const auto   turn      = [&](const unsigned int facet, const unsigned int ridge) {
          if (!agree(facet, ridge))
            {
              flip(all[facet].neighbours[ridge]);
              ++n_flipped;
            }
          return true;
        };
        const auto piece = flood(*this, start, known, turn);
        for (const unsigned int f : piece)
          for (unsigned int i = 0; i < dim; ++i)
            if (all[f].neighbours[i] != none && !agree(f, i))
              throw UserError("it has one side only, as the band of Moebius: the outside becomes "
                              "the inside at "
                              + place(f, i) + ". Give a surface with two sides.");
        if (2 * n_flipped > piece.size()) // most of them are right as they were
          for (const unsigned int facet : piece)
            flip(facet);
      }
  }


  template <int dim>
  void FacetedSurface<dim>::orient_by_volume()
  {
    double volume = 0.;
    for (unsigned int facet = 0; facet < all.size(); ++facet)
      volume += outward(corners(facet)) * (corners(facet)[0] - all[0].origin);
    if (std::abs(volume) < no_volume * std::pow(diameter, dim))
      throw UserError("it encloses nothing. Give the surface of a solid, or one with an end and "
                      "`Open = true`.");
    if (volume < 0.)
      turn_inside_out();
  }


  template <int dim>
  void FacetedSurface<dim>::turn_inside_out()
  {
    for (unsigned int facet = 0; facet < all.size(); ++facet)
      flip(facet);
  }


  template <int dim>
  void FacetedSurface<dim>::find_planes()
  {
    // Facets in a plane get one normal, and gaps do not depend on which of them is the closest.
    std::vector<bool> known(all.size(), false);
    for (unsigned int start = 0; start < all.size(); ++start)
      {
        if (known[start])
          continue;
        const Facet &own      = all[start];
        const auto   in_plane = [&](const unsigned int facet, const unsigned int ridge) {
          const Facet &other = all[all[facet].neighbours[ridge]];
          return own.normal * other.normal > 0.5
                 && std::all_of(
                   other.vertices.begin(), other.vertices.end(), [&](const unsigned int v) {
                     return std::abs(own.height(points[v])) <= round_off();
                   });
        };
        for (const unsigned int facet : flood(*this, start, known, in_plane))
          {
            all[facet].normal = own.normal;
            all[facet].origin = own.origin;
          }
      }
  }


  template <int dim>
  bool FacetedSurface<dim>::is_crease(const unsigned int facet, const unsigned int neighbour) const
  {
    const Tensor<1, dim> &own = all[facet].normal, &other = all[neighbour].normal;
    const double          cosine = own * other;
    return cosine < 0. || (own - cosine * other).norm() > crease;
  }


  template <int dim>
  void FacetedSurface<dim>::find_sides()
  {
    std::vector<bool> known(all.size(), false);
    for (unsigned int start = 0; start < all.size(); ++start)
      {
        if (known[start])
          continue;
        const auto is_smooth = [&](const unsigned int facet, const unsigned int ridge) {
          return !is_crease(facet, all[facet].neighbours[ridge]);
        };
        for (const unsigned int facet : flood(*this, start, known, is_smooth))
          all[facet].side = n_groups;
        ++n_groups;
      }
  }


  template <int dim>
  bool FacetedSurface<dim>::is_inner_corner(const unsigned int facet,
                                            const unsigned int ridge) const
  {
    const unsigned int other = all[facet].neighbours[ridge];
    if (other == none || all[other].side == all[facet].side)
      return false;
    double highest = 0., lowest = 0.;
    for (const unsigned int v : all[other].vertices)
      {
        highest = std::max(highest, all[facet].height(points[v]));
        lowest  = std::min(lowest, all[facet].height(points[v]));
      }
    return highest > -lowest;
  }


  template class FacetedSurface<2>;
  template class FacetedSurface<3>;
} // namespace signorini
