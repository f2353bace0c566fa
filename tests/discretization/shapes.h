// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_discretization_shapes_h
#define signorini_tests_discretization_shapes_h

#include "bodies.h"

#include <signorini/discretization/make_triangulation.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <map>

namespace signorini::tests
{
  /** The refined mesh of one body, as the program makes it. */
  template <int dim>
  struct Meshed
  {
    explicit Meshed(const BodyDescription<dim> &body)
      : triangulation(MPI_COMM_WORLD)
    {
      make_triangulation<dim>({body}, triangulation);
    }

    dealii::parallel::distributed::Triangulation<dim> triangulation;
  };

  template <int dim>
  double volume(const dealii::parallel::distributed::Triangulation<dim> &mesh)
  {
    double sum = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        sum += cell->measure();
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  /**
   * Call a function with each vertex (on this process) of each boundary face, and the boundary id
   * of the face.
   */
  template <int dim, typename Function>
  void for_boundary_vertices(const dealii::parallel::distributed::Triangulation<dim> &mesh,
                             const Function                                          &function)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            for (const unsigned int v : face->vertex_indices())
              function(face->vertex(v), face->boundary_id());
  }

  /** Area of the part of the boundary with each boundary id that is less than 10. */
  template <int dim>
  std::map<unsigned int, double>
  boundary_areas(const dealii::parallel::distributed::Triangulation<dim> &mesh)
  {
    const dealii::FE_Nothing<dim> none;
    dealii::FEFaceValues<dim> values(none, dealii::QGauss<dim - 1>(3), dealii::update_JxW_values);
    std::vector<double>       areas(10);
    std::map<unsigned int, double> result;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              values.reinit(cell, f);
              for (const double weight : values.get_JxW_values())
                areas.at(cell->face(f)->boundary_id()) += weight;
            }
    for (unsigned int id = 0; id < areas.size(); ++id)
      {
        const double area = dealii::Utilities::MPI::sum(areas[id], MPI_COMM_WORLD);
        if (area > 0.)
          result[id] = area;
      }
    return result;
  }
} // namespace signorini::tests

#endif
