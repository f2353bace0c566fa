// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/friction_reading.h>
#include <signorini/model/contact_description.h>
#include <signorini/output/surface_patches.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    const std::array<const char *, 3> friction_vectors = {{"CSHEAR", "CSLIP", "CSLIP_INCREMENT"}};

    /** A hanging node has the mean of the status of its neighbours: it sticks if all of them do. */
    double shown_status(const double pressure, const double status)
    {
      const double mixed = contact_status::stick - 1e-6;
      return pressure <= 0.   ? contact_status::open
             : status < mixed ? contact_status::slip
                              : contact_status::stick;
    }

    /** What the patches show, with ghosts and hanging nodes. */
    struct ShownFields
    {
      const Vector       &displacement, &velocity;
      Vector              contact;  ///< pressure and gap in the first two entries of each node
      Vector              status;   ///< in the first entry of each node
      std::vector<Vector> friction; ///< stress, slip, increment of the slip
    };


    /** Pressure and gap. */
    template <int dim>
    Vector contact_values(const Discretization<dim> &discretization,
                          const ContactSurface<dim> &surface,
                          const State               &state)
    {
      const std::vector<double> gaps    = surface.distance(state.displacement);
      double                    largest = 0.;
      for (const double gap : gaps) // infinite where nothing is opposite
        largest = std::isfinite(gap) ? std::max(largest, gap) : largest;
      largest = Utilities::MPI::max(largest, discretization.communicator());

      const Vector own    = own_forces(surface, state.contact_force);
      Vector       values = discretization.make_vector();
      for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
        values.local_element(dim * node + 1) = largest;
      for (unsigned int i = 0; i < surface.nodes().size(); ++i)
        {
          const ContactNode<dim> &contact_node = surface.nodes()[i];
          double                 &pressure     = values.local_element(dim * contact_node.node);
          double                 &gap          = values.local_element(dim * contact_node.node + 1);
          pressure          = std::max(pressure, // of a node in a corner that of the harder side
                              -contact_node.normal_force(own) / contact_node.weight);
          const double seen = std::min(gaps[i], largest);
          gap               = contact_node.row == 0 ? seen : std::min(gap, seen);
        }
      return values;
    }


    /** Status, and the vectors of friction. */
    template <int dim>
    void add_friction(const Discretization<dim> &discretization,
                      const ContactSurface<dim> &surface,
                      const State               &state,
                      ShownFields               &fields)
    {
      Vector              status = discretization.make_vector();
      std::vector<Vector> vectors(friction_vectors.size(), status);
      const FrictionState of_nodes = own_friction(surface, state.friction);
      for (unsigned int k = 0; k < surface.nodes().size(); ++k)
        {
          const ContactNode<dim> &node = surface.nodes()[k];
          if (node.row > 0)
            continue;
          const FrictionReading<dim>          friction = friction_at(surface, of_nodes, k);
          const std::array<Tensor<1, dim>, 3> shown    = {
               {friction.force / node.weight, friction.accumulated_slip, friction.slip}};
          status.local_element(dim * node.node) = friction.status;
          for (unsigned int i = 0; i < shown.size(); ++i)
            for (unsigned int c = 0; c < dim; ++c)
              vectors[i].local_element(dim * node.node + c) = shown[i][c];
        }
      fields.status = discretization.interpolate_hanging_nodes(status);
      for (const Vector &vector : vectors)
        fields.friction.push_back(discretization.interpolate_hanging_nodes(vector));
    }


    template <int dim>
    DataOutBase::Patch<dim - 1, dim>
    make_patch(const typename DoFHandler<dim>::active_cell_iterator &cell,
               const unsigned int                                    face,
               const ShownFields                                    &fields)
    {
      DataOutBase::Patch<dim - 1, dim> patch;
      patch.n_subdivisions = 1;
      patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
      patch.data.reinit((2 + fields.friction.size()) * dim + 3, cell->face(face)->n_vertices());
      for (const unsigned int v : cell->face(face)->vertex_indices())
        {
          patch.vertices[v] = cell->face(face)->vertex(v);
          for (unsigned int c = 0; c < dim; ++c)
            {
              const auto dof         = cell->face(face)->vertex_dof_index(v, c);
              patch.data(c, v)       = fields.displacement(dof);
              patch.data(dim + c, v) = fields.velocity(dof);
              for (unsigned int i = 0; i < fields.friction.size(); ++i)
                patch.data((2 + i) * dim + 3 + c, v) = fields.friction[i](dof);
            }
          const auto   dof           = cell->face(face)->vertex_dof_index(v, 0);
          const double pressure      = fields.contact(dof);
          patch.data(2 * dim, v)     = pressure;
          patch.data(2 * dim + 1, v) = fields.contact(dof + 1);
          patch.data(2 * dim + 2, v) =
            shown_status(pressure, !fields.friction.empty() ? fields.status(dof) : 0.);
        }
      return patch;
    }
  } // namespace


  template <int dim>
  void SurfacePatches<dim>::build(const Discretization<dim> &discretization,
                                  const ContactSurface<dim> &surface,
                                  const State               &state,
                                  const Vector              &displacement,
                                  const Vector              &velocity)
  {
    with_friction = has_friction(surface.pairs());
    ShownFields fields{
      displacement,
      velocity,
      discretization.interpolate_hanging_nodes(contact_values(discretization, surface, state)),
      {},
      {}};
    if (with_friction)
      add_friction(discretization, surface, state, fields);
    patches.clear();
    for (const auto &cell : discretization.cells())
      for (const unsigned int f : cell->face_indices())
        if (surface.contains(cell, f))
          {
            patches.push_back(make_patch<dim>(cell, f, fields));
            patches.back().patch_index = patches.size() - 1;
          }
  }


  template <int dim>
  std::vector<std::string> SurfacePatches<dim>::get_dataset_names() const
  {
    std::vector<std::string> names;
    for (const char *name : {"displacement", "velocity"})
      names.insert(names.end(), dim, name);
    for (const char *name : {"CPRESS", "COPEN", "CSTATUS"})
      names.push_back(name);
    if (with_friction)
      for (const char *name : friction_vectors)
        names.insert(names.end(), dim, name);
    return names;
  }


  template <int dim>
  std::vector<std::tuple<unsigned int,
                         unsigned int,
                         std::string,
                         DataComponentInterpretation::DataComponentInterpretation>>
  SurfacePatches<dim>::get_nonscalar_data_ranges() const
  {
    const auto vector = DataComponentInterpretation::component_is_part_of_vector;
    std::vector<std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           DataComponentInterpretation::DataComponentInterpretation>>
      ranges = {{0, dim - 1, "displacement", vector}, {dim, 2 * dim - 1, "velocity", vector}};
    if (with_friction)
      for (unsigned int i = 0; i < friction_vectors.size(); ++i)
        ranges.emplace_back((2 + i) * dim + 3, (3 + i) * dim + 2, friction_vectors[i], vector);
    return ranges;
  }


  template class SurfacePatches<2>;
  template class SurfacePatches<3>;
} // namespace signorini
