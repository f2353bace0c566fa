// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/base/user_error.h>
#include <signorini/contact/free_directions.h>
#include <signorini/contact/obstacle_contact.h>
#include <signorini/surfaces/contact_frame.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** What the displacement prescribed at the start takes of the gap. */
    template <int dim>
    double brought(const DirichletConditions<dim>                      &dirichlet,
                   const typename DirichletConditions<dim>::Components &conditions,
                   const ContactNode<dim>                              &node)
    {
      double result = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        if (node.prescribed_part[c] != 0.)
          result += node.prescribed_part[c] * dirichlet.value(conditions[c], node.position, c, 0.);
      return result;
    }
  } // namespace


  template <int dim>
  ObstacleContact<dim>::ObstacleContact(const Discretization<dim>             &discretization,
                                        const DirichletConditions<dim>        &dirichlet,
                                        const std::vector<NamedObstacle<dim>> &obstacles,
                                        const std::vector<PairDescription>    &pair_descriptions,
                                        const ContactMotion                    motion)
    : discretization(discretization)
    , pairs(pair_descriptions)
    , obstacles(obstacles)
    , moved(obstacles.begin(), obstacles.end())
    , motion(motion)
  {
    std::map<unsigned int, ContactNode<dim>> closest;
    std::vector<Complaint>                   complaints;
    for (unsigned int p = 0; p < pairs.size(); ++p)
      if (!pairs[p].of_two_bodies())
        add_closest(p, closest);

    for (auto &[node, contact_node] : closest)
      {
        if (const auto conditions = dirichlet.nodes().find(node);
            conditions != dirichlet.nodes().end())
          {
            if (!meet_in_free_directions<dim>(
                  conditions->second, contact_node.normal(), contact_node)
                && !wait_for_other_normals(conditions->second, contact_node))
              {
                ++n_left_to_dirichlet;
                continue;
              }
            contact_node.gap -= brought(dirichlet, conditions->second, contact_node);
            contact_node.gap /= contact_node.free_part;
            if (contact_node.free_part != 1.)
              ++n_oblique;
            check_that_they_rest(dirichlet, conditions->second, contact_node, complaints);
            contact_nodes.push_back(contact_node);
          }
        else
          add_with_rows(contact_node);
      }
    throw_worst(complaints, discretization.communicator());
    n_left_to_dirichlet = Utilities::MPI::sum(n_left_to_dirichlet, discretization.communicator());
    n_oblique           = Utilities::MPI::sum(n_oblique, discretization.communicator());
  }


  template <int dim>
  void ObstacleContact<dim>::add_with_rows(ContactNode<dim> contact_node)
  {
    contact_nodes.push_back(contact_node);
    if (motion == ContactMotion::linearised)
      return;
    const unsigned int own_pair = contact_node.pair;
    contact_node.gap            = std::numeric_limits<double>::infinity();
    for (const auto &[pair, area] : surface_nodes.at(contact_node.node).areas)
      for (unsigned int k = pair == own_pair; k < obstacle(pair).most_conditions(); ++k)
        if (contact_node.row + 1 < dim)
          {
            ++contact_node.row;
            ContactNode<dim> further = contact_node;
            further.pair             = pair;
            further.weight           = area;
            contact_nodes.push_back(further);
          }
  }


  template <int dim>
  bool ObstacleContact<dim>::wait_for_other_normals(
    const typename DirichletConditions<dim>::Components &conditions,
    ContactNode<dim>                                    &contact_node) const
  {
    const bool is_only = surface_nodes.at(contact_node.node).areas.size() == 1;
    if (motion == ContactMotion::linearised || (is_only && obstacle(contact_node.pair).is_flat()))
      return false;
    for (unsigned int c = 0; c < dim; ++c)
      if (conditions[c] == DirichletConditions<dim>::none)
        {
          Tensor<1, dim> free;
          free[c]          = 1.;
          contact_node.gap = std::numeric_limits<double>::infinity();
          return meet_in_free_directions<dim>(conditions, free, contact_node);
        }
    return false;
  }


  template <int dim>
  void ObstacleContact<dim>::check_that_they_rest(
    const DirichletConditions<dim>                      &dirichlet,
    const typename DirichletConditions<dim>::Components &conditions,
    const ContactNode<dim>                              &contact_node,
    std::vector<Complaint>                              &complaints) const
  {
    const PairDescription &pair = pairs[contact_node.pair];
    const auto complain = [&](const unsigned int c, const unsigned int of_pair, const bool turns) {
      std::ostringstream message;
      message << "Bodies/" << discretization.mesh().bodies()[pair.slave].name << "/Dirichlet: at ("
              << contact_node.position << ") the displacement in "
              << "xyz"[c] << " is prescribed and changes in time, and the obstacle '"
              << obstacles[pairs[of_pair].obstacle].name << "' is "
              << (turns ? "curved or turns" : "oblique to it")
              << ". Such a motion opens and closes the gap by itself, which "
                 "is not implemented. Prescribe a displacement that rests, move another part "
                 "of the boundary, or turn the scene until the obstacle and the prescribed "
                 "direction are parallel or at right angles.";
      complaints.emplace_back(std::abs(contact_node.prescribed_part[c]), message.str());
    };
    for (unsigned int c = 0; c < dim; ++c)
      {
        if (conditions[c] == DirichletConditions<dim>::none || !dirichlet.moves(conditions[c], c))
          continue;
        if (motion == ContactMotion::linearised && contact_node.prescribed_part[c] != 0.)
          complain(c, contact_node.pair, false);
        if (motion == ContactMotion::follow) // it may come to any of its obstacles
          for (const auto &[of_pair, area] : surface_nodes.at(contact_node.node).areas)
            {
              const bool turns = !obstacle(of_pair).is_flat();
              if (turns || is_oblique_to(of_pair, contact_node, conditions)[c])
                complain(c, of_pair, turns);
            }
      }
  }


  template <int dim>
  std::array<bool, dim> ObstacleContact<dim>::is_oblique_to(
    const unsigned int                                   pair,
    ContactNode<dim>                                     node,
    const typename DirichletConditions<dim>::Components &conditions) const
  {
    std::array<bool, dim> result{};
    if (meet_in_free_directions<dim>(
          conditions, obstacle(pair).project(node.position).normal, node))
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = node.prescribed_part[c] != 0.;
    return result;
  }


  template <int dim>
  ObstacleProjection<dim>
  ObstacleContact<dim>::projection_at_start(const unsigned int pair,
                                            const Point<dim>  &position) const
  {
    // Linearised contact is decided here once for all, and has to know.
    if (motion == ContactMotion::linearised)
      return obstacle(pair).project(position);
    return obstacle(pair).try_project(position).value_or(far_projection<dim>());
  }


  template <int dim>
  void ObstacleContact<dim>::add_closest(const unsigned int                        pair,
                                         std::map<unsigned int, ContactNode<dim>> &closest)
  {
    const PairDescription &description = pairs[pair];
    Vector                 area = discretization.make_vector(), outward = area;
    integrate(description, area, outward);
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      {
        const double weight = area.local_element(dim * node);
        if (!(weight > 0.))
          continue;
        SurfaceNode &surface_node = surface_nodes[node];
        surface_node.body         = description.slave;
        surface_node.areas.emplace_back(pair, weight);
        const Point<dim> &position   = discretization.node_positions()[node];
        const auto        projection = projection_at_start(pair, position);
        double            facing     = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          facing += outward.local_element(dim * node + c) * projection.normal[c];
        const auto known = closest.find(node);
        // Across the normal, where an equator or the side of a box is, round-off must not decide.
        const bool faces = facing > 1e-8 * weight || motion == ContactMotion::follow;
        if (faces
            && (known == closest.end()
                || is_closer(projection, projection_at_start(known->second.pair, position))))
          closest[node] = {
            node, pair, position, projection.gap, weight, contact_frame(projection.normal), {}};
      }
  }


  template <int dim>
  void
  ObstacleContact<dim>::integrate(const PairDescription &pair, Vector &area, Vector &outward) const
  {
    const FE_Q<dim>                      scalar_fe(1);
    FEFaceValues<dim>                    fe_values(discretization.mesh().mapping(),
                                scalar_fe,
                                QGauss<dim - 1>(discretization.mesh().n_quadrature_points()),
                                update_values | update_normal_vectors | update_JxW_values);
    std::vector<types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
    dealii::Vector<double>               local_area(dofs.size()), local_normal(dofs.size());
    for (const auto &cell : discretization.cells())
      for (const unsigned int f : cell->face_indices())
        if (is_surface_face<dim>(cell, f, pair.slave, pair.slave_boundary_ids))
          {
            fe_values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(cell), f);
            local_area   = 0.;
            local_normal = 0.;
            for (const unsigned int q : fe_values.quadrature_point_indices())
              for (unsigned int v = 0; v < scalar_fe.n_dofs_per_cell(); ++v)
                {
                  const double measure = fe_values.shape_value(v, q) * fe_values.JxW(q);
                  local_area[dim * v] += measure;
                  for (unsigned int c = 0; c < dim; ++c)
                    local_normal[dim * v + c] += measure * fe_values.normal_vector(q)[c];
                }
            cell->get_dof_indices(dofs);
            // A hanging node hands its share to the nodes that it hangs between.
            discretization.hanging_node_constraints().distribute_local_to_global(
              local_area, dofs, area);
            discretization.hanging_node_constraints().distribute_local_to_global(
              local_normal, dofs, outward);
          }
    area.compress(VectorOperation::add);
    outward.compress(VectorOperation::add);
    // Shape functions that do not live on a face contribute round-off; what is tiny is not on the
    // surface.
    const double threshold = 1e-10 * area.linfty_norm();
    for (unsigned int i = 0; i < area.locally_owned_size(); ++i)
      if (area.local_element(i) < threshold)
        area.local_element(i) = 0.;
  }


  template <int dim>
  void ObstacleContact<dim>::move_obstacles(const double start, const double end)
  {
    for (MovedObstacle<dim> &obstacle : moved)
      obstacle.move(start, end);
  }


  template <int dim>
  bool ObstacleContact<dim>::is_closer(const ObstacleProjection<dim> &first,
                                       const ObstacleProjection<dim> &second) const
  {
    const auto rank = [&](const ObstacleProjection<dim> &projection) {
      return std::pair(!projection.is_carried(end_tolerance()), projection.gap);
    };
    return rank(first) < rank(second);
  }


  template <int dim>
  Point<dim> ObstacleContact<dim>::displaced(const unsigned int node,
                                             const Vector      &displacement) const
  {
    Point<dim> position = discretization.node_positions()[node];
    for (unsigned int c = 0; c < dim; ++c)
      position[c] += displacement.local_element(dim * node + c);
    return position;
  }


  template <int dim>
  double ObstacleContact<dim>::end_tolerance() const
  {
    return touching_distance(discretization.mesh().body_size());
  }


  template <int dim>
  std::optional<ObstacleProjection<dim>>
  ObstacleContact<dim>::at_an_end(const ContactNode<dim> &node, const Vector &displacement) const
  {
    if (motion == ContactMotion::follow || pairs[node.pair].of_two_bodies()
        || !obstacle(node.pair).has_end())
      return {};
    return obstacle(node.pair).project(displaced(node.node, displacement));
  }


  template <int dim>
  std::vector<double> ObstacleContact<dim>::geometric_penetration(const Vector &displacement) const
  {
    std::vector<double> deepest(discretization.mesh().bodies().size(), 0.);
    for (const auto &[node, surface_node] : surface_nodes)
      {
        const Point<dim> position = displaced(node, displacement);
        double          &depth    = deepest[surface_node.body];
        for (unsigned int pair = 0; pair < pairs.size(); ++pair)
          if (!pairs[pair].of_two_bodies() && pairs[pair].slave == surface_node.body)
            if (const auto way = obstacle(pair).try_project(position))
              depth = std::max(depth, way->depth());
      }
    Utilities::MPI::max(deepest, discretization.communicator(), deepest);
    return deepest;
  }


  template <int dim>
  void ObstacleContact<dim>::check_initial_gap(const Vector &initial_displacement) const
  {
    const double tolerance = touching_distance(discretization.mesh().body_size());
    for (const PairDescription &pair : pairs)
      {
        if (pair.of_two_bodies())
          continue;
        double     deepest = 0.;
        Point<dim> place;
        const auto look = [&](const Point<dim> &point) {
          const auto way = moved[pair.obstacle].try_project(point);
          if (way && way->depth() > deepest)
            {
              deepest = way->depth();
              place   = point;
            }
        };
        Vector ghosted(discretization.locally_owned(),
                       discretization.locally_relevant(),
                       discretization.communicator());
        ghosted.copy_locally_owned_data_from(initial_displacement);
        ghosted.update_ghost_values();
        for (const auto &cell : discretization.cells())
          for (const unsigned int f : cell->face_indices())
            if (is_surface_face<dim>(cell, f, pair.slave, pair.slave_boundary_ids))
              for (const unsigned int v : cell->face(f)->vertex_indices())
                {
                  Point<dim> point = cell->face(f)->vertex(v);
                  look(point);
                  for (unsigned int c = 0; c < dim; ++c)
                    point[c] += ghosted(cell->face(f)->vertex_dof_index(v, c));
                  look(point);
                }
        // The process with the deepest point tells the others, so that all report the same place.
        const double maximum = Utilities::MPI::max(deepest, discretization.communicator());
        if (maximum > tolerance)
          {
            for (unsigned int c = 0; c < dim; ++c)
              place[c] = Utilities::MPI::max(
                deepest == maximum ? place[c] : std::numeric_limits<double>::lowest(),
                discretization.communicator());
            std::ostringstream message;
            message
              << "Contact/Pairs = " << pair.name << ": the body '"
              << discretization.mesh().bodies()[pair.slave].name << "' penetrates the obstacle '"
              << obstacles[pair.obstacle].name << "' at the start, by " << maximum << " at ("
              << place
              << "). Move the body or the obstacle apart: the body has to be outside both with its "
                 "initial displacement and without. A press fit begins apart, with an obstacle "
                 "that "
                 "moves in (`Motion`).";
            throw UserError(message.str());
          }
      }
  }


  template class ObstacleContact<2>;
  template class ObstacleContact<3>;
} // namespace signorini
