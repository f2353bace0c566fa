// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/missing_pairs.h>
#include <signorini/discretization/common_boxes.h>
#include <signorini/discretization/common_points.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <deal.II/fe/mapping_q1_eulerian.h>

#include <deal.II/numerics/rtree.h>

#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/index/predicates.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int calls_between_looks         = 8;
    constexpr unsigned int calls_between_careful_looks = 32;
    constexpr double       depth_limit                 = 0.01; ///< over the size of the body


    /** The bodies in their present shapes. */
    template <int dim>
    class PresentBodies
    {
    public:
      /** Collective. */
      PresentBodies(const Discretization<dim> &discretization, const Vector &displacement);

      /** Around a body, the same on all processes. */
      const BoundingBox<dim> &box(const unsigned int body) const { return boxes[body]; }

      /** How deep the surface of a body is in an obstacle. Collective. */
      double depth(unsigned int body, const RigidObstacle<dim> &obstacle) const;

      /** Whether a point of one body is well inside a cell of the other. Collective. */
      bool overlap(const unsigned int body, const unsigned int other) const
      {
        return reaches_into(body, other) || reaches_into(other, body);
      }

    private:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      const Discretization<dim>           &discretization;
      const Vector                         displacement;
      const MappingQ1Eulerian<dim, Vector> mapping;
      std::vector<std::vector<Point<dim>>> surface; ///< of each body, this process
      std::vector<BoundingBox<dim>>        boxes;

      void add_points(const Cell &cell, std::vector<bool> &known_vertices);
      bool reaches_into(unsigned int body, unsigned int other) const;
      bool is_well_inside(const Cell &cell, const Point<dim> &point) const;
    };


    template <int dim>
    PresentBodies<dim>::PresentBodies(const Discretization<dim> &discretization,
                                      const Vector              &displacement)
      : discretization(discretization)
      , displacement(discretization.interpolate_hanging_nodes(displacement))
      , mapping(discretization.dof_handler(), this->displacement)
      , surface(discretization.mesh().bodies().size())
    {
      std::vector<bool> known_vertices(discretization.mesh().triangulation().n_vertices());
      for (const Cell &cell : discretization.cells())
        if (cell->is_locally_owned() && cell->at_boundary())
          add_points(cell, known_vertices);
      CommonBoxes<dim> around(surface.size());
      for (std::size_t body = 0; body < surface.size(); ++body)
        for (const Point<dim> &point : surface[body])
          around.add(point, body);
      boxes = around.around_all(discretization.communicator());
    }


    /** Of a cell at the surface its centre, and the vertices and the centres of its free faces. */
    template <int dim>
    void PresentBodies<dim>::add_points(const Cell &cell, std::vector<bool> &known_vertices)
    {
      std::vector<Point<dim>> &points   = surface[cell->material_id()];
      const auto               vertices = mapping.get_vertices(cell);
      Point<dim>               centre;
      for (const Point<dim> &vertex : vertices)
        centre += 1. / GeometryInfo<dim>::vertices_per_cell * vertex;
      points.push_back(centre);
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          {
            const unsigned int n = GeometryInfo<dim>::vertices_per_face;
            Point<dim>         middle;
            for (unsigned int k = 0; k < n; ++k)
              {
                const unsigned int v = GeometryInfo<dim>::face_to_cell_vertices(f, k);
                middle += 1. / n * vertices[v];
                if (!known_vertices[cell->vertex_index(v)])
                  points.push_back(vertices[v]);
                known_vertices[cell->vertex_index(v)] = true;
              }
            points.push_back(middle);
          }
    }


    template <int dim>
    double PresentBodies<dim>::depth(const unsigned int        body,
                                     const RigidObstacle<dim> &obstacle) const
    {
      double deepest = 0.;
      for (const Point<dim> &point : surface[body])
        if (const auto way = obstacle.try_project(point)) // no partner need be where it has a value
          deepest = std::max(deepest, way->depth());
      return Utilities::MPI::max(deepest, discretization.communicator());
    }


    template <int dim>
    bool PresentBodies<dim>::reaches_into(const unsigned int body, const unsigned int other) const
    {
      namespace index = boost::geometry::index;

      std::vector<Point<dim>> own;
      for (const Point<dim> &point : surface[body])
        if (boxes[other].point_inside(point))
          own.push_back(point);
      std::vector<Cell>             cells;
      std::vector<BoundingBox<dim>> cell_boxes;
      for (const Cell &cell : discretization.cells())
        if (cell->is_locally_owned() && cell->material_id() == other)
          {
            const auto             vertices = mapping.get_vertices(cell);
            const BoundingBox<dim> box(std::vector<Point<dim>>(vertices.begin(), vertices.end()));
            if (boost::geometry::intersects(box, boxes[body]))
              {
                cells.push_back(cell);
                cell_boxes.push_back(box);
              }
          }
      const auto tree  = pack_rtree_of_indices(cell_boxes);
      bool       found = false;
      for (const Point<dim> &point : common_points(own, discretization.communicator()))
        {
          const auto contains_point = [&](const std::size_t k) {
            return is_well_inside(cells[k], point);
          };
          found = found
                  || tree.qbegin(index::intersects(point) && index::satisfies(contains_point))
                       != tree.qend();
        }
      return Utilities::MPI::max(static_cast<unsigned int>(found), discretization.communicator())
             > 0;
    }


    template <int dim>
    bool PresentBodies<dim>::is_well_inside(const Cell &cell, const Point<dim> &point) const
    {
      constexpr double margin = 0.05; // neighbours that fit together overlap by round-off
      try
        {
          const Point<dim> xi = mapping.transform_real_to_unit_cell(cell, point);
          for (unsigned int c = 0; c < dim; ++c)
            if (!(xi[c] > margin && xi[c] < 1. - margin))
              return false;
          return true;
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          return false;
        }
    }


    std::string three_digits(const double value)
    {
      std::ostringstream text;
      text.precision(3);
      text << value;
      return text.str();
    }
  } // namespace


  template <int dim>
  MissingPairs<dim>::MissingPairs(const unsigned int                     n_bodies,
                                  const std::vector<NamedObstacle<dim>> &obstacles,
                                  const std::vector<PairDescription>    &pairs)
    : obstacles(obstacles)
  {
    const auto is_there = [&](const auto &is_it) {
      return std::any_of(pairs.begin(), pairs.end(), is_it);
    };
    for (unsigned int body = 0; body < n_bodies; ++body)
      {
        for (unsigned int o = 0; o < obstacles.size(); ++o)
          if (!is_there([&](const PairDescription &pair) {
                return pair.slave == body && pair.obstacle == o;
              }))
            body_obstacle.push_back({body, o});
        for (unsigned int other = body + 1; other < n_bodies; ++other)
          if (!is_there([&](const PairDescription &pair) {
                return (pair.slave == body && pair.master == other)
                       || (pair.slave == other && pair.master == body);
              }))
            body_body.push_back({body, other});
      }
  }


  template <int dim>
  std::vector<std::string> MissingPairs<dim>::judge(const Discretization<dim> &discretization,
                                                    const Vector              &displacement,
                                                    const double               time,
                                                    const bool                 last)
  {
    const unsigned int call = n_calls++;
    if ((body_obstacle.empty() && body_body.empty()) || (call % calls_between_looks != 0 && !last))
      return {};
    const PresentBodies<dim> present(discretization, displacement);
    const auto               size = [&](const unsigned int body) {
      return discretization.mesh().body_size(body);
    };
    const auto name = [&](const unsigned int body) {
      return discretization.mesh().bodies()[body].name;
    };

    std::vector<std::string> news;
    const auto tell = [&](const std::string &what, const std::string &a, const std::string &b) {
      news.push_back("at time " + three_digits(time) + " " + what
                     + ". Nothing keeps them apart: add `" + a + " : " + b
                     + "` to `Contact/Pairs`, unless this is meant.");
      return true;
    };
    const auto is_in_obstacle = [&](const Absent &absent) {
      MovedObstacle<dim> moved(obstacles[absent.other]);
      moved.move(time, time);
      const double depth = present.depth(absent.body, moved);
      const auto   body = name(absent.body), obstacle = obstacles[absent.other].name;
      return depth > depth_limit * size(absent.body)
             && tell("the body '" + body + "' is " + three_digits(100. * depth / size(absent.body))
                       + " % of its size deep in the obstacle '" + obstacle
                       + "', which is not its partner",
                     body,
                     obstacle);
    };
    const auto is_in_body = [&](Absent &absent) {
      if ((call < absent.next_look && !last)
          || !boost::geometry::intersects(present.box(absent.body), present.box(absent.other)))
        return false;
      absent.next_look = call + calls_between_careful_looks;
      const auto body = name(absent.body), other = name(absent.other);
      return present.overlap(absent.body, absent.other)
             && tell("the bodies '" + body + "' and '" + other + "', which are no pair, overlap",
                     body,
                     other);
    };
    body_obstacle.erase(std::remove_if(body_obstacle.begin(), body_obstacle.end(), is_in_obstacle),
                        body_obstacle.end());
    body_body.erase(std::remove_if(body_body.begin(), body_body.end(), is_in_body),
                    body_body.end());
    return news;
  }


  template class MissingPairs<2>;
  template class MissingPairs<3>;
} // namespace signorini
