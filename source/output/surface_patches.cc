// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/output/surface_patches.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  SurfacePatches<dim>::SurfacePatches(const Discretization<dim> &discretization, const ContactSurface<dim> &surface)
    : discretization(discretization)
    , surface(surface)
  {
  }


  template <int dim>
  void SurfacePatches<dim>::build(const State &state, const Vector &displacement, const Vector &velocity)
  {
    const Vector contact = discretization.interpolate_hanging_nodes(contact_values(state));
    patches.clear();
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (surface.contains(cell, f))
          {
            patches.push_back(make_patch(cell, f, displacement, velocity, contact));
            patches.back().patch_index = patches.size() - 1;
          }
  }


  template <int dim>
  Vector SurfacePatches<dim>::contact_values(const State &state) const
  {
    const std::vector<double> gaps    = surface.distance(state.displacement);
    const double              largest = Utilities::MPI::max(
      gaps.empty() ? 0. : std::max(0., *std::max_element(gaps.begin(), gaps.end())), discretization.communicator());

    Vector values = discretization.make_vector();
    for (unsigned int node = 0; node < discretization.matrices.pattern.n_owned; ++node)
      values.local_element(dim * node + 1) = largest;
    for (unsigned int i = 0; i < surface.nodes().size(); ++i)
      {
        const ContactNode<dim> &contact_node = surface.nodes()[i];
        values.local_element(dim * contact_node.node) =
          std::max(0., -normal_force(contact_node, state.contact_force) / contact_node.weight);
        values.local_element(dim * contact_node.node + 1) = gaps[i];
      }
    return values;
  }


  template <int dim>
  typename SurfacePatches<dim>::Patch
  SurfacePatches<dim>::make_patch(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                  const unsigned int                                    face,
                                  const Vector                                         &displacement,
                                  const Vector                                         &velocity,
                                  const Vector                                         &contact) const
  {
    Patch patch;
    patch.n_subdivisions = 1;
    patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
    patch.data.reinit(2 * dim + 3, cell->face(face)->n_vertices());
    for (const unsigned int v : cell->face(face)->vertex_indices())
      {
        patch.vertices[v] = cell->face(face)->vertex(v);
        for (unsigned int c = 0; c < dim; ++c)
          {
            const auto dof         = cell->face(face)->vertex_dof_index(v, c);
            patch.data(c, v)       = displacement(dof);
            patch.data(dim + c, v) = velocity(dof);
          }
        const auto   dof           = cell->face(face)->vertex_dof_index(v, 0);
        const double pressure      = contact(dof);
        patch.data(2 * dim, v)     = pressure;
        patch.data(2 * dim + 1, v) = contact(dof + 1);
        patch.data(2 * dim + 2, v) = pressure > 0. ? 1. : 0.;
      }
    return patch;
  }


  template <int dim>
  std::vector<std::string> SurfacePatches<dim>::get_dataset_names() const
  {
    std::vector<std::string> names;
    for (const char *name : {"displacement", "velocity"})
      names.insert(names.end(), dim, name);
    for (const char *name : {"CPRESS", "COPEN", "CSTATUS"})
      names.push_back(name);
    return names;
  }


  template <int dim>
  std::vector<
    std::tuple<unsigned int, unsigned int, std::string, DataComponentInterpretation::DataComponentInterpretation>>
  SurfacePatches<dim>::get_nonscalar_data_ranges() const
  {
    const auto vector = DataComponentInterpretation::component_is_part_of_vector;
    return {{0, dim - 1, "displacement", vector}, {dim, 2 * dim - 1, "velocity", vector}};
  }


  template class SurfacePatches<2>;
  template class SurfacePatches<3>;
} // namespace signorini
