// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/overlap.h>

#include <deal.II/base/bounding_box.h>

#include <deal.II/fe/mapping_q1.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using CoarseCell = typename Triangulation<dim>::cell_iterator;

    template <int dim>
    std::vector<CoarseCell<dim>> coarse_cells(const Discretization<dim> &discretization,
                                              const unsigned int         body)
    {
      std::vector<CoarseCell<dim>> cells;
      for (const auto &cell : discretization.mesh().triangulation().cell_iterators_on_level(0))
        if (cell->material_id() == body)
          cells.push_back(cell);
      return cells;
    }


    /**
     * Whether a point is inside a cell, not just at its boundary; what lies nearer to that, the
     * gap between the surfaces shows.
     */
    template <int dim>
    bool is_well_inside(const CoarseCell<dim> &cell, const Point<dim> &point)
    {
      if (!cell->bounding_box().point_inside(point))
        return false;
      try
        {
          const Point<dim> xi = MappingQ1<dim>().transform_real_to_unit_cell(cell, point);
          for (unsigned int d = 0; d < dim; ++d)
            if (xi[d] < 0.05 || xi[d] > 0.95)
              return false;
          return true;
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          return false;
        }
    }


    template <int dim>
    std::optional<Point<dim>> point_inside(const std::vector<CoarseCell<dim>> &cells,
                                           const BoundingBox<dim>             &other_box,
                                           const std::vector<CoarseCell<dim>> &others)
    {
      for (const CoarseCell<dim> &cell : cells)
        {
          std::vector<Point<dim>> points = {cell->center()};
          for (const unsigned int v : cell->vertex_indices())
            points.push_back(cell->vertex(v));
          for (const Point<dim> &point : points)
            if (other_box.point_inside(point)
                && std::any_of(others.begin(), others.end(), [&](const CoarseCell<dim> &other) {
                     return is_well_inside<dim>(other, point);
                   }))
              return point;
        }
      return {};
    }
  } // namespace


  template <int dim>
  std::optional<Point<dim>> find_deep_overlap(const Discretization<dim> &discretization,
                                              const unsigned int         body,
                                              const unsigned int         other_body)
  {
    const auto cells  = coarse_cells(discretization, body),
               others = coarse_cells(discretization, other_body);
    if (const auto point =
          point_inside<dim>(cells, discretization.mesh().bounding_box(other_body), others))
      return point;
    return point_inside<dim>(others, discretization.mesh().bounding_box(body), cells);
  }


  template std::optional<Point<2>>
  find_deep_overlap(const Discretization<2> &, unsigned int, unsigned int);
  template std::optional<Point<3>>
  find_deep_overlap(const Discretization<3> &, unsigned int, unsigned int);
} // namespace signorini
