// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/finite_elements/boundary_stress.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <cmath>
#include <optional>

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


    /** Integrals of the stress vector over faces of cells, as linear functions. */
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
      {
      }

      /** What each degree of freedom of the cell adds to the force. */
      std::vector<Tensor<1, dim>> of(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                     const unsigned int                                    face)
      {
        values.reinit(cell, face);
        const auto                  matrix = mesh.cell_matrices().of(cell);
        std::vector<Tensor<1, dim>> result(values.dofs_per_cell);
        for (unsigned int k = 0; k < dim; ++k)
          {
            std::array<double, CellModes<dim>::n_dofs> forces{};
            ModeGradient<dim>                          of_modes{};
            for (unsigned int q = 0; q < points.size(); ++q)
              {
                const auto stress = stress_of_component(k, q, cell->material_id());
                for (unsigned int i = 0; i < forces.size(); ++i)
                  forces[i] +=
                    scalar_product(stress, values[FEValuesExtractors::Vector(0)].gradient(i, q));
                if (matrix.has_modes())
                  add_modes(cell, q, stress, of_modes);
              }
            if (matrix.has_modes())
              matrix.add_mode_forces(of_modes, forces.data());
            for (unsigned int i = 0; i < forces.size(); ++i)
              result[i][k] = forces[i];
          }
        return result;
      }

    private:
      const Mesh<dim>      &mesh;
      const QGauss<dim - 1> points;
      FEFaceValues<dim>     values;
      const FE_Q<dim>       vertex_functions{1};

      /** Whose product with a gradient is that component of the stress vector. */
      Tensor<2, dim>
      stress_of_component(const unsigned int k, const unsigned int q, const unsigned int body) const
      {
        const Material &material = mesh.bodies()[body].material;
        Tensor<1, dim>  direction;
        direction[k]      = values.JxW(q);
        const auto strain = symmetrize(outer_product(direction, values.normal_vector(q)));
        return material.lambda() * trace(strain) * unit_symmetric_tensor<dim>()
               + 2. * material.mu() * strain;
      }

      /** What the modes of the element add: polynomials on the unit cell over its volume. */
      void add_modes(const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const unsigned int                                    q,
                     const Tensor<2, dim>                                 &stress,
                     ModeGradient<dim>                                    &of_modes) const
      {
        const Point<dim> place =
          mesh.mapping().transform_real_to_unit_cell(cell, values.quadrature_point(q));
        const double volume = determinant(Tensor<2, dim>(values.jacobian(q)));
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int i = 0; i < dim; ++i)
              of_modes[c][dim * v + i] +=
                vertex_functions.shape_value(v, place) * stress[c][i] / volume;
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
            faces.push_back({cell, face, {}});
  }


  template <int dim>
  std::vector<std::array<double, 3>> BoundaryStress<dim>::forces(const Vector &displacement,
                                                                 const Vector &contact_force)
  {
    const unsigned int  n_bodies = discretization.mesh().bodies().size();
    std::vector<double> sums(3 * n_bodies, 0.);
    const double        largest = largest_nodal_force(discretization, contact_force);
    if (largest > 0.)
      {
        const Vector everywhere = discretization.interpolate_hanging_nodes(displacement),
                     of_contact = discretization.interpolate_hanging_nodes(contact_force);
        std::optional<FaceIntegral<dim>> integral;
        for (BoundaryFace &boundary : faces)
          if (bears<dim>(boundary.cell, boundary.face, of_contact, unnoticed_force * largest))
            {
              if (boundary.force_of_dofs.empty())
                {
                  if (!integral)
                    integral.emplace(discretization);
                  boundary.force_of_dofs = integral->of(boundary.cell, boundary.face);
                }
              const Tensor<1, dim> force = boundary.force_of(everywhere);
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


  template <int dim>
  Tensor<1, dim> BoundaryStress<dim>::BoundaryFace::force_of(const Vector &displacement) const
  {
    Tensor<1, dim> force;
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int c = 0; c < dim; ++c)
        force += displacement(cell->vertex_dof_index(v, c)) * force_of_dofs[dim * v + c];
    return force;
  }


  template class BoundaryStress<2>;
  template class BoundaryStress<3>;
} // namespace signorini
