// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/cell_moments.h>

namespace signorini
{
  template <int dim>
  VertexValues mass_moments(const Discretization<dim>                                &discretization,
                            const typename dealii::Triangulation<dim>::cell_iterator &cell,
                            const VertexValues                                       &values)
  {
    const auto         matrix = discretization.cell_matrices.of(cell);
    VertexValues       moments(values.size(), 0.);
    const unsigned int n_vertices = values.size() / dim;
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int b = 0; b < n_vertices; ++b)
        for (unsigned int c = 0; c < dim; ++c)
          moments[dim * a + c] += matrix.mass(a, b) * values[dim * b + c];
    return moments;
  }


  template <int dim>
  VertexValues stiffness_moments(const Discretization<dim>                                &discretization,
                                 const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                 const VertexValues                                       &values)
  {
    const auto         matrix = discretization.cell_matrices.of(cell);
    VertexValues       moments(values.size(), 0.);
    const unsigned int n_vertices = values.size() / dim;
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int b = 0; b < n_vertices; ++b)
        {
          const auto block = matrix.stiffness(a, b); // column by column
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              moments[dim * a + c] += block[dim * d + c] * values[dim * b + d];
        }
    return moments;
  }


#define INSTANTIATE(dim)                                                                                               \
  template VertexValues mass_moments(                                                                                  \
    const Discretization<dim> &, const dealii::Triangulation<dim>::cell_iterator &, const VertexValues &);             \
  template VertexValues stiffness_moments(                                                                             \
    const Discretization<dim> &, const dealii::Triangulation<dim>::cell_iterator &, const VertexValues &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
