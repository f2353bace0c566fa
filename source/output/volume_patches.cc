// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/cell_stress.h>
#include <signorini/output/volume_patches.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
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
  void VolumePatches<dim>::use_mesh(const Discretization<dim> &discretization)
  {
    const auto &cells = discretization.mesh().triangulation();
    change_of_mesh    = cells.signals.any_change.connect([this] { mean_strain.reset(); });
    triangulation     = &cells;
    patches.clear();
    for (const auto &cell : discretization.mesh().active_cells())
      if (cell->is_locally_owned())
        {
          Patch patch;
          patch.n_subdivisions = 1;
          patch.reference_cell = ReferenceCells::get_hypercube<dim>();
          patch.patch_index    = patches.size();
          for (const unsigned int v : cell->vertex_indices())
            patch.vertices[v] = cell->vertex(v);
          patches.push_back(patch);
        }
    mean_strain = std::make_unique<MeanStrain<dim>>(discretization);
  }


  template <int dim>
  void VolumePatches<dim>::build(const Discretization<dim>    &discretization,
                                 const Vector                 &displacement,
                                 const Vector                 &velocity,
                                 const dealii::Vector<double> &indicators)
  {
    if (!mean_strain || triangulation != &discretization.mesh().triangulation())
      use_mesh(discretization);
    with_indicators                  = indicators.size() > 0;
    const auto          stress_names = stress_components<dim>();
    const auto          strain_names = strain_components<dim>();
    const unsigned int  n_components = get_dataset_names().size();
    unsigned int        k            = 0;
    std::vector<double> of_cell; // in the order of the names, behind those of the vertices
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        {
          const auto   places = places_of_vertices<dim>(cell, displacement);
          const auto   moved  = values_at_vertices<dim>(displacement, places);
          const auto   moving = values_at_vertices<dim>(velocity, places);
          const auto   strain = mean_strain->of(k, moved);
          const auto  &body   = discretization.mesh().bodies()[cell->material_id()];
          const Stress stress = stress_of<dim>(body.material, strain);
          of_cell             = {static_cast<double>(cell->material_id()), von_mises(stress)};
          for (const auto &[name, i, j] : stress_names)
            of_cell.push_back(stress[i][j]);
          for (const auto &[name, i, j] : strain_names)
            of_cell.push_back(strain[i][j]);
          of_cell.push_back(cell->subdomain_id());
          if (with_indicators)
            of_cell.push_back(indicators[cell->active_cell_index()]);

          auto &data = patches[k++].data;
          data.reinit(n_components, places.size(), true);
          for (unsigned int v = 0; v < places.size(); ++v)
            for (unsigned int c = 0; c < dim; ++c)
              {
                data(c, v)       = moved[v][c];
                data(dim + c, v) = moving[v][c];
              }
          for (unsigned int c = 0; c < of_cell.size(); ++c)
            for (unsigned int v = 0; v < places.size(); ++v)
              data(2 * dim + c, v) = of_cell[c];
        }
    AssertDimension(k, patches.size());
  }


  template <int dim>
  std::vector<std::string> VolumePatches<dim>::get_dataset_names() const
  {
    std::vector<std::string> names;
    for (const char *name : {"displacement", "velocity"})
      names.insert(names.end(), dim, name);
    names.insert(names.end(), {"body", "von_mises"});
    for (const auto &component : stress_components<dim>())
      names.push_back(component.name);
    for (const auto &component : strain_components<dim>())
      names.push_back(component.name);
    names.push_back("subdomain");
    if (with_indicators)
      names.push_back("error_indicator");
    return names;
  }


  template <int dim>
  std::vector<std::tuple<unsigned int,
                         unsigned int,
                         std::string,
                         DataComponentInterpretation::DataComponentInterpretation>>
  VolumePatches<dim>::get_nonscalar_data_ranges() const
  {
    const auto vector = DataComponentInterpretation::component_is_part_of_vector;
    return {{0, dim - 1, "displacement", vector}, {dim, 2 * dim - 1, "velocity", vector}};
  }


  template class VolumePatches<2>;
  template class VolumePatches<3>;
} // namespace signorini
