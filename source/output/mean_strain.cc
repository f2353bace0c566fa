// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/mean_strain.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  MeanStrain<dim>::MeanStrain(const Discretization<dim> &discretization)
  {
    const auto   &mesh = discretization.mesh();
    FEValues<dim> fe_values(mesh.mapping(),
                            discretization.fe(),
                            QGauss<dim>(mesh.n_quadrature_points()),
                            update_gradients | update_JxW_values);
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          CellVectors<dim> mean;
          double           volume = 0.;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              volume += fe_values.JxW(q);
              // Each vertex has one shape function, repeated for the components.
              for (unsigned int v = 0; v < mean.size(); ++v)
                mean[v] += fe_values.JxW(q) * fe_values.shape_grad(dim * v, q);
            }
          for (auto &gradient : mean)
            gradient /= volume;
          gradients.push_back(mean);
        }
  }


  template <int dim>
  SymmetricTensor<2, dim> MeanStrain<dim>::of(const unsigned int      cell,
                                              const CellVectors<dim> &displacement) const
  {
    AssertIndexRange(cell, gradients.size());
    Tensor<2, dim> gradient;
    // The gradients add up to zero: of differences, a translation has no strain to the last digit.
    for (unsigned int v = 1; v < displacement.size(); ++v)
      gradient += outer_product(displacement[v] - displacement[0], gradients[cell][v]);
    return symmetrize(gradient);
  }


  template <int dim>
  std::array<unsigned int, GeometryInfo<dim>::vertices_per_cell>
  places_of_vertices(const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const Vector                                         &vector)
  {
    std::array<unsigned int, GeometryInfo<dim>::vertices_per_cell> places;
    for (unsigned int v = 0; v < places.size(); ++v)
      places[v] = vector.get_partitioner()->global_to_local(cell->vertex_dof_index(v, 0));
    return places;
  }


  template <int dim>
  CellVectors<dim>
  values_at_vertices(const Vector                                                         &vector,
                     const std::array<unsigned int, GeometryInfo<dim>::vertices_per_cell> &places)
  {
    CellVectors<dim> values;
    for (unsigned int v = 0; v < places.size(); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        values[v][c] = vector.local_element(places[v] + c);
    return values;
  }


#define INSTANTIATE(dim)                                                                           \
  template class MeanStrain<dim>;                                                                  \
  template std::array<unsigned int, GeometryInfo<dim>::vertices_per_cell> places_of_vertices<dim>( \
    const DoFHandler<dim>::active_cell_iterator &, const Vector &);                                \
  template CellVectors<dim> values_at_vertices<dim>(                                               \
    const Vector &, const std::array<unsigned int, GeometryInfo<dim>::vertices_per_cell> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
