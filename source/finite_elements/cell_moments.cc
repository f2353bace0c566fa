// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/cell_moments.h>

namespace signorini
{
  namespace
  {
    /** Sum over all pairs of vertices; add(moments at a, matrix, a, b, values at b). */
    template <int dim, typename Add>
    VertexValues sum_over_pairs(const Discretization<dim> &discretization,
                                const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                const VertexValues                                       &values,
                                const Add                                                &add)
    {
      const auto         matrix     = discretization.mesh().cell_matrices().of(cell);
      const unsigned int n_vertices = values.size() / dim;
      VertexValues       moments(values.size(), 0.);
      for (unsigned int a = 0; a < n_vertices; ++a)
        for (unsigned int b = 0; b < n_vertices; ++b)
          add(&moments[dim * a], matrix, a, b, &values[dim * b]);
      return moments;
    }
  } // namespace


  template <int dim>
  VertexValues mass_moments(const Discretization<dim> &discretization,
                            const typename dealii::Triangulation<dim>::cell_iterator &cell,
                            const VertexValues                                       &values)
  {
    return sum_over_pairs(discretization,
                          cell,
                          values,
                          [](double            *moments,
                             const auto        &matrix,
                             const unsigned int a,
                             const unsigned int b,
                             const double      *value) {
                            const double mass = matrix.mass(a, b);
                            for (unsigned int c = 0; c < dim; ++c)
                              moments[c] += mass * value[c];
                          });
  }


  template <int dim>
  VertexValues stiffness_moments(const Discretization<dim> &discretization,
                                 const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                 const VertexValues                                       &values)
  {
    return sum_over_pairs(discretization,
                          cell,
                          values,
                          [](double            *moments,
                             const auto        &matrix,
                             const unsigned int a,
                             const unsigned int b,
                             const double      *value) {
                            const auto block = matrix.stiffness(a, b); // column by column
                            for (unsigned int d = 0; d < dim; ++d)
                              for (unsigned int c = 0; c < dim; ++c)
                                moments[c] += block[dim * d + c] * value[d];
                          });
  }


#define INSTANTIATE(dim)                                                                           \
  template VertexValues mass_moments(const Discretization<dim> &,                                  \
                                     const dealii::Triangulation<dim>::cell_iterator &,            \
                                     const VertexValues &);                                        \
  template VertexValues stiffness_moments(const Discretization<dim> &,                             \
                                          const dealii::Triangulation<dim>::cell_iterator &,       \
                                          const VertexValues &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
