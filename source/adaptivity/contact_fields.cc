// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/contact_fields.h>
#include <signorini/base/contact_status.h>
#include <signorini/contact/own_forces.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
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
        result.push_back(-node.normal_force(contact_force));
      return result;
    }

    /** What a node presses on all that bounds it, the first contact node of which is k. */
    template <int dim>
    Tensor<1, dim> pressing_force(const ContactSurface<dim> &surface,
                                  const std::vector<double> &forces,
                                  const std::size_t          k)
    {
      Tensor<1, dim> result;
      for (std::size_t row = k; row < k + surface.nodes()[k].n_bounds; ++row)
        result += forces[row] * surface.nodes()[row].normal();
      return result;
    }

    /** Areas of the nodes of the selected outer faces, in the first component. Collective. */
    template <int dim, typename Selects>
    Vector areas_of_nodes(const StressVectors<dim> &stress, const Selects &selects)
    {
      const CellNeighbors<dim> &mesh             = stress.mesh;
      const auto               &vertex_functions = GaussTables<dim>::of_degree(1).vertex_functions;
      Vector                    result           = mesh.make_vector();
      for (std::size_t i = 0; i < mesh.outer_faces.size(); ++i)
        if (selects(i))
          {
            const OuterFace<dim> &outer = mesh.outer_faces[i];
            const FourNumbers     area  = stress.of_face(outer.cell, outer.face).area;
            for (unsigned int v = 0; v < vertex_functions.size(); ++v)
              {
                const unsigned int node =
                  mesh.cells[outer.cell].nodes[vertex_of_face<dim>(outer.face, v)];
                for (unsigned int q = 0; q < PointTable<dim>::n_points; ++q)
                  result.local_element(dim * node) += vertex_functions[v][q] * area[q];
              }
          }
      mesh.sum_over_processes(result);
      return result;
    }

    /** What slaves hand on to the nodes that they follow, over the areas of these. Collective. */
    template <int dim>
    Vector traction_of_masters(const StressVectors<dim>  &stress,
                               const SurfaceRoles<dim>   &roles,
                               const ContactSurface<dim> &surface,
                               const Vector              &contact_force,
                               const Vector              &own)
    {
      Vector handed_on = contact_force;
      if (surface.follows())
        handed_on -= own; // else no node of a master is a contact node
      const Vector areas =
        areas_of_nodes(stress, [&](const std::size_t i) { return roles[i].is_master; });
      Vector result = stress.mesh.make_vector();
      for (unsigned int node = 0; node < result.locally_owned_size() / dim; ++node)
        if (areas.local_element(dim * node) > 0.)
          set_node_value<dim>(
            result, node, node_value<dim>(handed_on, node) / areas.local_element(dim * node));
      if (!surface.follows())
        for (const ContactNode<dim> &node : surface.nodes())
          set_node_value<dim>(result, node.node, Tensor<1, dim>());
      return result;
    }


    /**
     * Nodes of slave surfaces (first component > 0) around which contact is not closed everywhere,
     * or where there is tension.
     */
    template <int dim>
    Vector nodes_at_open_faces(const StressVectors<dim>       &stress,
                               const SurfaceRoles<dim>        &roles,
                               const ContactSurface<dim>      &surface,
                               const DirichletConditions<dim> &dirichlet,
                               const std::vector<bool>        &closed,
                               const double                    tension)
    {
      const CellNeighbors<dim> &mesh = stress.mesh;
      Vector                    open = mesh.make_vector();
      open                           = 1.;
      for (const auto &entry :
           dirichlet.nodes()) // without contact, it is held in the normal direction
        open.local_element(dim * entry.first) = 0.;
      for (std::size_t k = 0; k < closed.size(); ++k)
        open.local_element(dim * surface.nodes()[k].node) = closed[k] ? 0. : 1.;
      open = mesh.interpolate_hanging_nodes(open);
      return areas_of_nodes(stress, [&](const std::size_t i) {
        const OuterFace<dim> &outer   = mesh.outer_faces[i];
        const auto           &there   = stress.of_face(outer.cell, outer.face);
        bool                  is_open = false;
        for (unsigned int v = 0; v < GaussTables<dim>::n_face_points; ++v)
          is_open = is_open || there.tension[v] > tension
                    || open.local_element(
                         dim * mesh.cells[outer.cell].nodes[vertex_of_face<dim>(outer.face, v)])
                         > 0.;
        return is_open && roles[i].is_slave;
      });
    }
  } // namespace


  template <int dim>
  std::vector<bool> closed_nodes(const ContactSurface<dim> &surface, const Vector &contact_force)
  {
    const std::vector<double> forces  = compression(surface, own_forces(surface, contact_force));
    double                    largest = 0.;
    for (const double force : forces)
      largest = std::max(largest, force);
    largest = Utilities::MPI::max(largest, contact_force.get_mpi_communicator());
    std::vector<bool> closed;
    for (const double force : forces)
      closed.push_back(force > negligible_force * largest);
    // What closes one of several obstacles at a node closes the node.
    const auto &nodes = surface.nodes();
    for (std::size_t k = nodes.size(); k-- > 1;)
      if (nodes[k].row > 0 && closed[k])
        closed[k - 1] = true;
    for (std::size_t k = 1; k < nodes.size(); ++k)
      if (nodes[k].row > 0)
        closed[k] = closed[k - 1];
    return closed;
  }


  template <int dim>
  ContactFields<dim> contact_fields(const StressVectors<dim>       &stress,
                                    const SurfaceRoles<dim>        &roles,
                                    const ContactSurface<dim>      &surface,
                                    const DirichletConditions<dim> &dirichlet,
                                    const ForceBalance             &balance)
  {
    const CellNeighbors<dim> &mesh = stress.mesh;
    ContactFields<dim>        fields{mesh.make_vector(),
                              mesh.make_vector(),
                              mesh.make_vector(),
                              mesh.make_vector(),
                              mesh.make_vector()};
    const unsigned int        n_owned = fields.normal.locally_owned_size() / dim;
    const Vector              own     = own_forces(surface, balance.contact_force);
    fields.traction = traction_of_masters(stress, roles, surface, balance.contact_force, own);
    const std::vector<double> forces  = compression(surface, own);
    const std::vector<bool>   closed  = closed_nodes(surface, balance.contact_force);
    double                    largest = 0.;
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        const ContactNode<dim> &node = surface.nodes()[k];
        if (node.row > 0)
          continue;
        const Tensor<1, dim> force = node_value<dim>(own, node.node);
        const Tensor<1, dim> press = pressing_force(surface, forces, k);
        // Several obstacles at a node are one whose normal is that of what they press.
        const Tensor<1, dim> normal =
          node.is_shared() && press.norm() > 0. ? press / press.norm() : node.normal();
        const double s = std::max(0., press * normal) / node.weight;
        largest        = std::max(largest, s);
        set_node_value<dim>(fields.normal, node.node, normal);
        set_node_value<dim>(fields.traction,
                            node.node,
                            node_value<dim>(fields.traction, node.node)
                              + (force + press) / node.weight);
        fields.pressure.local_element(dim * node.node) = s;
        fields.gap.local_element(dim * node.node) = closed[k] ? 0. : std::max(0., balance.gap[k]);
      }
    largest = Utilities::MPI::max(largest, mesh.discretization.communicator());

    const Vector at_open_faces =
      nodes_at_open_faces(stress, roles, surface, dirichlet, closed, negligible_force * largest);
    for (unsigned int node = 0; node < n_owned; ++node)
      if (at_open_faces.local_element(dim * node) > 0.)
        fields.open.local_element(dim * node) = 1.;
    for (Vector *field :
         {&fields.normal, &fields.traction, &fields.open, &fields.pressure, &fields.gap})
      *field = mesh.interpolate_hanging_nodes(*field);
    return fields;
  }


  template ContactFields<2>  contact_fields(const StressVectors<2> &,
                                            const SurfaceRoles<2> &,
                                            const ContactSurface<2> &,
                                            const DirichletConditions<2> &,
                                            const ForceBalance &);
  template ContactFields<3>  contact_fields(const StressVectors<3> &,
                                            const SurfaceRoles<3> &,
                                            const ContactSurface<3> &,
                                            const DirichletConditions<3> &,
                                            const ForceBalance &);
  template std::vector<bool> closed_nodes(const ContactSurface<2> &, const Vector &);
  template std::vector<bool> closed_nodes(const ContactSurface<3> &, const Vector &);
} // namespace signorini
