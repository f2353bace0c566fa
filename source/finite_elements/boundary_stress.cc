// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/finite_elements/boundary_stress.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    double largest_nodal_force(const Discretization<dim> &discretization, const Vector &forces)
    {
      double square = 0.;
      for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
        {
          double of_node = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            of_node += std::pow(forces.local_element(dim * node + c), 2);
          square = std::max(square, of_node);
        }
      return std::sqrt(Utilities::MPI::max(square, discretization.communicator()));
    }


    template <int dim>
    bool bears(const typename DoFHandler<dim>::active_cell_iterator &cell,
               const unsigned int                                    face,
               const Vector                                         &forces,
               const double                                          least)
    {
      for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_face; ++v)
        {
          double square = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            square += std::pow(forces(cell->face(face)->vertex_dof_index(v, c)), 2);
          if (std::sqrt(square) > least)
            return true;
        }
      return false;
    }


    /** Integrals of the stress vector over faces of cells. */
    template <int dim>
    class FaceIntegral
    {
    public:
      explicit FaceIntegral(const Discretization<dim> &discretization)
        : mesh(discretization.mesh())
        , points(mesh.n_quadrature_points())
        , values(mesh.mapping(),
                 discretization.fe(),
                 points,
                 update_gradients | update_normal_vectors | update_JxW_values | update_jacobians
                   | update_quadrature_points)
        , gradients(points.size())
      {
      }

      Tensor<1, dim> of(const typename DoFHandler<dim>::active_cell_iterator &cell,
                        const unsigned int                                    face,
                        const Vector                                         &displacement)
      {
        values.reinit(cell, face);
        values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement, gradients);
        add_modes(cell, displacement);
        const Material &material = mesh.bodies()[cell->material_id()].material;
        Tensor<1, dim>  force;
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const auto strain = symmetrize(gradients[q]);
            const auto stress = material.lambda() * trace(strain) * unit_symmetric_tensor<dim>()
                                + 2. * material.mu() * strain;
            force += values.JxW(q) * (stress * values.normal_vector(q));
          }
        return force;
      }

    private:
      const Mesh<dim>            &mesh;
      const QGauss<dim - 1>       points;
      FEFaceValues<dim>           values;
      std::vector<Tensor<2, dim>> gradients;
      const FE_Q<dim>             vertex_functions{1};

      /** What the modes of the element add: polynomials on the unit cell over its volume. */
      void add_modes(const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const Vector                                         &displacement)
      {
        const auto matrix = mesh.cell_matrices().of(cell);
        if (!matrix.has_modes())
          return;
        std::vector<double> of_vertices;
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
            of_vertices.push_back(displacement(cell->vertex_dof_index(v, c)));
        const ModeGradient<dim> modes = matrix.mode_gradient(of_vertices.data());
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const Point<dim> place =
              mesh.mapping().transform_real_to_unit_cell(cell, values.quadrature_point(q));
            const double volume = determinant(Tensor<2, dim>(values.jacobian(q)));
            for (const unsigned int v : cell->vertex_indices())
              for (unsigned int c = 0; c < dim; ++c)
                for (unsigned int i = 0; i < dim; ++i)
                  gradients[q][c][i] +=
                    vertex_functions.shape_value(v, place) * modes[c][dim * v + i] / volume;
          }
      }
    };
  } // namespace


  template <int dim>
  BoundaryStress<dim>::BoundaryStress(const Discretization<dim> &discretization)
    : discretization(discretization)
  {
    for (const auto &cell : discretization.cells()) // in one order, whatever came before
      if (cell->is_locally_owned())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face))
            faces.push_back({cell, face});
  }


  template <int dim>
  std::vector<std::array<double, 3>> BoundaryStress<dim>::forces(const Vector &displacement,
                                                                 const Vector &contact_force) const
  {
    const unsigned int  n_bodies = discretization.mesh().bodies().size();
    std::vector<double> sums(3 * n_bodies, 0.);
    const double        largest = largest_nodal_force(discretization, contact_force);
    if (largest > 0.)
      {
        const Vector everywhere = discretization.interpolate_hanging_nodes(displacement),
                     of_contact = discretization.interpolate_hanging_nodes(contact_force);
        FaceIntegral<dim> integral(discretization);
        for (const BoundaryFace &boundary : faces)
          if (bears<dim>(boundary.cell, boundary.face, of_contact, unnoticed_force * largest))
            {
              const Tensor<1, dim> force = integral.of(boundary.cell, boundary.face, everywhere);
              for (unsigned int c = 0; c < dim; ++c)
                sums[3 * boundary.cell->material_id() + c] += force[c];
            }
        Utilities::MPI::sum(sums, discretization.communicator(), sums);
      }
    std::vector<std::array<double, 3>> result(n_bodies);
    for (std::size_t i = 0; i < sums.size(); ++i)
      result[i / 3][i % 3] = sums[i];
    return result;
  }


  template class BoundaryStress<2>;
  template class BoundaryStress<3>;
} // namespace signorini
