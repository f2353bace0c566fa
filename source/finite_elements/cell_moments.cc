// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/cell_moments.h>

#include <deal.II/fe/fe_values.h>

#include <array>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using CellOfMesh = typename Triangulation<dim>::cell_iterator;

    /** Where a cell is in its parent. */
    template <int dim>
    unsigned int place_in_parent(const CellOfMesh<dim> &cell)
    {
      unsigned int place = 0;
      while (cell->parent()->child_index(place) != cell->index())
        ++place;
      return place;
    }


    template <int dim>
    const FullMatrix<double> &prolongation(const Discretization<dim> &discretization,
                                           const CellOfMesh<dim>     &child)
    {
      return discretization.fe().base_element(0).get_prolongation_matrix(
        place_in_parent<dim>(child));
    }


    /** Values of a function of the parent at the vertices of a child. */
    template <int dim>
    VertexValues prolongated(const FullMatrix<double> &weights, const VertexValues &values)
    {
      VertexValues result(values.size(), 0.);
      for (unsigned int a = 0; a < weights.m(); ++a)
        for (unsigned int b = 0; b < weights.n(); ++b)
          for (unsigned int c = 0; c < dim; ++c)
            result[dim * a + c] += weights(a, b) * values[dim * b + c];
      return result;
    }


    /** Moments against functions of the parent, from those against functions of a child. */
    template <int dim>
    VertexValues restricted(const FullMatrix<double> &weights, const VertexValues &moments)
    {
      VertexValues result(moments.size(), 0.);
      for (unsigned int a = 0; a < weights.m(); ++a)
        for (unsigned int b = 0; b < weights.n(); ++b)
          for (unsigned int c = 0; c < dim; ++c)
            result[dim * b + c] += weights(a, b) * moments[dim * a + c];
      return result;
    }


    /**
     * @param of_smaller makes moments of values, both of the smaller of the cells: right where the
     *                   larger one has no function that the smaller one has not
     */
    template <int dim, typename OfSmaller>
    VertexValues nested(const Discretization<dim> &discretization,
                        const CellOfMesh<dim>     &of,
                        const VertexValues        &values,
                        const CellOfMesh<dim>     &against,
                        const OfSmaller           &of_smaller)
    {
      if (of->level() < against->level())
        return of_smaller(against,
                          prolongated<dim>(prolongation<dim>(discretization, against), values));
      const VertexValues moments = of_smaller(of, values);
      return of->level() == against->level()
               ? moments
               : restricted<dim>(prolongation<dim>(discretization, of), moments);
    }


    /** Sum over all pairs of vertices; add(moments at a, a, b, values at b). */
    template <int dim, typename Add>
    VertexValues sum_over_pairs(const VertexValues &values, const Add &add)
    {
      const unsigned int n_vertices = values.size() / dim;
      VertexValues       moments(values.size(), 0.);
      for (unsigned int a = 0; a < n_vertices; ++a)
        for (unsigned int b = 0; b < n_vertices; ++b)
          add(&moments[dim * a], a, b, &values[dim * b]);
      return moments;
    }


    /** Between a parent and a child of a body whose strain has modes. */
    template <int dim>
    class StrainMoments
    {
    public:
      StrainMoments(const Discretization<dim> &discretization,
                    const CellOfMesh<dim>     &of,
                    const CellOfMesh<dim>     &against)
        : discretization(discretization)
        , of(of)
        , against(against)
        , smaller(of->level() < against->level() ? against : of)
        , weights(prolongation<dim>(discretization, smaller))
      {
      }

      VertexValues operator()(const VertexValues &values)
      {
        const auto             &matrices = discretization.mesh().cell_matrices();
        const ModeGradient<dim> modes    = matrices.of(of).mode_gradient(values.data());
        const VertexValues      here = of == smaller ? values : prolongated<dim>(weights, values);
        VertexValues            moments(values.size(), 0.);
        ModeGradient<dim>       stress{}; // of the modes of `against`, see CellModes
        const FEValues<dim>    &fe_values = matrices.values_on(smaller);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const Point<dim>    &point = fe_values.get_quadrature().point(q);
            const Tensor<2, dim> sigma = stress_at(fe_values, q, here, modes);
            for (unsigned int v = 0; v < n_vertices; ++v)
              for (unsigned int c = 0; c < dim; ++c)
                moments[dim * v + c] += sigma[c] * fe_values.shape_grad(v, q) * fe_values.JxW(q);
            const auto   shape = shape_values(against, point);
            const double volume =
              fe_values.get_quadrature().weight(q) * part_of_reference_cell(against);
            for (unsigned int v = 0; v < n_vertices; ++v)
              for (unsigned int c = 0; c < dim; ++c)
                for (unsigned int i = 0; i < dim; ++i)
                  stress[c][dim * v + i] += sigma[c][i] * shape[v] * volume;
          }
        if (against != smaller)
          moments = restricted<dim>(weights, moments);
        matrices.of(against).add_mode_forces(stress, moments.data());
        return moments;
      }

    private:
      static constexpr unsigned int n_vertices = 1u << dim;

      const Discretization<dim> &discretization;
      const CellOfMesh<dim>      of, against, smaller;
      const FullMatrix<double>  &weights;

      /** The functions of one of the cells at a point of the smaller one. */
      std::array<double, n_vertices> shape_values(const CellOfMesh<dim> &cell,
                                                  const Point<dim>      &point) const
      {
        const Point<dim> in_cell =
          cell == smaller
            ? point
            : GeometryInfo<dim>::child_to_cell_coordinates(point, place_in_parent<dim>(smaller));
        std::array<double, n_vertices> values;
        for (unsigned int v = 0; v < n_vertices; ++v)
          values[v] = GeometryInfo<dim>::d_linear_shape_function(in_cell, v);
        return values;
      }

      /** What the smaller cell is of the reference cell of a cell. */
      double part_of_reference_cell(const CellOfMesh<dim> &cell) const
      {
        return cell == smaller ? 1. : 1. / (1u << dim);
      }

      /**
       * @param values of the displacement, at the vertices of the smaller cell
       * @param modes  of the cell `of`
       */
      Tensor<2, dim> stress_at(const FEValues<dim>     &fe_values,
                               const unsigned int       q,
                               const VertexValues      &values,
                               const ModeGradient<dim> &modes) const
      {
        const auto   shape = shape_values(of, fe_values.get_quadrature().point(q));
        const double volume =
          fe_values.JxW(q) / fe_values.get_quadrature().weight(q) / part_of_reference_cell(of);
        Tensor<2, dim> gradient;
        for (unsigned int v = 0; v < n_vertices; ++v)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int i = 0; i < dim; ++i)
              gradient[c][i] += values[dim * v + c] * fe_values.shape_grad(v, q)[i]
                                + modes[c][dim * v + i] * shape[v] / volume;
        const Material &material = discretization.mesh().bodies()[of->material_id()].material;
        return material.mu() * (gradient + transpose(gradient))
               + material.lambda() * trace(gradient)
                   * static_cast<Tensor<2, dim>>(unit_symmetric_tensor<dim>());
      }
    };
  } // namespace


  template <int dim>
  VertexValues mass_moments(const Discretization<dim> &discretization,
                            const CellOfMesh<dim>     &of,
                            const VertexValues        &values,
                            const CellOfMesh<dim>     &against)
  {
    return nested<dim>(
      discretization, of, values, against, [&](const auto &cell, const VertexValues &local) {
        const auto matrix = discretization.mesh().cell_matrices().of(cell);
        return sum_over_pairs<dim>(
          local, [&](double *moments, const unsigned int a, const unsigned int b, const double *u) {
            const double mass = matrix.mass(a, b);
            for (unsigned int c = 0; c < dim; ++c)
              moments[c] += mass * u[c];
          });
      });
  }


  template <int dim>
  VertexValues stiffness_moments(const Discretization<dim> &discretization,
                                 const CellOfMesh<dim>     &of,
                                 const VertexValues        &values,
                                 const CellOfMesh<dim>     &against)
  {
    const auto &body = discretization.mesh().bodies()[of->material_id()];
    if (of->level() != against->level() && !strain_modes<dim>(body.element).empty())
      return StrainMoments<dim>(discretization, of, against)(values);
    return nested<dim>(
      discretization, of, values, against, [&](const auto &cell, const VertexValues &local) {
        const auto matrix = discretization.mesh().cell_matrices().of(cell);
        return sum_over_pairs<dim>(
          local, [&](double *moments, const unsigned int a, const unsigned int b, const double *u) {
            const auto block = matrix.stiffness(a, b); // column by column
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int c = 0; c < dim; ++c)
                moments[c] += block[dim * d + c] * u[d];
          });
      });
  }


#define INSTANTIATE(dim)                                                                           \
  template VertexValues mass_moments(const Discretization<dim> &,                                  \
                                     const Triangulation<dim>::cell_iterator &,                    \
                                     const VertexValues &,                                         \
                                     const Triangulation<dim>::cell_iterator &);                   \
  template VertexValues stiffness_moments(const Discretization<dim> &,                             \
                                          const Triangulation<dim>::cell_iterator &,               \
                                          const VertexValues &,                                    \
                                          const Triangulation<dim>::cell_iterator &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
