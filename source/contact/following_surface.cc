// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The part of a contact surface whose bodies are followed.

#include <signorini/base/complaints.h>
#include <signorini/base/user_error.h>
#include <signorini/contact/contact_surface.h>
#include <signorini/contact/followed_pairs.h>
#include <signorini/contact/free_directions.h>
#include <signorini/surfaces/contact_frame.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** What facets of curved surfaces that fit together may overlap, in the size of a face. */
    constexpr double overlap_of_facets = 0.05;


    template <int dim>
    Tensor<1, dim> unit_vector(const unsigned int direction)
    {
      Tensor<1, dim> result;
      result[direction] = 1.;
      return result;
    }


    template <int dim>
    std::optional<unsigned int>
    first_free_direction(const typename DirichletConditions<dim>::Components &conditions)
    {
      for (unsigned int c = 0; c < dim; ++c)
        if (conditions[c] == DirichletConditions<dim>::none)
          return c;
      return {};
    }
  } // namespace


  template <int dim>
  ContactSurface<dim>::ContactSurface(ContactSurface &&) noexcept = default;


  template <int dim>
  ContactSurface<dim>::~ContactSurface() = default;


  template <int dim>
  double ContactSurface<dim>::depth(const unsigned int pair) const
  {
    return bodies ? bodies->depth(pair) : 0.;
  }


  template <int dim>
  double ContactSurface<dim>::clear_distance(const unsigned int pair) const
  {
    return bodies->clear_distance(pair);
  }


  template <int dim>
  std::vector<ContactNode<dim>> ContactSurface<dim>::near_nodes(const Vector &displacement,
                                                                const double  reach) const
  {
    std::vector<ContactNode<dim>> result;
    const std::vector<double>     gaps = distance(displacement);
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      if (!follows() || !descriptions[contact_nodes[k].pair].of_two_bodies())
        {
          result.push_back(contact_nodes[k]);
          result.back().gap = gaps[k];
        }
    if (follows())
      for (const auto &[pair, geometry] : bodies->pairs())
        for (const ContactNode<dim> &node : geometry->at(displacement, reach))
          {
            result.push_back(node);
            result.back().gap *= node.distance_per_gap();
          }
    return result;
  }


  template <int dim>
  std::vector<ContactNode<dim>> ContactSurface<dim>::near_nodes_at(const double  time,
                                                                   const Vector &displacement,
                                                                   const double  reach) const
  {
    std::map<unsigned int, MovedObstacle<dim>> then; // by pair
    if (follows())
      for (unsigned int pair = 0; pair < descriptions.size(); ++pair)
        if (!descriptions[pair].of_two_bodies() && !obstacle_contact.obstacle(pair).is_at_rest())
          then.emplace(pair, obstacle_contact.obstacle(pair)).first->second.move(time, time);
    std::vector<ContactNode<dim>> result = near_nodes(displacement, reach);
    for (ContactNode<dim> &node : result)
      if (const auto obstacle = then.find(node.pair); obstacle != then.end())
        node.gap = distance_to(obstacle->second, node, displacement);
    return result;
  }


  template <int dim>
  void ContactSurface<dim>::add_slave_nodes(const DirichletConditions<dim> &dirichlet)
  {
    std::map<unsigned int, ContactNode<dim>> last; // of the rows of each node
    for (const ContactNode<dim> &node : contact_nodes)
      last[node.node] = node;
    for (const auto &[pair, geometry] : bodies->pairs())
      for (const auto &[node, area] : geometry->slave_nodes())
        {
          const auto known      = last.find(node);
          const auto conditions = dirichlet.nodes().find(node);
          if (known != last.end()
              && (known->second.row + 1 == dim || conditions != dirichlet.nodes().end()))
            continue; // it meets one of them at a time, or three
          ContactNode<dim> further{node,
                                   pair,
                                   discretization.node_positions()[node],
                                   std::numeric_limits<double>::infinity(),
                                   area,
                                   {},
                                   {}};
          further.row   = known == last.end() ? 0 : known->second.row + 1;
          further.frame = contact_frame(unit_vector<dim>(0));
          if (known != last.end())
            further.frame = known->second.frame;
          else if (conditions != dirichlet.nodes().end())
            {
              const auto free = first_free_direction<dim>(conditions->second);
              if (!free)
                {
                  ++n_left_to_dirichlet;
                  continue;
                }
              meet_in_free_directions<dim>(conditions->second, unit_vector<dim>(*free), further);
            }
          last[node] = further;
          contact_nodes.push_back(further);
        }
  }


  template <int dim>
  void ContactSurface<dim>::complete_geometry()
  {
    if (!bodies->any())
      return;
    *node_coupling =
      NodeCoupling<dim>(contact_nodes, discretization.matrices().pattern.partitioner, true);
    if (node_coupling->n_levels() > NodeCoupling<dim>::most_levels)
      throw StepError(
        "Contact/Pairs: nodes of several bodies follow each other in a ring. Exchange "
        "slave and master in one of the pairs.");
  }


  template <int dim>
  void ContactSurface<dim>::check_that_bodies_are_apart(const Vector &displacement) const
  {
    std::vector<Complaint> complaints;
    for (const auto &[pair, geometry] : bodies->pairs())
      {
        const Mesh<dim> &mesh  = discretization.mesh();
        const double     depth = 0.25
                             * std::min(mesh.body_size(descriptions[pair].slave),
                                        mesh.body_size(descriptions[pair].master));
        const std::vector<ContactNode<dim>> nodes   = geometry->at(displacement, depth);
        const auto                          is_deep = [](const ContactNode<dim> &node) {
          return -node.clearance > overlap_of_facets * std::pow(node.weight, 1. / (dim - 1));
        };
        const unsigned int n_deep = std::count_if(nodes.begin(), nodes.end(), is_deep);
        if (Utilities::MPI::max(n_deep, discretization.communicator()) == 0)
          continue;
        // What a thin body sees behind itself may be what its other side has in front of it.
        const Vector reciprocal_thickness = geometry->reciprocal_thickness();
        for (const ContactNode<dim> &node : nodes)
          if (is_deep(node)
              && -node.clearance * reciprocal_thickness.local_element(dim * node.node) < 1.)
            {
              std::ostringstream message;
              message << "Contact/Pairs = " << descriptions[pair].name
                      << ": the bodies overlap at the start, by " << -node.clearance << " at ("
                      << node.position
                      << "). Move one of them, or change the initial displacement.";
              if (complaints.empty() || -node.clearance > complaints[0].first)
                complaints = {{-node.clearance, message.str()}};
            }
      }
    throw_worst(complaints, discretization.communicator());
  }


  template ContactSurface<2>::ContactSurface(ContactSurface &&) noexcept;
  template ContactSurface<2>::~ContactSurface();
  template double                      ContactSurface<2>::depth(unsigned int) const;
  template double                      ContactSurface<2>::clear_distance(unsigned int) const;
  template std::vector<ContactNode<2>> ContactSurface<2>::near_nodes(const Vector &, double) const;
  template std::vector<ContactNode<2>>
                ContactSurface<2>::near_nodes_at(double, const Vector &, double) const;
  template void ContactSurface<2>::add_slave_nodes(const DirichletConditions<2> &);
  template void ContactSurface<2>::complete_geometry();
  template void ContactSurface<2>::check_that_bodies_are_apart(const Vector &) const;
  template ContactSurface<3>::ContactSurface(ContactSurface &&) noexcept;
  template ContactSurface<3>::~ContactSurface();
  template double                      ContactSurface<3>::depth(unsigned int) const;
  template double                      ContactSurface<3>::clear_distance(unsigned int) const;
  template std::vector<ContactNode<3>> ContactSurface<3>::near_nodes(const Vector &, double) const;
  template std::vector<ContactNode<3>>
                ContactSurface<3>::near_nodes_at(double, const Vector &, double) const;
  template void ContactSurface<3>::add_slave_nodes(const DirichletConditions<3> &);
  template void ContactSurface<3>::complete_geometry();
  template void ContactSurface<3>::check_that_bodies_are_apart(const Vector &) const;
} // namespace signorini
