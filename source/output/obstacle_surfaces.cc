// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/obstacle_surfaces.h>
#include <signorini/output/whole_file.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <deal.II/lac/vector.h>

#include <cmath>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    constexpr unsigned int cells_per_direction = dim == 2 ? 128 : 32;

    /** Distances that are smaller, in cells, are no zeros: a surface through vertices has no cut.
     */
    constexpr double no_zero = 1e-4;


    /** The distance from an obstacle at the vertices of a grid, not a number where it has none. */
    template <int dim>
    dealii::Vector<double> distances(const DoFHandler<dim>    &grid,
                                     const RigidObstacle<dim> &obstacle,
                                     const double              smallest)
    {
      dealii::Vector<double> result(grid.n_dofs());
      for (const auto &cell : grid.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto   way = obstacle.try_project(cell->vertex(v));
            const double gap = way ? way->gap : std::numeric_limits<double>::quiet_NaN();
            result(cell->vertex_dof_index(v, 0)) = std::abs(gap) < smallest ? smallest : gap;
          }
      return result;
    }


    template <int dim>
    bool is_known(const dealii::Vector<double>                         &distance,
                  const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      for (const unsigned int v : cell->vertex_indices())
        if (std::isnan(distance(cell->vertex_dof_index(v, 0))))
          return false;
      return true;
    }


    /** The points of an obstacle nearest to the centre of a box, or else to its corners. */
    template <int dim>
    std::vector<Point<dim>> nearest_points(const BoundingBox<dim>   &box,
                                           const RigidObstacle<dim> &obstacle)
    {
      std::vector<Point<dim>> found;
      const auto              look_from = [&](const Point<dim> &point) {
        if (const auto way = obstacle.try_project(point))
          found.push_back(point + way->gap * way->normal);
      };
      look_from(box.center());
      if (found.empty())
        for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
          look_from(box.vertex(v));
      return found;
    }
  } // namespace


  template <int dim>
  std::vector<ShownObstacle<dim>> shown_obstacles(const std::vector<NamedObstacle<dim>> &obstacles,
                                                  const bool                             moving,
                                                  const double                           time)
  {
    std::vector<ShownObstacle<dim>> result;
    for (unsigned int index = 0; index < obstacles.size(); ++index)
      if ((obstacles[index].motion != nullptr) == moving)
        {
          result.push_back({index, obstacles[index]});
          result.back().obstacle.move(time, time);
        }
    return result;
  }


  template <int dim>
  ObstacleSurfaces<dim>::ObstacleSurfaces(const std::vector<ShownObstacle<dim>> &obstacles,
                                          const BoundingBox<dim>                &box)
  {
    std::vector<ShownObstacle<dim>> others;
    for (const ShownObstacle<dim> &shown : obstacles)
      {
        const auto facets = shown.obstacle.facets();
        for (const auto &facet : facets)
          add_patch(shown.index, facet);
        if (facets.empty())
          others.push_back(shown);
      }
    if (!others.empty())
      add_zero_sets(others, box);
  }


  template <int dim>
  void ObstacleSurfaces<dim>::add_zero_sets(const std::vector<ShownObstacle<dim>> &obstacles,
                                            const BoundingBox<dim>                &box)
  {
    const auto        &corners = box.get_boundary_points();
    Triangulation<dim> cells;
    GridGenerator::subdivided_hyper_rectangle(
      cells,
      std::vector<unsigned int>(dim, cells_per_direction<dim>),
      corners.first,
      corners.second);
    const FE_Q<dim>      linear(1);
    const MappingQ1<dim> mapping;
    DoFHandler<dim>      grid(cells);
    grid.distribute_dofs(linear);
    const double size = corners.first.distance(corners.second) / cells_per_direction<dim>;
    const GridTools::MarchingCubeAlgorithm<dim, dealii::Vector<double>> marching(
      mapping, linear, 1, 1e-3 * no_zero * size);
    for (const ShownObstacle<dim> &shown : obstacles)
      {
        const dealii::Vector<double>   distance = distances(grid, shown.obstacle, no_zero * size);
        std::vector<Point<dim>>        vertices;
        std::vector<CellData<dim - 1>> pieces;
        for (const auto &cell : grid.active_cell_iterators())
          if (is_known<dim>(distance, cell))
            marching.process_cell(cell, distance, 0., vertices, pieces);
        for (const CellData<dim - 1> &piece : pieces)
          {
            std::vector<Point<dim>> corners_of_piece;
            for (const unsigned int v : piece.vertices)
              corners_of_piece.push_back(vertices[v]);
            add_piece(shown, corners_of_piece);
          }
      }
  }


  template <int dim>
  void ObstacleSurfaces<dim>::add_piece(const ShownObstacle<dim> &shown,
                                        std::vector<Point<dim>>   vertices)
  {
    for (Point<dim> &vertex : vertices)
      {
        const auto way = shown.obstacle.try_project(vertex);
        if (!way)
          return;
        vertex += way->gap * way->normal;
      }
    add_patch(shown.index, vertices);
  }


  template <int dim>
  template <typename Vertices>
  void ObstacleSurfaces<dim>::add_patch(const unsigned int index, const Vertices &vertices)
  {
    Patch patch;
    patch.n_subdivisions = 1;
    patch.reference_cell = ReferenceCells::get_simplex<dim - 1>();
    patch.data.reinit(1, vertices.size());
    for (unsigned int v = 0; v < vertices.size(); ++v)
      {
        patch.vertices[v] = vertices[v];
        patch.data(0, v)  = index;
      }
    patch.patch_index = patches.size();
    patches.push_back(patch);
  }


  template <int dim>
  BoundingBox<dim> surroundings(const std::vector<BoundingBox<dim>>   &bodies,
                                const std::vector<ShownObstacle<dim>> &obstacles)
  {
    BoundingBox<dim> box  = bodies.front();
    double           size = 0.;
    for (const BoundingBox<dim> &body : bodies)
      {
        box.merge_with(body);
        size = std::max(
          size, body.get_boundary_points().first.distance(body.get_boundary_points().second));
      }
    std::vector<Point<dim>> points = {box.get_boundary_points().first,
                                      box.get_boundary_points().second};
    for (const BoundingBox<dim> &body : bodies)
      for (const ShownObstacle<dim> &shown : obstacles)
        for (const Point<dim> &point : nearest_points(body, shown.obstacle))
          points.push_back(point);
    box = BoundingBox<dim>(points);
    box.extend(0.5 * size);
    return box;
  }


  template <int dim>
  void write_obstacles(const std::string                     &directory,
                       const std::vector<BoundingBox<dim>>   &bodies,
                       const std::vector<NamedObstacle<dim>> &obstacles,
                       const MPI_Comm                         communicator)
  {
    succeed_together(communicator, [&] {
      const auto at_rest = shown_obstacles(obstacles, false);
      if (at_rest.empty() || Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      const ObstacleSurfaces<dim> surfaces(at_rest, surroundings(bodies, at_rest));
      write_whole_file(directory + "/obstacles.vtu",
                       [&](std::ostream &out) { surfaces.write_vtu(out); });
    });
  }


#define INSTANTIATE(dim)                                                                           \
  template class ObstacleSurfaces<dim>;                                                            \
  template std::vector<ShownObstacle<dim>> shown_obstacles(                                        \
    const std::vector<NamedObstacle<dim>> &, bool, double);                                        \
  template BoundingBox<dim> surroundings(const std::vector<BoundingBox<dim>> &,                    \
                                         const std::vector<ShownObstacle<dim>> &);                 \
  template void             write_obstacles(const std::string &,                                   \
                                            const std::vector<BoundingBox<dim>> &,                 \
                                            const std::vector<NamedObstacle<dim>> &,               \
                                            MPI_Comm);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
