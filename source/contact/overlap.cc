// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/contact/overlap.h>

#include <deal.II/fe/mapping_q1.h>

#include <deal.II/numerics/rtree.h>

#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/index/predicates.hpp>

#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using CoarseCell = typename Triangulation<dim>::cell_iterator;

    /** Coarse cells and the boxes around them. */
    template <int dim>
    struct BoxedCells
    {
      std::vector<CoarseCell<dim>>  cells;
      std::vector<BoundingBox<dim>> boxes;
    };

    /** The coarse cells of a body that may reach into a box. */
    template <int dim>
    BoxedCells<dim>
    cells_near(const Mesh<dim> &mesh, const unsigned int body, const BoundingBox<dim> &place)
    {
      BoxedCells<dim> result;
      for (const auto &cell : mesh.triangulation().cell_iterators_on_level(0))
        if (cell->material_id() == body)
          if (const BoundingBox<dim> box = cell->bounding_box();
              boost::geometry::intersects(box, place))
            {
              result.cells.push_back(cell);
              result.boxes.push_back(box);
            }
      return result;
    }


    /**
     * Whether a point is inside a cell, not just at its boundary; what lies nearer to that, the
     * gap between the surfaces shows.
     */
    template <int dim>
    bool is_well_inside(const CoarseCell<dim> &cell, const Point<dim> &point)
    {
      try
        {
          const Point<dim> xi =
            StaticMappingQ1<dim>::mapping.transform_real_to_unit_cell(cell, point);
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


    /** The first centre or vertex of the cells that is well inside one of the others. */
    template <int dim>
    std::optional<Point<dim>>
    point_inside(const Mesh<dim> &mesh, const BoxedCells<dim> &own, const BoxedCells<dim> &others)
    {
      namespace index = boost::geometry::index;

      const auto tree      = pack_rtree_of_indices(others.boxes);
      const auto is_inside = [&](const Point<dim> &point) {
        const auto contains_point = [&](const std::size_t k) {
          return is_well_inside<dim>(others.cells[k], point);
        };
        return tree.qbegin(index::intersects(point) && index::satisfies(contains_point))
               != tree.qend();
      };
      std::vector<bool> known(mesh.triangulation().n_vertices());
      for (const CoarseCell<dim> &cell : own.cells)
        {
          if (is_inside(cell->center()))
            return cell->center();
          for (const unsigned int v : cell->vertex_indices())
            if (!known[cell->vertex_index(v)])
              {
                known[cell->vertex_index(v)] = true;
                if (is_inside(cell->vertex(v)))
                  return cell->vertex(v);
              }
        }
      return {};
    }
  } // namespace


  template <int dim>
  std::optional<Point<dim>>
  find_deep_overlap(const Mesh<dim> &mesh, const unsigned int body, const unsigned int other_body)
  {
    const BoxedCells<dim> own    = cells_near(mesh, body, mesh.bounding_box(other_body)),
                          others = cells_near(mesh, other_body, mesh.bounding_box(body));
    const auto point             = point_inside(mesh, own, others);
    return point ? point : point_inside(mesh, others, own);
  }


  template <int dim>
  void check_that_bodies_are_apart(const Mesh<dim> &mesh, const std::vector<PairDescription> &pairs)
  {
    for (const PairDescription &pair : pairs)
      if (pair.of_two_bodies() && pair.slave != pair.master)
        if (const auto place = find_deep_overlap(mesh, pair.slave, pair.master))
          {
            std::ostringstream message;
            message << "Contact/Pairs = " << pair.name << ": the bodies '"
                    << mesh.bodies()[pair.slave].name << "' and '"
                    << mesh.bodies()[pair.master].name << "' overlap at the start, at (" << *place
                    << "). Move one of them.";
            throw UserError(message.str());
          }
  }


#define INSTANTIATE(dim)                                                                           \
  template std::optional<Point<dim>> find_deep_overlap(                                            \
    const Mesh<dim> &, unsigned int, unsigned int);                                                \
  template void check_that_bodies_are_apart(const Mesh<dim> &, const std::vector<PairDescription> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
