// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/user_error.h>
#include <signorini/discretization/make_triangulation.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * Append a coarse mesh to the lists of vertices, cells and boundary faces; shift its manifold
     * ids by `offset`.
     */
    template <int dim>
    void append(const Triangulation<dim>   &mesh,
                const types::material_id    material_id,
                const types::manifold_id    offset,
                std::vector<Point<dim>>    &vertices,
                std::vector<CellData<dim>> &cells,
                SubCellData                &faces)
    {
      auto [new_vertices, new_cells, new_faces] = GridTools::get_coarse_mesh_description(mesh);
      const unsigned int first_vertex           = vertices.size();
      vertices.insert(vertices.end(), new_vertices.begin(), new_vertices.end());
      const auto shift = [&](auto &list) {
        for (auto &item : list)
          {
            for (unsigned int &vertex : item.vertices)
              vertex += first_vertex;
            if (item.manifold_id != numbers::flat_manifold_id)
              item.manifold_id += offset;
          }
      };
      shift(new_cells);
      shift(new_faces.boundary_lines);
      shift(new_faces.boundary_quads);
      for (CellData<dim> &cell : new_cells)
        cell.material_id = material_id;
      cells.insert(cells.end(), new_cells.begin(), new_cells.end());
      faces.boundary_lines.insert(faces.boundary_lines.end(),
                                  new_faces.boundary_lines.begin(),
                                  new_faces.boundary_lines.end());
      faces.boundary_quads.insert(faces.boundary_quads.end(),
                                  new_faces.boundary_quads.begin(),
                                  new_faces.boundary_quads.end());
    }


    /** Refine all cells for which the predicate holds, `times` times (a child asks again). */
    template <int dim, typename Predicate>
    void refine(Triangulation<dim> &mesh, const Predicate &predicate)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned() && predicate(cell))
          cell->set_refine_flag();
      mesh.execute_coarsening_and_refinement();
    }


    /** Refuse meshes that no computer at hand can hold, before an attempt to make them. */
    template <int dim>
    void check_size(const BodyDescription<dim> &body,
                    const double                n_coarse_cells,
                    const unsigned int          n_processes)
    {
      constexpr double most_coarse = 1e6, most_per_process = 1e7;
      if (n_coarse_cells > most_coarse)
        throw UserError("Bodies/" + body.name + "/" + body.shape->too_many_cells());
      const double cells =
        n_coarse_cells * std::pow(2., static_cast<double>(dim * body.refinements));
      std::ostringstream message;
      message << "Bodies/" << body.name << "/Refinements = " << body.refinements << " gives "
              << cells << " cells, too many for " << n_processes
              << " process(es). Use fewer refinements or more processes.";
      if (cells > most_per_process * n_processes)
        throw UserError(message.str());
    }


    /**
     * Cells are known by differences of coordinates, which leave nothing of a small body far away,
     * and by their products, which overflow.
     */
    template <int dim>
    void check_place(const BodyDescription<dim> &body, const std::vector<Point<dim>> &points)
    {
      constexpr double most_far = 1e8, smallest = 1e-50, largest = 1e50;
      double           farthest = 0., thickness = largest;
      for (unsigned int c = 0; c < dim; ++c)
        {
          double low = points[0][c], high = low;
          for (const Point<dim> &point : points)
            {
              low  = std::min(low, point[c]);
              high = std::max(high, point[c]);
            }
          farthest  = std::max({farthest, std::abs(low), std::abs(high)});
          thickness = std::min(thickness, high - low);
        }
      std::ostringstream message;
      message << "Bodies/" << body.name << ": it is " << thickness
              << " thick and has coordinates up to " << farthest
              << ". Correct its size and place, or choose other units: sizes must be between "
              << smallest << " and " << largest << ", and at least 1e-8 of the coordinates.";
      if (!(thickness >= smallest && farthest <= largest && farthest <= most_far * thickness))
        throw UserError(message.str());
    }


    /** The coarse mesh of a body, if it is neither too large nor lost in round-off. */
    template <int dim>
    Triangulation<dim> coarse_mesh(const BodyDescription<dim> &body, const unsigned int n_processes)
    {
      Assert(body.shape != nullptr, ExcMessage("the body has no shape"));
      check_size(body, body.shape->n_coarse_cells(), n_processes);
      if (const auto corners = body.shape->corners_around(); !corners.empty())
        check_place(body, corners);
      Triangulation<dim> mesh;
      body.shape->make_coarse_mesh(body.placement, mesh);
      check_size(body, mesh.n_active_cells(), n_processes);
      check_place(body, mesh.get_vertices());
      return mesh;
    }
  } // namespace


  template <int dim>
  void make_triangulation(const std::vector<BodyDescription<dim>>   &bodies,
                          parallel::distributed::Triangulation<dim> &triangulation)
  {
    std::vector<Point<dim>>                                      vertices;
    std::vector<CellData<dim>>                                   cells;
    SubCellData                                                  faces;
    types::manifold_id                                           first_id = 0; // of a body
    std::map<types::manifold_id, std::unique_ptr<Manifold<dim>>> manifolds;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Triangulation<dim> mesh =
          coarse_mesh(bodies[b], Utilities::MPI::n_mpi_processes(triangulation.get_communicator()));
        append(mesh, b, first_id, vertices, cells, faces);
        for (const types::manifold_id id : mesh.get_manifold_ids())
          if (id != numbers::flat_manifold_id)
            manifolds[first_id + id] = mesh.get_manifold(id).clone();
        first_id = manifolds.empty() ? 0 : manifolds.rbegin()->first + 1;
      }
    triangulation.create_triangulation(vertices, cells, faces);
    for (const auto &[id, manifold] : manifolds)
      triangulation.set_manifold(id, *manifold);

    unsigned int most = 0, most_local = 0;
    for (const auto &body : bodies)
      {
        most       = std::max(most, body.refinements);
        most_local = std::max(most_local, body.local_refinements);
      }
    for (unsigned int level = 0; level < most; ++level)
      refine(triangulation,
             [&](const auto &cell) { return bodies[cell->material_id()].refinements > level; });

    std::vector<std::unique_ptr<FunctionParser<dim>>> selections;
    for (const auto &body : bodies)
      selections.push_back(make_function<dim, 1>({{body.refine_where}}, "h"));
    for (unsigned int level = 0; level < most_local; ++level)
      refine(triangulation, [&](const auto &cell) {
        const unsigned int b = cell->material_id();
        selections[b]->set_time(cell->diameter() / std::sqrt(dim));
        return bodies[b].local_refinements > level && selections[b]->value(cell->center()) > 0.;
      });
  }


  template void make_triangulation(const std::vector<BodyDescription<2>> &,
                                   parallel::distributed::Triangulation<2> &);
  template void make_triangulation(const std::vector<BodyDescription<3>> &,
                                   parallel::distributed::Triangulation<3> &);
} // namespace signorini
