// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_estimate.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_interface_values.h>

#include <deal.II/meshworker/mesh_loop.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    struct Scratch
    {
      explicit Scratch(const Discretization<dim> &discretization)
        : discretization(discretization)
        , interface_values(discretization.mapping,
                           discretization.fe,
                           QGauss<dim - 1>(discretization.n_quadrature_points()),
                           update_gradients | update_JxW_values | update_normal_vectors)
      {
      }

      Scratch(const Scratch &other)
        : Scratch(other.discretization)
      {
      }

      const Discretization<dim>                          &discretization;
      FEInterfaceValues<dim>                              interface_values;
      std::array<std::vector<SymmetricTensor<2, dim>>, 2> strains;
    };

    /** Contributions to the squares of cells. */
    using Contributions = std::vector<std::pair<unsigned int, double>>;
  } // namespace


  template <int dim>
  void add_stress_jumps(const Discretization<dim> &discretization,
                        const Vector              &displacement,
                        const ResidualWeights     &weights,
                        dealii::Vector<double>    &squares)
  {
    using Cell = typename DoFHandler<dim>::active_cell_iterator;
    const FEValuesExtractors::Vector vector(0);
    // A face between cells of different size is visited from the smaller one, so that it is the face of `cell` always.
    const auto integrate = [&](const Cell        &cell,
                               const unsigned int face,
                               const unsigned int subface,
                               const Cell        &neighbor,
                               const unsigned int neighbor_face,
                               const unsigned int neighbor_subface,
                               Scratch<dim>      &scratch,
                               Contributions     &contributions) {
      auto &values = scratch.interface_values;
      values.reinit(cell, face, subface, neighbor, neighbor_face, neighbor_subface);
      for (const unsigned int side : {0, 1})
        {
          scratch.strains[side].resize(values.n_quadrature_points);
          values.get_fe_face_values(side)[vector].get_function_symmetric_gradients(displacement, scratch.strains[side]);
        }
      const Material &material = discretization.scene.bodies[cell->material_id()].material;
      double          square   = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        square += (stress_of_strain<dim>(material, scratch.strains[0][q] - scratch.strains[1][q]) * values.normal(q))
                    .norm_square()
                  * values.JxW(q);
      const double h    = cell->face(face)->diameter() / std::sqrt(dim - 1.);
      const double half = 0.5 * weights.face(material, h) * square;
      for (const Cell &side : {cell, neighbor})
        if (side->is_locally_owned())
          contributions.emplace_back(side->active_cell_index(), half);
    };
    MeshWorker::mesh_loop(
      discretization.dof_handler.active_cell_iterators(),
      std::function<void(const Cell &, Scratch<dim> &, Contributions &)>(),
      [&](const Contributions &contributions) {
        for (const auto &[cell, value] : contributions)
          squares(cell) += value;
      },
      Scratch<dim>(discretization),
      Contributions(),
      MeshWorker::assemble_own_interior_faces_once | MeshWorker::assemble_ghost_faces_both,
      {},
      integrate);
  }


  template void
  add_stress_jumps(const Discretization<2> &, const Vector &, const ResidualWeights &, dealii::Vector<double> &);
  template void
  add_stress_jumps(const Discretization<3> &, const Vector &, const ResidualWeights &, dealii::Vector<double> &);
} // namespace signorini
