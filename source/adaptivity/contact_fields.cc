// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/contact_fields.h>
#include <signorini/adaptivity/residual_estimate.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    // Compression and tension below this part of the largest one are round-off.
    constexpr double round_off = 1e-9;

    template <int dim>
    Tensor<1, dim> node_value(const Vector &vector, const unsigned int node)
    {
      Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = vector.local_element(dim * node + c);
      return result;
    }

    template <int dim>
    void set_node_value(Vector &vector, const unsigned int node, const Tensor<1, dim> &value)
    {
      for (unsigned int c = 0; c < dim; ++c)
        vector.local_element(dim * node + c) = value[c];
    }

    template <int dim>
    std::vector<double> compression(const ContactSurface<dim> &surface, const Vector &contact_force)
    {
      std::vector<double> result;
      for (const ContactNode<dim> &node : surface.nodes())
        result.push_back(-(node.normal() * node_value<dim>(contact_force, node.node)));
      return result;
    }

    /** Vectors on the nodes of faces, summed by value(cell, fe_values of a face, entries of the nodes of the cell). */
    template <int dim, typename Selects, typename Integrate>
    Vector sum_over_faces(const Discretization<dim> &discretization, const Selects &selects, const Integrate &integrate)
    {
      Vector                               result = discretization.make_vector();
      FEFaceValues<dim>                    fe_values(discretization.mapping,
                                  discretization.fe,
                                  QGauss<dim - 1>(discretization.n_quadrature_points()),
                                  update_values | update_gradients | update_JxW_values | update_normal_vectors);
      std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
      dealii::Vector<double>               local(dofs.size());
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int face : cell->face_indices())
            if (cell->face(face)->at_boundary() && selects(cell, face))
              {
                fe_values.reinit(cell, face);
                local = 0.;
                integrate(cell, face, fe_values, local);
                cell->get_dof_indices(dofs);
                discretization.hanging_node_constraints.distribute_local_to_global(local, dofs, result);
              }
      result.compress(VectorOperation::add);
      return result;
    }

    /** Nodes of slave surfaces (first component > 0) around which contact is not closed everywhere, or where there is tension. */
    template <int dim>
    Vector nodes_at_open_faces(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const Supports<dim>       &supports,
                               const std::vector<bool>   &closed,
                               const Vector              &displacement,
                               const double               tension)
    {
      Vector open = discretization.make_vector();
      open        = 1.;
      for (const auto &entry : supports.nodes()) // without contact, it is held in the normal direction
        open.local_element(dim * entry.first) = 0.;
      for (std::size_t k = 0; k < closed.size(); ++k)
        open.local_element(dim * surface.nodes()[k].node) = closed[k] ? 0. : 1.;
      open = discretization.interpolate_hanging_nodes(open);

      const FEValuesExtractors::Vector     vector(0);
      const FEValuesExtractors::Scalar     first(0);
      std::vector<SymmetricTensor<2, dim>> strains;
      return sum_over_faces(
        discretization,
        [&](const auto &cell, const unsigned int face) { return surface.contains(cell, face); },
        [&](const auto &cell, const unsigned int face, const FEFaceValues<dim> &fe_values, auto &local) {
          bool is_open = false;
          for (const unsigned int v : cell->face(face)->vertex_indices())
            is_open = is_open || open(cell->face(face)->vertex_dof_index(v, 0)) > 0.;
          strains.resize(fe_values.n_quadrature_points);
          fe_values[vector].get_function_symmetric_gradients(displacement, strains);
          const Material &material = discretization.scene.bodies[cell->material_id()].material;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const Tensor<1, dim> n = fe_values.normal_vector(q);
              is_open                = is_open || n * (stress_of_strain<dim>(material, strains[q]) * n) > tension;
            }
          if (!is_open)
            return;
          for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
            for (const unsigned int q : fe_values.quadrature_point_indices())
              local(i) += fe_values[first].value(i, q) * fe_values.JxW(q);
        });
    }

    /** Areas of the nodes of master surfaces, in the first component. */
    template <int dim>
    Vector master_areas(const Discretization<dim> &discretization)
    {
      const FEValuesExtractors::Scalar first(0);
      return sum_over_faces(
        discretization,
        [&](const auto &cell, const unsigned int face) { return is_master_face(discretization.scene, cell, face); },
        [&](const auto &, const unsigned int, const FEFaceValues<dim> &fe_values, auto &local) {
          for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
            for (const unsigned int q : fe_values.quadrature_point_indices())
              local(i) += fe_values[first].value(i, q) * fe_values.JxW(q);
        });
    }
  } // namespace


  template <int dim>
  bool is_master_face(const Scene<dim>                                     &scene,
                      const typename DoFHandler<dim>::active_cell_iterator &cell,
                      const unsigned int                                    face)
  {
    return std::any_of(scene.pairs.begin(), scene.pairs.end(), [&](const PairDescription &pair) {
      return pair.of_two_bodies() && is_surface_face<dim>(cell, face, pair.master, pair.master_boundary_ids);
    });
  }


  template <int dim>
  std::vector<bool> closed_nodes(const ContactSurface<dim> &surface, const Vector &contact_force)
  {
    const std::vector<double> forces  = compression(surface, contact_force);
    double                    largest = 0.;
    for (const double force : forces)
      largest = std::max(largest, force);
    largest = Utilities::MPI::max(largest, contact_force.get_mpi_communicator());
    std::vector<bool> closed;
    for (const double force : forces)
      closed.push_back(force > round_off * largest);
    return closed;
  }


  template <int dim>
  ContactFields<dim> contact_fields(const Discretization<dim> &discretization,
                                    const ContactSurface<dim> &surface,
                                    const Supports<dim>       &supports,
                                    const ForceBalance        &balance,
                                    const Vector              &displacement)
  {
    ContactFields<dim> fields{discretization.make_vector(),
                              discretization.make_vector(),
                              discretization.make_vector(),
                              discretization.make_vector(),
                              discretization.make_vector()};
    const Vector       areas =
      discretization.scene.pairs.empty() ? discretization.make_vector() : master_areas(discretization);
    for (unsigned int node = 0; node < discretization.matrices.pattern.n_owned; ++node)
      if (areas.local_element(dim * node) > 0.)
        set_node_value<dim>(
          fields.traction, node, node_value<dim>(balance.contact_force, node) / areas.local_element(dim * node));

    const std::vector<double> forces  = compression(surface, balance.contact_force);
    const std::vector<bool>   closed  = closed_nodes(surface, balance.contact_force);
    double                    largest = 0.;
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        const ContactNode<dim> &node  = surface.nodes()[k];
        const Tensor<1, dim>    force = node_value<dim>(balance.contact_force, node.node);
        const double            s     = std::max(0., forces[k]) / node.weight;
        largest                       = std::max(largest, s);
        set_node_value<dim>(fields.normal, node.node, node.normal());
        set_node_value<dim>(fields.traction, node.node, (force + forces[k] * node.normal()) / node.weight);
        fields.pressure.local_element(dim * node.node) = s;
        fields.gap.local_element(dim * node.node)      = closed[k] ? 0. : std::max(0., balance.gap[k]);
      }
    largest = Utilities::MPI::max(largest, discretization.communicator());

    const Vector at_open_faces =
      nodes_at_open_faces(discretization, surface, supports, closed, displacement, round_off * largest);
    for (unsigned int node = 0; node < discretization.matrices.pattern.n_owned; ++node)
      if (at_open_faces.local_element(dim * node) > 0.)
        fields.open.local_element(dim * node) = 1.;
    for (Vector *field : {&fields.normal, &fields.traction, &fields.open, &fields.pressure, &fields.gap})
      *field = discretization.interpolate_hanging_nodes(*field);
    return fields;
  }


  template ContactFields<2> contact_fields(const Discretization<2> &,
                                           const ContactSurface<2> &,
                                           const Supports<2> &,
                                           const ForceBalance &,
                                           const Vector &);
  template ContactFields<3> contact_fields(const Discretization<3> &,
                                           const ContactSurface<3> &,
                                           const Supports<3> &,
                                           const ForceBalance &,
                                           const Vector &);
  template bool is_master_face(const Scene<2> &, const typename DoFHandler<2>::active_cell_iterator &, unsigned int);
  template bool is_master_face(const Scene<3> &, const typename DoFHandler<3>::active_cell_iterator &, unsigned int);
  template std::vector<bool> closed_nodes(const ContactSurface<2> &, const Vector &);
  template std::vector<bool> closed_nodes(const ContactSurface<3> &, const Vector &);
} // namespace signorini
