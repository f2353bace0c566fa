// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/base/contact_status.h>
#include <signorini/base/user_error.h>
#include <signorini/contact/contact_surface.h>
#include <signorini/contact/followed_pairs.h>
#include <signorini/contact/mortar_coupling.h>
#include <signorini/contact/nodal_friction.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    // What facets of curved surfaces that fit together may overlap, relative to the size of a face.
    constexpr double facet_overlap = 0.05;
  } // namespace


  template <int dim>
  ContactSurface<dim>::ContactSurface(const Discretization<dim>             &discretization,
                                      const DirichletConditions<dim>        &dirichlet,
                                      const std::vector<NamedObstacle<dim>> &obstacles,
                                      const std::vector<PairDescription>    &pairs,
                                      const ContactMotion                    motion,
                                      const std::string                     &how_to_follow)
    : discretization(discretization)
    , descriptions(pairs)
    , motion(motion)
    , how_to_follow(how_to_follow)
    , obstacle_contact(discretization, dirichlet, obstacles, pairs, motion)
    , contact_nodes(obstacle_contact.nodes())
    , n_left_to_dirichlet(obstacle_contact.n_left_to_dirichlet_conditions())
  {
    if (obstacle_contact.n_oblique_nodes() > 0)
      assumptions.push_back("at " + std::to_string(obstacle_contact.n_oblique_nodes())
                            + " nodes an obstacle is oblique to prescribed directions; they meet "
                              "it in the free ones, and what holds them takes the rest");
    if (follows())
      {
        bodies = std::make_unique<FollowedPairs<dim>>(discretization, dirichlet, descriptions);
        add_slave_nodes(dirichlet);
      }
    else
      for (unsigned int p = 0; p < pairs.size(); ++p)
        if (pairs[p].of_two_bodies())
          add_pair_of_bodies(p, dirichlet);
    std::stable_sort(
      contact_nodes.begin(),
      contact_nodes.end(),
      [](const ContactNode<dim> &a, const ContactNode<dim> &b) { return a.node < b.node; });
    assign_friction(discretization, dirichlet, pairs, contact_nodes);
    node_coupling = std::make_unique<NodeCoupling<dim>>(
      contact_nodes, discretization.matrices().pattern.partitioner, bodies && bodies->any());
    if (!follows())
      check_that_pairs_are_disjoint();
    for (const ContactNode<dim> &node : contact_nodes)
      n_global += node.row == 0;
    n_global = Utilities::MPI::sum(n_global, discretization.communicator());
  }


  template <int dim>
  void ContactSurface<dim>::add_pair_of_bodies(const unsigned int              pair,
                                               const DirichletConditions<dim> &dirichlet)
  {
    const PairDescription    &description = descriptions[pair];
    const std::string         head        = "Contact/Pairs = " + description.name + ": ";
    const MortarCoupling<dim> mortar(discretization, dirichlet, descriptions, pair);
    if (!mortar.faces_look_at_each_other())
      throw UserError(head
                      + "no face of the slave looks at a face of the master along its normal. Who "
                        "meets whom is decided once, in the initial configuration: check the "
                        "boundary ids and the positions of the bodies, and let bodies that fly "
                        "towards each other start when they are near. Or let contact follow the "
                        "motion: "
                      + how_to_follow + ".");
    if (mortar.n_nodes() == 0 && mortar.n_left_to_dirichlet_conditions() == 0)
      throw UserError(
        head
        + "the master covers so little of the faces of the slave that no node of the slave can see "
          "it. Refine the slave, or exchange slave and master.");
    if (mortar.largest_turn() > 0.)
      {
        std::ostringstream note;
        note << std::setprecision(3) << description.name
             << ": normals of contact have a part in prescribed directions and are turned by up to "
             << mortar.largest_turn()
             << " degrees. Right at a plane of symmetry, otherwise forces along the prescribed "
                "directions are missing";
        assumptions.push_back(note.str());
      }
    auto nodes = mortar.nodes();
    settle_gaps(pair, nodes);
    contact_nodes.insert(contact_nodes.end(), nodes.begin(), nodes.end());
    n_left_to_dirichlet += mortar.n_left_to_dirichlet_conditions();

    const double covered = mortar.covered_area() / mortar.slave_area();
    if (!description.slave_boundary_ids.empty() && covered < 0.999)
      {
        std::ostringstream note;
        note << std::setprecision(3) << description.name << ": the master is opposite to "
             << 100. * covered << " % of the slave surface; the rest of it is taken to be free";
        assumptions.push_back(note.str());
      }
  }


  template <int dim>
  void ContactSurface<dim>::settle_gaps(const unsigned int             pair,
                                        std::vector<ContactNode<dim>> &nodes)
  {
    const double round_off = gap_round_off(discretization.mesh().body_size());
    double       deepest   = 0.;
    for (ContactNode<dim> &node : nodes)
      {
        const double face_size = std::pow(node.weight, 1. / (dim - 1));
        const double depth     = -node.clearance;
        if (std::abs(node.gap) < round_off)
          node.gap = 0.;
        if (depth < round_off) // apart: dual functions are partly negative, and so may be their
                               // mean of a curved gap
          node.gap = node.gap < 0. ? std::max(0., node.clearance) * node.transmission : node.gap;
        else if (depth < facet_overlap * face_size)
          {
            deepest  = std::max(deepest, depth);
            node.gap = std::max(node.gap, 0.);
          }
        else
          node.gap = std::min(node.gap, -depth * node.transmission);
      }
    deepest = Utilities::MPI::max(deepest, discretization.communicator());
    if (deepest > 0.)
      {
        std::ostringstream note;
        note << std::setprecision(3) << descriptions[pair].name
             << ": the surfaces overlap by up to " << deepest
             << ", a small part of a face, as facets of curved surfaces may; taken to touch "
                "without stress";
        assumptions.push_back(note.str());
      }
  }


  template <int dim>
  void ContactSurface<dim>::check_that_pairs_are_disjoint() const
  {
    std::vector<Complaint> complaints;
    const auto             complain = [&](const ContactNode<dim> &node, const std::string &other) {
      std::ostringstream message;
      message
        << "Contact/Pairs: `" << descriptions[node.pair].name << "` and " << other
        << " share the node at (" << node.position
        << "). A node can have one partner only, and neighbouring faces of a body share the "
        << "nodes of their edge. Make the other body the slave if its surface ends elsewhere. "
        << "Two blocks that stand side by side need surfaces without common nodes: in a mesh "
        << "file (`Shape = file`), give the faces next to the edge a boundary id that no pair "
        << "names. Where contact follows the motion nodes may have several partners: "
        << how_to_follow << ".";
      complaints.emplace_back(0., message.str());
    };
    for (std::size_t k = 1; k < contact_nodes.size() && complaints.empty(); ++k)
      if (contact_nodes[k].node == contact_nodes[k - 1].node && contact_nodes[k].row == 0)
        complain(contact_nodes[k], "`" + descriptions[contact_nodes[k - 1].pair].name + "`");
    const std::vector<unsigned int> partners = node_coupling->owned_partners();
    for (const ContactNode<dim> &node : contact_nodes)
      if (complaints.empty() && std::binary_search(partners.begin(), partners.end(), node.node))
        complain(node,
                 "a pair with `"
                   + discretization.mesh().bodies()[descriptions[node.pair].slave].name
                   + "` as master");
    throw_worst(complaints, discretization.communicator());
  }


  template <int dim>
  bool ContactSurface<dim>::contains(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                     const unsigned int face) const
  {
    return std::any_of(descriptions.begin(), descriptions.end(), [&](const PairDescription &pair) {
      return is_surface_face<dim>(cell, face, pair.slave, pair.slave_boundary_ids);
    });
  }


  template <int dim>
  std::vector<double> ContactSurface<dim>::relative_normal(const Vector &motion) const
  {
    AssertDimension(motion.locally_owned_size(), dim * discretization.matrices().pattern.n_owned);
    const auto          opposite = node_coupling->partner_displacement(motion);
    std::vector<double> result;
    result.reserve(contact_nodes.size());
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      {
        const Tensor<1, dim> normal = contact_nodes[k].normal();
        double               own    = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          own += normal[c] * motion.local_element(dim * contact_nodes[k].node + c);
        result.push_back(own - normal * opposite[k]);
      }
    return result;
  }


  template <int dim>
  std::vector<Tensor<1, dim>> ContactSurface<dim>::relative_tangential(const Vector &motion) const
  {
    AssertDimension(motion.locally_owned_size(), dim * discretization.matrices().pattern.n_owned);
    std::vector<Tensor<1, dim>> result = node_coupling->partner_displacement(motion);
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      {
        const Tensor<1, dim> normal = contact_nodes[k].normal();
        for (unsigned int c = 0; c < dim; ++c)
          result[k][c] = motion.local_element(dim * contact_nodes[k].node + c) - result[k][c];
        result[k] -= (result[k] * normal) * normal;
      }
    return result;
  }


  template <int dim>
  std::vector<double> ContactSurface<dim>::normal_gap(const Vector &displacement) const
  {
    std::vector<double> gap = relative_normal(displacement);
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      {
        gap[k]         = contact_nodes[k].gap - gap[k];
        const auto end = obstacle_contact.at_an_end(contact_nodes[k], displacement);
        if (end && !end->is_carried(obstacle_contact.end_tolerance()))
          gap[k] = std::numeric_limits<double>::infinity();
      }
    return gap;
  }


  template <int dim>
  void ContactSurface<dim>::admit(const Vector &displacement)
  {
    const std::vector<double> gap = normal_gap(displacement);
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      contact_nodes[k].gap -= std::min(0., gap[k]);
  }


  template <int dim>
  Vector ContactSurface<dim>::gaps() const
  {
    Vector result = discretization.make_vector();
    for (const ContactNode<dim> &node : contact_nodes)
      result.local_element(node.entry()) = node.gap;
    return result;
  }


  template <int dim>
  void ContactSurface<dim>::set_gaps(const Vector &gaps)
  {
    for (ContactNode<dim> &node : contact_nodes)
      node.gap = gaps.local_element(node.entry());
  }


  template <int dim>
  double ContactSurface<dim>::distance_to(const MovedObstacle<dim> &obstacle,
                                          const ContactNode<dim>   &node,
                                          const Vector             &displacement) const
  {
    const auto way = obstacle.try_project(obstacle_contact.displaced(node.node, displacement))
                       .value_or(far_projection<dim>());
    return way.is_carried(obstacle_contact.end_tolerance()) ? way.gap : way.distance();
  }


  template <int dim>
  std::vector<double> ContactSurface<dim>::distance(const Vector &displacement) const
  {
    std::vector<double> result = normal_gap(displacement);
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      if (const ContactNode<dim> &node = contact_nodes[k];
          !descriptions[node.pair].of_two_bodies() && (follows() || std::isinf(result[k])))
        result[k] = distance_to(obstacle_contact.obstacle(node.pair), node, displacement);
      else if (std::isinf(result[k]) && follows())
        result[k] = clear_distance(node.pair);
      else
        result[k] *= node.distance_per_gap();
    return result;
  }


  template <int dim>
  std::vector<double> ContactSurface<dim>::largest_sliding(const Vector &displacement,
                                                           const Vector &contact_force) const
  {
    AssertDimension(contact_force.locally_owned_size(), displacement.locally_owned_size());
    std::vector<double> largest(descriptions.size(), 0.);
    if (!node_coupling->any() || follows())
      return largest;
    const auto sliding = relative_tangential(displacement);
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      {
        const ContactNode<dim> &node = contact_nodes[k];
        if (!node.partners.empty() && is_pressed(node.normal_force(contact_force)))
          largest[node.pair] =
            std::max(largest[node.pair], sliding[k].norm() / std::pow(node.weight, 1. / (dim - 1)));
      }
    Utilities::MPI::max(largest, discretization.communicator(), largest);
    return largest;
  }


  template <int dim>
  void ContactSurface<dim>::check_initial_gap(const Vector &initial_displacement) const
  {
    obstacle_contact.check_initial_gap(initial_displacement);
    if (follows())
      {
        check_that_bodies_are_apart(initial_displacement);
        return;
      }
    const std::vector<double> gap      = distance(initial_displacement);
    const double              touching = touching_distance(discretization.mesh().body_size());
    std::vector<Complaint>    complaints;
    for (std::size_t k = 0; k < contact_nodes.size(); ++k)
      if (descriptions[contact_nodes[k].pair].of_two_bodies() && gap[k] < -touching)
        {
          std::ostringstream message;
          message << "Contact/Pairs = " << descriptions[contact_nodes[k].pair].name
                  << ": the bodies overlap at the start, by " << -gap[k] << " at ("
                  << contact_nodes[k].position
                  << "). Move one of them, or change the initial displacement.";
          if (complaints.empty() || -gap[k] > complaints[0].first)
            complaints = {{-gap[k], message.str()}};
        }
    throw_worst(complaints, discretization.communicator());
  }


  template class ContactSurface<2>;
  template class ContactSurface<3>;
} // namespace signorini
