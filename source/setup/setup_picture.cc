// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/setup/setup_picture.h>
#include <signorini/setup/svg_drawing.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** What can be said of a face, the most special first. */
    struct Kind
    {
      bool (*holds)(const SetupFace &face);
      unsigned int colour; ///< 0xrrggbb
      const char  *words;
    };

    // The colours can be told apart with any kind of colour vision (Okabe and Ito).
    const std::vector<Kind> kinds = {
      {[](const SetupFace &face) { return face.is_supported; },
       0x009E73,
       "prescribed displacement"},
      {[](const SetupFace &face) { return face.is_loaded; }, 0xE69F00, "traction"},
      {[](const SetupFace &face) { return face.contact_side == 1; }, 0xD55E00, "contact: slave"},
      {[](const SetupFace &face) { return face.contact_side == 2; }, 0x0072B2, "contact: master"},
      {[](const SetupFace &) { return true; }, 0xCCCCCC, "free"}};

    const char *const line_colour = "#444444", *const obstacle_colour = "#8A8A8A",
                      *const body_colour = "#EEEEEE";


    const Kind &kind_of(const SetupFace &face)
    {
      return *std::find_if(
        kinds.begin(), kinds.end(), [&face](const Kind &kind) { return kind.holds(face); });
    }


    /** @param light 0 to 1 */
    std::string colour(const unsigned int rgb, const double light)
    {
      char text[8];
      std::snprintf(text,
                    sizeof text,
                    "#%02x%02x%02x",
                    static_cast<unsigned int>(light * (rgb >> 16 & 0xFF)),
                    static_cast<unsigned int>(light * (rgb >> 8 & 0xFF)),
                    static_cast<unsigned int>(light * (rgb & 0xFF)));
      return text;
    }


    /** From where the picture is seen, in 3d without perspective. */
    struct View
    {
      /** Unit vectors: to the right of the picture, to its top, and towards who looks. */
      const Tensor<1, 3> right{{0.8, 0.6, 0.}}, up{{-0.24, 0.32, 0.916515138991168}},
        towards{{0.5499090833947008, -0.7332121111929344, 0.4}};

      Point<2> operator()(const Point<3> &point) const { return {right * point, up * point}; }
      Point<2> operator()(const Point<2> &point) const { return point; }

      bool   shows(const Tensor<1, 3> &normal) const { return towards * normal > 0.; }
      bool   shows(const Tensor<1, 2> &) const { return true; }
      double nearness(const Point<3> &point) const { return towards * point; }
      double nearness(const Point<2> &) const { return 0.; }
      double light(const Tensor<1, 3> &normal) const { return 0.85 + 0.15 * (up * normal); }
      double light(const Tensor<1, 2> &) const { return 1.; }
    };


    template <int dim>
    Point<dim> middle(const std::vector<Point<dim>> &points)
    {
      Point<dim> sum;
      for (const Point<dim> &point : points)
        sum += point / static_cast<double>(points.size());
      return sum;
    }


    /** The vertices of a quadrilateral, or of a line, around it. */
    template <typename Object>
    auto around(const Object &object)
    {
      std::vector<std::decay_t<decltype(object->vertex(0))>> points;
      for (const unsigned int v : object->n_vertices() == 4 ? std::vector<unsigned int>{0, 1, 3, 2}
                                                            : std::vector<unsigned int>{0, 1})
        points.push_back(object->vertex(v));
      return points;
    }


    /** The point that is nearest to the mean of all. */
    Point<2> central(const std::vector<Point<2>> &points)
    {
      const Point<2> mean = middle(points);
      return *std::min_element(points.begin(), points.end(), [&mean](const auto &a, const auto &b) {
        return a.distance_square(mean) < b.distance_square(mean);
      });
    }


    /** In the middle, where the highest point is. */
    Point<2> top(const std::vector<Point<2>> &points)
    {
      Point<2> result = middle(points);
      for (const Point<2> &point : points)
        result[1] = std::max(result[1], point[1]);
      return result;
    }


    template <int dim>
    std::vector<Point<2>> projected(const View &view, const std::vector<Point<dim>> &points)
    {
      std::vector<Point<2>> result;
      for (const Point<dim> &point : points)
        result.push_back(view(point));
      return result;
    }


    /** "x from -1 to 1" for each direction. */
    template <int dim>
    std::vector<std::string> extents(const BoundingBox<dim> &box)
    {
      std::vector<std::string> lines;
      for (unsigned int d = 0; d < dim; ++d)
        {
          std::ostringstream line;
          line.precision(5);
          const double round_off = 1e-10 * box.side_length(d);
          const auto   shown     = [round_off](const double x) {
            return std::abs(x) < round_off ? 0. : x;
          };
          line << "xyz"[d] << " from " << shown(box.lower_bound(d)) << " to "
               << shown(box.upper_bound(d));
          lines.push_back(line.str());
        }
      return lines;
    }


    /** Of a line in 2d or a triangle in 3d. */
    template <int dim>
    std::vector<Point<dim>> corners(const DataOutBase::Patch<dim - 1, dim> &patch)
    {
      return {&patch.vertices[0], &patch.vertices[0] + dim};
    }
  } // namespace


  template <int dim>
  SetupPicture<dim>::SetupPicture(const Discretization<dim>          &discretization,
                                  const std::vector<PairDescription> &pairs)
  {
    const auto          &bodies = discretization.mesh().bodies();
    std::vector<Polygon> own;
    for (const auto &body : bodies)
      names.push_back(body.name);
    for (const auto &cell : discretization.cells())
      {
        if (!cell->is_locally_owned())
          continue;
        const unsigned int body = cell->material_id();
        if constexpr (dim == 2)
          own.push_back(
            {around(cell), {}, {body, numbers::invalid_boundary_id, 0, false, false}, true});
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              Tensor<1, dim> normal = face->center() - cell->center();
              if constexpr (dim == 3)
                {
                  const Tensor<1, 3> across = cross_product_3d(face->vertex(3) - face->vertex(0),
                                                               face->vertex(2) - face->vertex(1));
                  normal = across * (across * normal > 0. ? 1. : -1.) / across.norm();
                }
              own.push_back({around(face),
                             normal,
                             setup_face(bodies, pairs, body, face->boundary_id()),
                             false});
            }
      }
    n_polygons =
      Utilities::MPI::sum(static_cast<unsigned int>(own.size()), discretization.communicator());
    if (!exists())
      return;
    for (const auto &of_process : Utilities::MPI::gather(discretization.communicator(), own))
      polygons.insert(polygons.end(), of_process.begin(), of_process.end());
    const View view;
    std::stable_sort(polygons.begin(), polygons.end(), [&view](const auto &a, const auto &b) {
      return std::make_tuple(!a.is_cell, view.nearness(middle(a.points)))
             < std::make_tuple(!b.is_cell, view.nearness(middle(b.points)));
    });
  }


  template <int dim>
  void SetupPicture<dim>::draw_obstacles(const ObstacleSurfaces<dim> &surfaces,
                                         SvgDrawing                  &drawing) const
  {
    const View              view;
    const SvgDrawing::Style style = dim == 2 ? SvgDrawing::Style{"", obstacle_colour, 4.}
                                             : SvgDrawing::Style{obstacle_colour, "", 0., 0.3};
    for (const auto &patch : surfaces.get_patches())
      drawing.polygon(projected(view, corners(patch)), style);
    drawing.legend(style, "obstacle");
  }


  template <int dim>
  void SetupPicture<dim>::name_obstacles(const ObstacleSurfaces<dim>    &surfaces,
                                         const std::vector<std::string> &obstacles,
                                         const BoundingBox<dim>         &box,
                                         SvgDrawing                     &drawing) const
  {
    // At their right ends, where no body is likely to be.
    std::map<unsigned int, Point<2>> ends;
    for (const auto &patch : surfaces.get_patches())
      {
        const Point<dim> place = middle(corners(patch));
        const Point<2>   end   = View()(place);
        if (box.point_inside(place))
          if (const auto [known, is_new] =
                ends.insert({static_cast<unsigned int>(patch.data(0, 0)), end});
              !is_new && known->second[0] < end[0])
            known->second = end;
      }
    for (const auto &[index, end] : ends)
      drawing.label(end, obstacles[index], false);
  }


  template <int dim>
  void SetupPicture<dim>::draw_bodies(SvgDrawing &drawing) const
  {
    const View                                                                   view;
    std::map<unsigned int, std::vector<Point<2>>>                                bodies;
    std::map<std::pair<unsigned int, types::boundary_id>, std::vector<Point<2>>> boundaries;
    std::set<const Kind *>                                                       shown, hidden;
    for (const Polygon &polygon : polygons)
      {
        const Point<2> centre = view(middle(polygon.points));
        const Kind    &kind   = kind_of(polygon.face);
        if (!polygon.is_cell && !view.shows(polygon.normal))
          {
            hidden.insert(&kind);
            continue;
          }
        const std::string rgb    = colour(kind.colour, view.light(polygon.normal));
        const auto        points = projected(view, polygon.points);
        if (polygon.is_cell)
          drawing.polygon(points, {body_colour, line_colour, 0.4});
        else if (dim == 2)
          drawing.polygon(points, {"", rgb, 4.});
        else
          drawing.polygon(points, {rgb, line_colour, 0.4});
        if (polygon.is_cell || dim == 3)
          bodies[polygon.face.body].push_back(centre);
        if (polygon.is_cell)
          continue;
        shown.insert(&kind);
        boundaries[{polygon.face.body, polygon.face.boundary_id}].push_back(centre);
      }
    for (const auto &[boundary, places] : boundaries)
      drawing.label(central(places), std::to_string(boundary.second), true);
    for (const auto &[body, places] : bodies)
      drawing.label(top(places), names[body], false);
    for (const Kind &kind : kinds)
      if (shown.count(&kind) + hidden.count(&kind) > 0)
        drawing.legend({colour(kind.colour, 1.), line_colour},
                       std::string(kind.words) + (shown.count(&kind) > 0 ? "" : " (hidden)"));
  }


  template <int dim>
  std::string SetupPicture<dim>::draw(const BoundingBox<dim>         &box,
                                      const ObstacleSurfaces<dim>    *surfaces,
                                      const std::vector<std::string> &obstacles) const
  {
    std::vector<Point<dim>> of_bodies;
    for (const Polygon &polygon : polygons)
      of_bodies.insert(of_bodies.end(), polygon.points.begin(), polygon.points.end());
    std::vector<Point<dim>> in_sight = of_bodies;
    if (surfaces != nullptr)
      for (const auto &patch : surfaces->get_patches())
        for (unsigned int v = 0; v < dim; ++v)
          if (box.point_inside(patch.vertices[v]))
            in_sight.push_back(patch.vertices[v]);
    SvgDrawing drawing(BoundingBox<2>(projected(View(), in_sight)), "Set-up: " + join(names));
    if (surfaces != nullptr)
      draw_obstacles(*surfaces, drawing);
    draw_bodies(drawing);
    if (surfaces != nullptr)
      name_obstacles(*surfaces, obstacles, box, drawing);
    drawing.legend({}, "numbers: boundaries");
    for (const std::string &line : extents(BoundingBox<dim>(of_bodies)))
      drawing.legend({}, line);
    return drawing.text();
  }


  template class SetupPicture<2>;
  template class SetupPicture<3>;
} // namespace signorini
