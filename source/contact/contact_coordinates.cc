// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/contact/contact_coordinates.h>
#include <signorini/surfaces/contact_frame.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The frame of the axes. */
    template <int dim>
    std::array<double, dim * dim> identity()
    {
      std::array<double, dim * dim> result{};
      for (unsigned int c = 0; c < dim; ++c)
        result[dim * c + c] = 1.;
      return result;
    }


    /** The components of a node along the rows of a frame. */
    template <int dim>
    void to_rows(const std::array<double, dim * dim> &frame, double *u)
    {
      std::array<double, dim> w{};
      for (unsigned int row = 0; row < dim; ++row)
        for (unsigned int c = 0; c < dim; ++c)
          w[row] += frame[dim * row + c] * u[c];
      std::copy(w.begin(), w.end(), u);
    }


    /** The sum of the rows of a frame times the components of a node. */
    template <int dim>
    void from_rows(const std::array<double, dim * dim> &frame, double *w)
    {
      std::array<double, dim> u{};
      for (unsigned int row = 0; row < dim; ++row)
        for (unsigned int c = 0; c < dim; ++c)
          u[c] += frame[dim * row + c] * w[row];
      std::copy(u.begin(), u.end(), w);
    }
  } // namespace


  template <int dim>
  ContactCoordinates<dim>::ContactCoordinates(const Discretization<dim>      &discretization,
                                              const ContactSurface<dim>      &surface,
                                              const DirichletConditions<dim> &dirichlet)
    : dirichlet(dirichlet)
    , owned_contact_nodes(surface.nodes())
    , node_coupling(surface.coupling())
    , n_owned_entries(dim * discretization.matrices().pattern.n_owned)
  {
    for (const ContactNode<dim> &node : owned_contact_nodes)
      {
        normals.push_back(node.entry());
        frames[node.node] = node.frame;
      }
    for (const auto &[node, components] : dirichlet.nodes())
      {
        const Frame &frame = frames.emplace(node, identity<dim>()).first->second;
        const auto   row   = rows_along_axes<dim>(frame);
        for (unsigned int c = 0; c < dim; ++c)
          if (components[c] != DirichletConditions<dim>::none && row[c] < dim)
            {
              prescribed.push_back(dim * node + row[c]);
              dirichlet_sources.push_back(
                {components[c], discretization.node_positions()[node], c, frame[dim * row[c] + c]});
            }
      }
    find_tangential_entries();
    find_turned_nodes();
  }


  template <int dim>
  void ContactCoordinates<dim>::find_turned_nodes()
  {
    const Frame axes = identity<dim>();
    turned_nodes.clear();
    for (std::size_t k = 0; k < owned_contact_nodes.size(); ++k)
      if (const ContactNode<dim> &node = owned_contact_nodes[k];
          node.row == 0 && (node.frame != axes || node.dual_frame() != axes))
        turned_nodes.push_back({k, dim * node.node, node.frame, node.dual_frame()});
  }


  template <int dim>
  void ContactCoordinates<dim>::find_tangential_entries()
  {
    std::set<unsigned int> held(prescribed.begin(), prescribed.end());
    for (const ContactNode<dim> &node : owned_contact_nodes)
      if (node.row > 0 && node.is_bounded())
        held.insert(node.entry());
    tangential.clear();
    for (const ContactNode<dim> &node : owned_contact_nodes)
      {
        tangential.emplace_back();
        if (node.row > 0)
          continue;
        for (unsigned int entry = dim * node.node + 1; entry < dim * (node.node + 1); ++entry)
          if (node.friction.any() && held.count(entry) == 0)
            tangential.back().push_back(entry);
      }
  }


  template <int dim>
  void ContactCoordinates<dim>::follow_frames()
  {
    bool any = node_coupling.changes();
    for (const ContactNode<dim> &node : owned_contact_nodes)
      {
        Frame &frame = frames[node.node];
        any          = any || frame != node.frame;
        frame        = node.frame;
      }
    find_tangential_entries();
    find_turned_nodes();
    // All processes ask for the frames of ghosts together, or none does.
    if (dealii::Utilities::MPI::max(static_cast<unsigned int>(any), dirichlet.communicator()) == 0)
      return;
    for (std::size_t j = 0; j < prescribed.size(); ++j)
      {
        const Frame       &frame  = frames.at(prescribed[j] / dim);
        const unsigned int row    = prescribed[j] % dim;
        DirichletSource   &source = dirichlet_sources[j];
        Assert(rows_along_axes<dim>(frame)[source.component] == row,
               dealii::ExcMessage("A prescribed direction stays in its row of the frame."));
        source.direction = frame[dim * row + source.component];
      }
    ++turns;
  }


  template <int dim>
  std::vector<unsigned int> ContactCoordinates<dim>::contact_nodes() const
  {
    std::vector<unsigned int> nodes;
    for (const ContactNode<dim> &node : owned_contact_nodes)
      if (node.row == 0)
        nodes.push_back(node.node);
    return nodes;
  }


  template <int dim>
  std::vector<char> ContactCoordinates<dim>::prescribed_components() const
  {
    std::vector<char> components(n_owned_entries, 0);
    for (const unsigned int entry : prescribed) // along axes, or against them
      {
        const Frame       &frame = frames.at(entry / dim);
        const unsigned int node = entry / dim, row = entry % dim;
        for (unsigned int c = 0; c < dim; ++c)
          if (std::abs(frame[dim * row + c]) > 0.5)
            components[dim * node + c] = 1;
      }
    return components;
  }


  template <int dim>
  std::vector<unsigned int> ContactCoordinates<dim>::clamped_nodes() const
  {
    std::map<unsigned int, unsigned int> n_prescribed;
    for (const unsigned int entry : prescribed)
      ++n_prescribed[entry / dim];
    std::vector<unsigned int> nodes;
    for (const auto &[node, n] : n_prescribed)
      if (n == dim)
        nodes.push_back(node);
    return nodes;
  }


  template <int dim>
  void ContactCoordinates<dim>::displacement_to_cartesian(Vector &vector) const
  {
    const auto rotate = [&](const unsigned int level) {
      for (const TurnedNode &node : turned_nodes)
        if (node_coupling.level(node.contact_node) == level)
          from_rows<dim>(node.dual, vector.begin() + node.first_entry);
    };
    rotate(0);
    // Partners may be contact nodes themselves: they are Cartesian before others need them.
    for (unsigned int level = 1; level <= node_coupling.n_levels(); ++level)
      {
        const std::vector<double> motion = node_coupling.partner_motion(vector);
        for (std::size_t r = 0; r < motion.size(); ++r)
          if (node_coupling.level(node_coupling.nodes_of_relative_entries()[r]) == level)
            vector.local_element(relative_entries()[r]) += motion[r];
        rotate(level);
      }
  }


  template <int dim>
  void ContactCoordinates<dim>::displacement_to_contact(Vector &vector) const
  {
    std::vector<double> motion;
    if (node_coupling.any())
      motion = node_coupling.partner_motion(vector);
    rotate_to_frames(vector);
    for (std::size_t r = 0; r < motion.size(); ++r)
      vector.local_element(relative_entries()[r]) -= motion[r];
  }


  template <int dim>
  void ContactCoordinates<dim>::force_to_contact(Vector &vector) const
  {
    const auto rotate = [&](const unsigned int level) {
      for (const TurnedNode &node : turned_nodes)
        if (node_coupling.level(node.contact_node) == level)
          to_rows<dim>(node.dual, vector.begin() + node.first_entry);
    };
    for (unsigned int level = node_coupling.n_levels(); level > 0; --level)
      {
        rotate(level);
        node_coupling.add_to_partners(relative_forces(vector, 1., level), vector);
      }
    rotate(0);
  }


  template <int dim>
  void ContactCoordinates<dim>::force_to_cartesian(Vector &vector) const
  {
    const std::vector<double> forces = relative_forces(vector, -1.);
    force_from_frames(vector);
    if (node_coupling.any())
      node_coupling.add_to_partners(forces, vector);
  }


  template <int dim>
  std::vector<double>
  ContactCoordinates<dim>::relative_forces(const Vector                     &vector,
                                           const double                      factor,
                                           const std::optional<unsigned int> level) const
  {
    std::vector<double> forces;
    forces.reserve(relative_entries().size());
    for (std::size_t r = 0; r < relative_entries().size(); ++r)
      {
        const std::size_t node = node_coupling.nodes_of_relative_entries()[r];
        forces.push_back(!level || node_coupling.level(node) == *level
                           ? factor * vector.local_element(relative_entries()[r])
                           : 0.);
      }
    return forces;
  }


  template <int dim>
  template <typename Turn>
  void ContactCoordinates<dim>::for_each_node(Vector &vector, const Turn &turn) const
  {
    AssertDimension(vector.locally_owned_size(), n_owned_entries);
    for (const TurnedNode &node : turned_nodes)
      turn(node, vector.begin() + node.first_entry);
  }


  template <int dim>
  void ContactCoordinates<dim>::rotate_to_frames(Vector &vector) const
  {
    for_each_node(vector, [](const TurnedNode &node, double *u) { to_rows<dim>(node.frame, u); });
  }


  template <int dim>
  void ContactCoordinates<dim>::rotate_from_frames(Vector &vector) const
  {
    for_each_node(vector, [](const TurnedNode &node, double *w) { from_rows<dim>(node.dual, w); });
  }


  template <int dim>
  void ContactCoordinates<dim>::force_to_frames(Vector &vector) const
  {
    for_each_node(vector, [](const TurnedNode &node, double *f) { to_rows<dim>(node.dual, f); });
  }


  template <int dim>
  void ContactCoordinates<dim>::force_from_frames(Vector &vector) const
  {
    for_each_node(vector, [](const TurnedNode &node, double *f) { from_rows<dim>(node.frame, f); });
  }


  template <int dim>
  std::vector<unsigned int> ContactCoordinates<dim>::held_entries(const ActiveSet &statuses) const
  {
    AssertDimension(statuses.size(), normals.size());
    std::vector<unsigned int> held = prescribed;
    for (std::size_t k = 0; k < statuses.size(); ++k)
      {
        if (contact_status::is_closed(statuses[k]))
          held.push_back(normals[k]);
        if (contact_status::sticks(statuses[k]))
          held.insert(held.end(), tangential[k].begin(), tangential[k].end());
      }
    return held;
  }


  template <int dim>
  Vector ContactCoordinates<dim>::normal_reaction(const ActiveSet &statuses,
                                                  const Vector    &residual) const
  {
    AssertDimension(statuses.size(), normals.size());
    Vector reaction;
    reaction.reinit(residual);
    for (std::size_t k = 0; k < statuses.size(); ++k)
      if (contact_status::is_closed(statuses[k]))
        reaction.local_element(normals[k]) = -residual.local_element(normals[k]);
    return reaction;
  }


  template <int dim>
  std::vector<double> ContactCoordinates<dim>::dirichlet_values(const double time) const
  {
    std::vector<double> values;
    if (!dirichlet.any())
      return values;
    values.reserve(prescribed.size());
    std::vector<std::string> not_numbers;
    for (const DirichletSource &source : dirichlet_sources)
      {
        values.push_back(source.direction
                         * dirichlet.value(source.condition, source.point, source.component, time));
        if (!std::isfinite(values.back()))
          not_numbers.push_back(dirichlet.name(source.condition));
      }
    throw_if_any_is_no_number(not_numbers, time, dirichlet.communicator());
    return values;
  }


  template class ContactCoordinates<2>;
  template class ContactCoordinates<3>;
} // namespace signorini
