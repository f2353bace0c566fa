// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/simulation/element_warnings.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Poisson's ratio from which a standard cell resists much more than it should. */
    constexpr double nearly_incompressible = 0.45;

    /** Length over thickness from which on a body bends more than it shears. */
    constexpr double slender = 5.;


    /**
     * The thickness of a body at a face of a cell if there are no more than two cells between this
     * face and the boundary behind it; otherwise infinite.
     */
    template <int dim>
    double thickness(const typename Triangulation<dim>::active_cell_iterator &cell,
                     const unsigned int                                       face)
    {
      const Point<dim> start    = cell->face(face)->center();
      const auto       opposite = GeometryInfo<dim>::opposite_face[face];
      if (cell->face(opposite)->at_boundary())
        return start.distance(cell->face(opposite)->center());
      const auto neighbor = cell->neighbor(opposite);
      if (neighbor->has_children() || neighbor->level() != cell->level())
        return std::numeric_limits<double>::max();
      // The neighbour may count its faces in another way.
      const auto last =
        neighbor->face(GeometryInfo<dim>::opposite_face[cell->neighbor_of_neighbor(opposite)]);
      return last->at_boundary() ? start.distance(last->center())
                                 : std::numeric_limits<double>::max();
    }


    /** By body: the part of its cells where it is slender with one or two cells in its thickness.
     */
    template <int dim>
    std::vector<double> thin_parts(const Mesh<dim> &mesh)
    {
      const std::size_t   n_bodies = mesh.bodies().size();
      std::vector<double> counts(2 * n_bodies, 0.);
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned())
          {
            const auto body = cell->material_id();
            bool       thin = false;
            for (const unsigned int f : cell->face_indices())
              thin = thin
                     || (cell->face(f)->at_boundary()
                         && slender * thickness<dim>(cell, f) <= mesh.body_size(body));
            counts[2 * body] += 1.;
            counts[2 * body + 1] += thin;
          }
      Utilities::MPI::sum(counts, mesh.communicator(), counts);
      std::vector<double> parts;
      for (std::size_t b = 0; b < n_bodies; ++b)
        parts.push_back(counts[2 * b + 1] / counts[2 * b]);
      return parts;
    }
  } // namespace


  template <int dim>
  std::vector<std::string> element_warnings(const Mesh<dim> &mesh)
  {
    const std::vector<double> thin = thin_parts(mesh);
    std::vector<std::string>  result;
    for (std::size_t b = 0; b < thin.size(); ++b)
      {
        const BodyDescription<dim> &body    = mesh.bodies()[b];
        const std::string           element = "`Element = " + name_of(body.element) + "`";
        if (body.element == ElementKind::standard
            && body.material.poissons_ratio >= nearly_incompressible)
          result.push_back("the body '" + body.name
                           + "' is nearly incompressible, which makes cells with " + element
                           + " far too stiff. Set `Element = enhanced`.");
        if (body.element != ElementKind::enhanced && thin[b] > 0.5)
          result.push_back(
            "the body '" + body.name + "' has one or two cells in its thickness, too few for "
            + element + " if it bends ("
            + (body.element == ElementKind::standard ? "13 to 36 % too stiff" : "too soft")
            + " at Poisson's ratio 0.3). Set `Element = enhanced`, or refine.");
      }
    return result;
  }


  template std::vector<std::string> element_warnings(const Mesh<2> &);
  template std::vector<std::string> element_warnings(const Mesh<3> &);
} // namespace signorini
