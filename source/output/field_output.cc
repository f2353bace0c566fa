// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/field_output.h>

#include <deal.II/numerics/data_out.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    using CellValues = dealii::Vector<double>;

    struct NamedComponent
    {
      std::string  name;
      unsigned int i, j;
    };

    /** What is zero in plane strain is not written. */
    template <int dim>
    std::vector<NamedComponent> strain_components()
    {
      std::vector<NamedComponent> components;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          components.push_back({std::string("strain_") + "xyz"[i] + "xyz"[j], i, j});
      return components;
    }


    /** Out-of-plane shear is zero in 2d and not written. */
    template <int dim>
    std::vector<NamedComponent> stress_components()
    {
      std::vector<NamedComponent> components = {
        {"stress_xx", 0, 0}, {"stress_yy", 1, 1}, {"stress_zz", 2, 2}, {"stress_xy", 0, 1}};
      if (dim == 3)
        {
          components.push_back({"stress_xz", 0, 2});
          components.push_back({"stress_yz", 1, 2});
        }
      return components;
    }
  } // namespace


  template <int dim>
  FieldOutput<dim>::FieldOutput(const std::string &directory, const MPI_Comm communicator)
    : volume_series(directory, "volume", communicator)
    , surface_series(directory, "surface", communicator)
  {
  }


  template <int dim>
  void FieldOutput<dim>::write(const State                  &state,
                               const Discretization<dim>    &discretization,
                               const ContactSurface<dim>    &surface,
                               const dealii::Vector<double> &indicators)
  {
    if (last_step == state.step)
      return;
    const Vector displacement = discretization.interpolate_hanging_nodes(state.displacement);
    const Vector velocity     = discretization.interpolate_hanging_nodes(state.velocity);
    write_volume(state, discretization, displacement, velocity, indicators);
    if (!surface.pairs().empty())
      {
        SurfacePatches<dim> surface_patches(discretization, surface);
        surface_patches.build(state, displacement, velocity);
        surface_series.write(surface_patches, state.step, state.time);
      }
    last_step = state.step;
  }


  template <int dim>
  void FieldOutput<dim>::write_volume(const State                  &state,
                                      const Discretization<dim>    &discretization,
                                      const Vector                 &displacement,
                                      const Vector                 &velocity,
                                      const dealii::Vector<double> &indicators)
  {
    const auto  &triangulation = discretization.mesh().triangulation();
    DataOut<dim> data;
    data.attach_dof_handler(discretization.dof_handler());
    const std::vector<DataComponentInterpretation::DataComponentInterpretation> vector(
      dim, DataComponentInterpretation::component_is_part_of_vector);
    data.add_data_vector(displacement,
                         std::vector<std::string>(dim, "displacement"),
                         DataOut<dim>::type_dof_data,
                         vector);
    data.add_data_vector(
      velocity, std::vector<std::string>(dim, "velocity"), DataOut<dim>::type_dof_data, vector);

    const auto stress_names = stress_components<dim>(), strain_names = strain_components<dim>();
    const auto strains  = mean_strains(discretization, displacement);
    const auto stresses = cell_stress(discretization, strains);
    // DataOut keeps references to the values until the patches are built.
    std::vector<CellValues> stress_values(stress_names.size(), CellValues(strains.size())),
      strain_values(strain_names.size(), CellValues(strains.size()));
    CellValues body(strains.size()), equivalent(strains.size()), subdomain(strains.size());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int index = cell->active_cell_index();
          body[index]              = cell->material_id();
          subdomain[index]         = cell->subdomain_id();
          equivalent[index]        = von_mises(stresses[index]);
          for (unsigned int c = 0; c < stress_names.size(); ++c)
            stress_values[c][index] = stresses[index][stress_names[c].i][stress_names[c].j];
          for (unsigned int c = 0; c < strain_names.size(); ++c)
            strain_values[c][index] = strains[index][strain_names[c].i][strain_names[c].j];
        }
    data.add_data_vector(body, "body", DataOut<dim>::type_cell_data);
    data.add_data_vector(equivalent, "von_mises", DataOut<dim>::type_cell_data);
    for (unsigned int c = 0; c < stress_names.size(); ++c)
      data.add_data_vector(stress_values[c], stress_names[c].name, DataOut<dim>::type_cell_data);
    for (unsigned int c = 0; c < strain_names.size(); ++c)
      data.add_data_vector(strain_values[c], strain_names[c].name, DataOut<dim>::type_cell_data);
    data.add_data_vector(subdomain, "subdomain", DataOut<dim>::type_cell_data);
    if (indicators.size() > 0)
      data.add_data_vector(indicators, "error_indicator", DataOut<dim>::type_cell_data);

    data.build_patches(discretization.mesh().mapping(), 1);
    volume_series.write(data, state.step, state.time);
  }


  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace signorini
