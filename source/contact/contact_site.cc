// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/contact_site.h>
#include <signorini/contact/free_directions.h>
#include <signorini/contact/nodal_friction.h>
#include <signorini/surfaces/contact_frame.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Of a unit normal, across those of the others at a node. */
    constexpr double independent = 0.1;
    /** The same for sides of one obstacle, whose angles are well known. */
    constexpr double independent_sides = 0.015;
  } // namespace


  template <int dim>
  void Facing<dim>::set_opposite(const PairCondition<dim> *new_opposite)
  {
    opposite  = new_opposite;
    condition = {};
    if (opposite == nullptr)
      return;
    condition.normal = opposite->geometry.normal();
    condition.bound  = opposite->bound;
  }


  template <int dim>
  bool ContactSite<dim>::is_bounded_by(const unsigned int facing) const
  {
    return std::find(bounding.begin(), bounding.end(), facing) != bounding.end();
  }


  template <int dim>
  bool ContactSite<dim>::add_row(const unsigned int facing)
  {
    if (bounding.size() == n_rows)
      return false;
    std::vector<Tensor<1, dim>> normals;
    for (const unsigned int f : bounding)
      normals.push_back(facings[f].condition.normal);
    const auto     frame  = orthonormal_frame<dim>(oblique_frame<dim>(normals));
    Tensor<1, dim> across = facings[facing].condition.normal;
    for (unsigned int row = 0; row < normals.size(); ++row)
      {
        Tensor<1, dim> other;
        for (unsigned int c = 0; c < dim; ++c)
          other[c] = frame[dim * row + c];
        across -= (across * other) * other;
      }
    const bool is_side = facings[facing].side < Facing<dim>::absent;
    if (across.norm() < (is_side ? independent_sides : independent))
      return false;
    bounding.push_back(facing);
    return true;
  }


  template <int dim>
  void ContactSite<dim>::drop_what_is_gone()
  {
    bounding.erase(std::remove_if(bounding.begin(),
                                  bounding.end(),
                                  [&](const unsigned int f) { return !facings[f].is_there(); }),
                   bounding.end());
    if (!bounding.empty())
      return;
    const auto closer = [](const Facing<dim> &a, const Facing<dim> &b) {
      return std::pair(!a.is_there(), a.gap) < std::pair(!b.is_there(), b.gap);
    };
    bounding = {static_cast<unsigned int>(std::min_element(facings.begin(), facings.end(), closer)
                                          - facings.begin())};
  }


  template <int dim>
  std::vector<unsigned int> ContactSite<dim>::order() const
  {
    std::vector<unsigned int> result = bounding;
    for (unsigned int f = 0; f < facings.size(); ++f)
      if (!is_bounded_by(f))
        result.push_back(f);
    return result;
  }


  template <int dim>
  ContactNode<dim> ContactSite<dim>::contact_node(
    const unsigned int                                   row,
    ContactNode<dim>                                     node,
    const typename DirichletConditions<dim>::Components *conditions) const
  {
    const Facing<dim> &facing     = facings[order()[row]];
    const bool         was_shared = node.is_shared();
    node.pair                     = facing.pair;
    node.weight                   = facing.area;
    node.friction                 = facing.friction;
    node.n_bounds                 = bounding.size();
    node.gap =
      row < node.n_bounds ? facing.condition.bound : std::numeric_limits<double>::infinity();
    node.partners        = {};
    node.transmission    = 1.;
    node.free_part       = 1.;
    node.prescribed_part = {};
    if (!facings[bounding[0]].is_there()) // nothing but what has gone: the frame is any
      {
        node.gap      = std::numeric_limits<double>::infinity();
        node.relative = {};
        if (was_shared) // and orthonormal
          node.frame = contact_frame<dim>(node.direction(0));
        return node;
      }

    std::vector<Tensor<1, dim>> normals;
    for (const unsigned int f : bounding)
      normals.push_back(facings[f].condition.normal);
    const auto frame = oblique_frame<dim>(normals);
    if (facing.of_body && facing.opposite != nullptr && row < node.n_bounds)
      {
        const ContactNode<dim> &geometry = facing.opposite->geometry;
        node.weight                      = geometry.weight;
        node.friction                    = facing.friction.with_area(geometry.weight / facing.area);
        node.partners                    = geometry.partners;
        node.transmission                = geometry.transmission;
        node.frame                       = conditions != nullptr ? geometry.frame : frame;
      }
    else if (conditions == nullptr)
      node.frame = frame;
    else if (meet_in_free_directions<dim>(*conditions, normals[0], node))
      {
        node.gap /= node.free_part; // prescribed displacements rest
        // The law is one of nodal forces, of which the normal one is the free part.
        node.friction.coefficient /= node.free_part;
      }
    else
      node.gap = std::numeric_limits<double>::infinity();
    if (node.is_shared())
      node.dual = dual_frame<dim>(frame);
    // The surface counts displacements from the reference configuration.
    node.gap += node.normal()
                * (facing.of_body && facing.opposite != nullptr ? facing.opposite->displacement
                                                                : displacement);
    node.relative = relative_directions(node, conditions);
    return node;
  }


  template struct Facing<2>;
  template struct Facing<3>;
  template struct ContactSite<2>;
  template struct ContactSite<3>;
} // namespace signorini
