// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_discretization_distorted_h
#define signorini_tests_discretization_distorted_h

#include "bodies.h"

namespace signorini::tests
{
  constexpr ElementKind all_elements[] = {ElementKind::standard,
                                          ElementKind::enhanced,
                                          ElementKind::mean_dilatation};

  /** Corners 0 and 1, two cells per direction. */
  template <int dim>
  BodyDescription<dim> box_of(const ElementKind element, const double poissons_ratio)
  {
    BodyDescription<dim> body    = box<dim>();
    body.element                 = element;
    body.material.poissons_ratio = poissons_ratio;
    return body;
  }

  template <int dim>
  bool inside_unit_box(const dealii::Point<dim> &p)
  {
    for (unsigned int c = 0; c < dim; ++c)
      if (p[c] < 1e-10 || p[c] > 1. - 1e-10)
        return false;
    return true;
  }

  /** The unit box, its inner vertices moved by a part of the size of cells in any direction. */
  template <int dim>
  struct Distorted
  {
    Distorted(const BodyDescription<dim> &body, const double part)
      : mesh({body}, MPI_COMM_WORLD)
      , discretization(moved(mesh, part))
    {
    }

    Mesh<dim>           mesh;
    Discretization<dim> discretization;

  private:
    static const Mesh<dim> &moved(Mesh<dim> &mesh, const double part)
    {
      const double size = mesh.triangulation().begin(0)->minimum_vertex_distance()
                          / (1u << mesh.bodies()[0].refinements);
      std::vector<bool> done(mesh.triangulation().n_vertices());
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          if (dealii::Point<dim> &vertex = cell->vertex(v);
              !done[cell->vertex_index(v)] && inside_unit_box<dim>(vertex))
            {
              done[cell->vertex_index(v)] = true;
              double phase                = 1.; // knows the place, not the process
              for (unsigned int c = 0; c < dim; ++c)
                phase += (37. + 11. * c) * vertex[c];
              for (unsigned int c = 0; c < dim; ++c)
                vertex[c] += part * size * std::sin(phase * (3. + c));
            }
      mesh.update();
      return mesh;
    }
  };
} // namespace signorini::tests

#endif
