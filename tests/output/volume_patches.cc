// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The patches are those that DataOut of deal.II builds, by its finite elements and from vectors, on
// the first mesh and on the ones that follow.

#include "box_above_floor.h"

#include <signorini/output/cell_stress.h>
#include <signorini/output/volume_patches.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/numerics/data_out.h>

#include <gtest/gtest.h>

#include <map>

using namespace signorini;

namespace
{
  /** Gives access to what it would write. */
  template <int dim>
  class Reference : public dealii::DataOut<dim>
  {
  public:
    using dealii::DataOut<dim>::get_patches;
    using dealii::DataOut<dim>::get_dataset_names;
  };


  /** The von Mises stress of the mean strain, by quadrature. */
  template <int dim>
  dealii::Vector<double> equivalent_stress(const Discretization<dim> &discretization,
                                           const Vector              &displacement)
  {
    dealii::Vector<double> result(discretization.mesh().triangulation().n_active_cells());
    dealii::FEValues<dim>  fe_values(discretization.mesh().mapping(),
                                    discretization.fe(),
                                    dealii::QGauss<dim>(2),
                                    dealii::update_gradients | dealii::update_JxW_values);
    std::vector<dealii::SymmetricTensor<2, dim>> strains(fe_values.n_quadrature_points);
    for (const auto &cell : discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          fe_values[dealii::FEValuesExtractors::Vector(0)].get_function_symmetric_gradients(
            displacement, strains);
          dealii::SymmetricTensor<2, dim> mean;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            mean += fe_values.JxW(q) / cell->measure() * strains[q];
          result[cell->active_cell_index()] = von_mises(
            stress_of<dim>(discretization.mesh().bodies()[cell->material_id()].material, mean));
        }
    return result;
  }


  /** Of the cells of this process, by active_cell_index: the order of the reference. */
  template <int dim>
  std::map<unsigned int, unsigned int> places_in_triangulation(const Mesh<dim> &mesh)
  {
    std::map<unsigned int, unsigned int> place;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        place.emplace(cell->active_cell_index(), place.size());
    return place;
  }


  template <int dim>
  void expect_same(VolumePatches<dim> &patches, const Mesh<dim> &mesh, const bool indicators)
  {
    const Discretization<dim>    discretization(mesh);
    std::array<std::string, dim> bend, flow;
    bend[0]       = "0.1*x*y + 0.3*y^2";
    bend[dim - 1] = "0.2*x";
    flow[0]       = "1 - x";
    const Vector displacement =
      discretization.interpolate_hanging_nodes(discretization.interpolate({bend}));
    const Vector velocity =
      discretization.interpolate_hanging_nodes(discretization.interpolate({flow}));
    dealii::Vector<double> errors(indicators ? mesh.triangulation().n_active_cells() : 0);
    for (unsigned int i = 0; i < errors.size(); ++i)
      errors[i] = 0.5 * i;
    patches.build(discretization, displacement, velocity, errors);

    Reference<dim> reference;
    reference.attach_dof_handler(discretization.dof_handler());
    const std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation> vector(
      dim, dealii::DataComponentInterpretation::component_is_part_of_vector);
    reference.add_data_vector(displacement,
                              std::vector<std::string>(dim, "displacement"),
                              dealii::DataOut<dim>::type_dof_data,
                              vector);
    reference.add_data_vector(velocity,
                              std::vector<std::string>(dim, "velocity"),
                              dealii::DataOut<dim>::type_dof_data,
                              vector);
    const auto stress = equivalent_stress(discretization, displacement);
    reference.add_data_vector(stress, "von_mises", dealii::DataOut<dim>::type_cell_data);
    if (indicators)
      reference.add_data_vector(errors, "error_indicator", dealii::DataOut<dim>::type_cell_data);
    reference.build_patches(mesh.mapping(), 1);

    const auto names = patches.get_dataset_names(), expected = reference.get_dataset_names();
    ASSERT_EQ(patches.get_patches().size(), reference.get_patches().size());
    const auto   place = places_in_triangulation(mesh);
    unsigned int k     = 0;
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        {
          const auto &patch = patches.get_patches()[k++];
          const auto &other = reference.get_patches()[place.at(cell->active_cell_index())];
          ASSERT_EQ(patch.data.n_rows(), names.size());
          for (unsigned int v = 0; v < patch.data.n_cols(); ++v)
            {
              EXPECT_EQ(patch.vertices[v], other.vertices[v]);
              for (unsigned int c = 0; c < expected.size(); ++c)
                {
                  // Components of a vector have one name and stand side by side.
                  const auto row = std::find(names.begin(), names.end(), expected[c])
                                   - names.begin() + (c < 2 * dim ? c % dim : 0);
                  EXPECT_NEAR(patch.data(row, v), other.data(c, v), 1e-6) << expected[c];
                }
            }
        }
  }


  template <int dim>
  void check()
  {
    const Scene<dim>   scene = box_above_floor<dim>();
    Mesh<dim>          mesh(scene.bodies, MPI_COMM_WORLD, CellGeometry::linear, true);
    VolumePatches<dim> patches;
    expect_same(patches, mesh, false);
    expect_same(patches, mesh, true);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && cell->center()[1] > 0.5)
        cell->set_refine_flag();
    mesh.carry_out_flags();
    expect_same(patches, mesh, true);
    const Mesh<dim> another(scene.bodies, MPI_COMM_WORLD);
    expect_same(patches, another, false);
  }
} // namespace

TEST(VolumePatches, TheSameAsDataOut)
{
  check<2>();
  check<3>();
}
