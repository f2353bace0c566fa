// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/contact_coordinates.h>

#include <map>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  ContactCoordinates<dim>::ContactCoordinates(const Discretization<dim> &discretization,
                                              const ContactSurface<dim> &surface,
                                              const Supports<dim>       &supports)
    : supports(supports)
    , owned_contact_nodes(surface.nodes())
    , node_coupling(surface.coupling())
    , mask_values(discretization.make_vector())
  {
    Frame identity{};
    for (unsigned int c = 0; c < dim; ++c)
      identity[dim * c + c] = 1.;
    std::map<unsigned int, Frame> frames;
    for (const ContactNode<dim> &node : owned_contact_nodes)
      {
        normals.push_back(dim * node.node);
        frames[node.node] = node.frame;
      }
    for (const auto &[node, components] : supports.nodes())
      {
        const Frame &frame = frames.emplace(node, identity).first->second;
        for (unsigned int c = 0; c < dim; ++c)
          if (components[c] != Supports<dim>::none)
            for (unsigned int row = 0; row < dim; ++row)
              if (std::abs(frame[dim * row + c]) == 1.)
                {
                  supported.push_back(dim * node + row);
                  support_sources.emplace_back(components[c], discretization.node_positions[node], c);
                }
      }

    // Ghosts learn their frames row by row, and what they are from a flag: 1 supported, 2 contact.
    Vector              flags = discretization.make_vector();
    std::vector<Vector> rows(dim, flags);
    for (const auto &[node, frame] : frames)
      {
        flags.local_element(dim * node) = 1.;
        for (unsigned int row = 0; row < dim; ++row)
          for (unsigned int c = 0; c < dim; ++c)
            rows[row].local_element(dim * node + c) = frame[dim * row + c];
      }
    for (const unsigned int entry : normals)
      flags.local_element(entry) = 2.;
    flags.update_ghost_values();
    for (Vector &row : rows)
      row.update_ghost_values();
    for (unsigned int node = 0; node < discretization.matrices.pattern.n_local; ++node)
      if (const double flag = flags.local_element(dim * node); flag > 0.)
        {
          Frame frame;
          for (unsigned int row = 0; row < dim; ++row)
            for (unsigned int c = 0; c < dim; ++c)
              frame[dim * row + c] = rows[row].local_element(dim * node + c);
          special.push_back(node);
          special_frames.push_back(frame);
          if (flag == 2.)
            contact.push_back(node);
        }
  }


  template <int dim>
  void ContactCoordinates<dim>::displacement_to_cartesian(Vector &vector) const
  {
    add_partner_motion(vector, 1.);
    rotate_from_frames(vector);
  }


  template <int dim>
  void ContactCoordinates<dim>::displacement_to_contact(Vector &vector) const
  {
    rotate_to_frames(vector);
    add_partner_motion(vector, -1.);
  }


  template <int dim>
  void ContactCoordinates<dim>::force_to_contact(Vector &vector) const
  {
    rotate_to_frames(vector);
    add_to_partners(vector, 1.);
  }


  template <int dim>
  void ContactCoordinates<dim>::force_to_cartesian(Vector &vector) const
  {
    add_to_partners(vector, -1.);
    rotate_from_frames(vector);
  }


  template <int dim>
  void ContactCoordinates<dim>::add_partner_motion(Vector &vector, const double factor) const
  {
    if (!node_coupling.any())
      return;
    const std::vector<double> motion = node_coupling.partner_motion(vector);
    for (std::size_t k = 0; k < motion.size(); ++k)
      vector.local_element(normals[k]) += factor * motion[k];
  }


  template <int dim>
  void ContactCoordinates<dim>::add_to_partners(Vector &vector, const double factor) const
  {
    if (!node_coupling.any())
      return;
    std::vector<double> forces;
    for (const unsigned int entry : normals)
      forces.push_back(factor * vector.local_element(entry));
    node_coupling.add_to_partners(forces, vector);
  }


  template <int dim>
  void ContactCoordinates<dim>::rotate_to_frames(Vector &vector) const
  {
    for (const ContactNode<dim> &node : owned_contact_nodes)
      {
        std::array<double, dim> w{};
        double                 *u = vector.begin() + dim * node.node;
        for (unsigned int row = 0; row < dim; ++row)
          for (unsigned int c = 0; c < dim; ++c)
            w[row] += node.frame[dim * row + c] * u[c];
        for (unsigned int c = 0; c < dim; ++c)
          u[c] = w[c];
      }
  }


  template <int dim>
  void ContactCoordinates<dim>::rotate_from_frames(Vector &vector) const
  {
    for (const ContactNode<dim> &node : owned_contact_nodes)
      {
        std::array<double, dim> u{};
        double                 *w = vector.begin() + dim * node.node;
        for (unsigned int row = 0; row < dim; ++row)
          for (unsigned int c = 0; c < dim; ++c)
            u[c] += node.frame[dim * row + c] * w[row];
        for (unsigned int c = 0; c < dim; ++c)
          w[c] = u[c];
      }
  }


  template <int dim>
  std::vector<double> ContactCoordinates<dim>::supported_values(const double time) const
  {
    std::vector<double> values;
    values.reserve(supported.size());
    for (const auto &[condition, point, component] : support_sources)
      values.push_back(supports.value(condition, point, component, time));
    return values;
  }


  template <int dim>
  HeldNodes<dim> ContactCoordinates<dim>::held_nodes(const Mask &mask) const
  {
    mask_values.zero_out_ghost_values();
    for (unsigned int i = 0; i < mask.size(); ++i)
      mask_values.local_element(i) = mask[i];
    // A relative entry is not a direction of its node alone.
    for (std::size_t k = 0; k < normals.size(); ++k)
      if (!owned_contact_nodes[k].partners.empty())
        mask_values.local_element(normals[k]) = 0.;
    mask_values.update_ghost_values();
    HeldNodes<dim> result;
    for (unsigned int k = 0; k < special.size(); ++k)
      {
        HeldNode<dim> node{special[k], special_frames[k], {}};
        bool          any = false;
        for (unsigned int c = 0; c < dim; ++c)
          {
            node.held[c] = mask_values.local_element(dim * special[k] + c) > 0.;
            any          = any || node.held[c];
          }
        if (any)
          result.push_back(node);
      }
    return result;
  }


  template class ContactCoordinates<2>;
  template class ContactCoordinates<3>;
} // namespace signorini
