// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/contact/mortar_coupling.h>
#include <signorini/surfaces/contact_frame.h>
#include <signorini/surfaces/dual_basis.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    // A sliver this small has no well-conditioned dual basis, and a node of which so little is
    // covered (on the faces that are covered at all) would extrapolate.
    constexpr double smallest_covered_face = 1e-3, smallest_covered_node = 2e-2;
    // Part of a normal in the free directions: below the first, about 18 degrees, the normal is
    // prescribed; above the second the prescribed directions are tangential.
    constexpr double held_normal = 0.3, free_normal = 0.95;
    // Of the sum of normals: below it they are no direction.
    constexpr double smallest_normal = 1e-3;
    // Of a force between bodies in the force of its node. Less is left where a node that is hardly
    // covered extrapolates over a neighbour without multiplier; below zero bodies would have to
    // come closer to widen the gap.
    constexpr double smallest_transmission = 0.1;
    // What is added to the bluntness of both sides: two flat surfaces have the mean of both
    // normals.
    constexpr double equally_flat = 0.01;

    template <int dim>
    Tensor<1, dim> unit(const Tensor<1, dim> &vector)
    {
      return vector / vector.norm();
    }


    /**
     * Give a prescribed node a frame in which single tangential entries are prescribed. The normal
     * of a curved surface at a plane of symmetry is an average over one side only; its small part
     * in the prescribed direction means nothing and is dropped.
     * @return the part of the normal in free directions: its square is 1 if the prescribed
     *         directions are tangential, 0 if the normal is prescribed
     */
    template <int dim>
    double fit_frame_to_dirichlet(const typename DirichletConditions<dim>::Components &components,
                                  ContactNode<dim>                                    &contact_node)
    {
      std::array<bool, dim> held;
      Tensor<1, dim>        normal = contact_node.normal();
      for (unsigned int c = 0; c < dim; ++c)
        if ((held[c] = components[c] != DirichletConditions<dim>::none))
          normal[c] = 0.;
      const double free_part = normal.norm();
      if (free_part > 0.)
        contact_frame_with_dirichlet<dim>(normal / free_part, held, contact_node.frame);
      return free_part;
    }
  } // namespace


  template <int dim>
  MortarCoupling<dim>::MortarCoupling(const Discretization<dim>          &discretization,
                                      const DirichletConditions<dim>     &dirichlet,
                                      const std::vector<PairDescription> &pairs,
                                      const unsigned int                  pair)
    : MortarCoupling(discretization,
                     dirichlet,
                     pairs,
                     pair,
                     find_facing_surfaces(discretization, pairs[pair]),
                     MortarRules())
  {
  }


  template <int dim>
  MortarCoupling<dim>::MortarCoupling(const Discretization<dim>          &discretization,
                                      const DirichletConditions<dim>     &dirichlet,
                                      const std::vector<PairDescription> &pairs,
                                      const unsigned int                  pair,
                                      const FacingSurfaces<dim>          &surfaces,
                                      const MortarRules                  &rules)
    : discretization(discretization)
    , pair(pair)
    , pair_name(pairs[pair].name)
    , rules(rules)
  {
    const auto faces   = integrate(surfaces);
    auto       carries = choose_multipliers(faces, dirichlet);
    do
      assemble_rows(faces, carries);
    while (drop_what_transmits_little(carries));
  }


  template <int dim>
  std::vector<CoveredFace<dim>> MortarCoupling<dim>::integrate(const FacingSurfaces<dim> &surfaces)
  {
    MeanCurvature<dim>            slave_curvature, master_curvature;
    std::vector<CoveredFace<dim>> result;
    for (std::size_t f = 0; f < surfaces.slaves.size(); ++f)
      {
        const SurfaceFace<dim> &slave = surfaces.slaves[f];
        CoveredFace<dim>        face(slave);
        total_area += face.full.sum();

        double covered = 0.;
        for (const Segment<dim> &segment : surfaces.segments[f])
          covered += segment.area;
        any_segment = any_segment || covered > 0.;
        if (covered < smallest_covered_face * projected_area(slave))
          continue;

        for (const Segment<dim> &segment : surfaces.segments[f])
          face.add(segment, surfaces.masters[segment.master], rules.facing);
        if (rules.bluntness == nullptr)
          for (const Segment<dim> &segment : surfaces.segments[f])
            for (const SegmentPoint<dim> &point : segment.points)
              {
                const Point<dim> position = slave.position(point.slave);
                slave_curvature.add(point.weight, position, point.normal);
                master_curvature.add(point.weight, position + point.apart, point.opposite);
              }
        if (rules.facing && face.mass.sum() < smallest_covered_face * face.full.sum())
          continue;
        total_covered_area += face.mass.sum();
        result.push_back(std::move(face));
      }
    const MPI_Comm communicator = discretization.communicator();
    if (rules.bluntness == nullptr)
      weights = weights_of_normals(slave_curvature.value(communicator),
                                   master_curvature.value(communicator));
    any_segment = Utilities::MPI::max(static_cast<unsigned int>(any_segment), communicator) > 0;
    total_area  = Utilities::MPI::sum(total_area, communicator);
    total_covered_area = Utilities::MPI::sum(total_covered_area, communicator);
    return result;
  }


  template <int dim>
  typename MortarCoupling<dim>::NodeIntegrals
  MortarCoupling<dim>::collect(const std::vector<CoveredFace<dim>> &faces) const
  {
    NodeIntegrals sums;
    for (Vector *vector :
         {&sums.covered, &sums.full, &sums.normals, &sums.opposite, &sums.clearance})
      *vector = discretization.make_vector();
    for (unsigned int i = 0; i < dim * discretization.matrices().pattern.n_local; ++i)
      sums.clearance.local_element(i) = std::numeric_limits<double>::max();
    for (const CoveredFace<dim> &face : faces)
      {
        const Eigen::VectorXd integrals = face.mass.rowwise().sum();
        for (std::size_t i = 0; i < face.nodes.size(); ++i)
          {
            const auto first = dim * face.nodes[i];
            sums.covered(first) += integrals[i];
            sums.full(first) += face.full[i];
            sums.clearance(first) = std::min(sums.clearance(first), face.clearance);
            for (unsigned int c = 0; c < dim; ++c)
              {
                sums.normals(first + c) += face.normals(i, c);
                sums.opposite(first + c) += face.opposite(i, c);
              }
          }
      }
    for (Vector *sum : {&sums.covered, &sums.full, &sums.normals, &sums.opposite})
      sum->compress(VectorOperation::add);
    sums.clearance.compress(VectorOperation::min);
    return sums;
  }


  template <int dim>
  Tensor<1, dim> MortarCoupling<dim>::NodeIntegrals::at(const Vector &sums, const unsigned int node)
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = sums.local_element(dim * node + c);
    return result;
  }


  template <int dim>
  Tensor<1, dim> MortarCoupling<dim>::normal_at(const unsigned int   node,
                                                const NodeIntegrals &sums) const
  {
    const Tensor<1, dim> of_slave  = NodeIntegrals::at(sums.normals, node),
                         of_master = -NodeIntegrals::at(sums.opposite, node);
    if (rules.bluntness == nullptr)
      return weights.slave * of_slave + weights.master * of_master;
    const double covered = sums.covered.local_element(dim * node);
    if (!(std::min(of_slave.norm(), of_master.norm()) > smallest_normal * covered))
      return Tensor<1, dim>();
    const double slave_bluntness  = (*rules.bluntness)[node],
                 master_bluntness = std::max(0., 1. - of_master.norm() / covered);
    return covered
           * ((master_bluntness + equally_flat) * unit(of_slave)
              + (slave_bluntness + equally_flat) * unit(of_master));
  }


  template <int dim>
  bool MortarCoupling<dim>::fit_to_dirichlet(const DirichletConditions<dim> &dirichlet,
                                             const Tensor<1, dim>           &normal,
                                             ContactNode<dim>               &contact_node,
                                             std::string                    &complaint)
  {
    const auto condition = dirichlet.nodes().find(contact_node.node);
    if (condition == dirichlet.nodes().end())
      return true;
    const double free_part = fit_frame_to_dirichlet<dim>(condition->second, contact_node);
    if (free_part < held_normal)
      {
        ++n_left_to_dirichlet;
        return false;
      }
    if (free_part < free_normal)
      {
        std::ostringstream message;
        message
          << "Contact/Pairs = " << pair_name << ": at (" << contact_node.position
          << ") a prescribed direction is neither normal nor tangential to the contact surface "
             "(normal "
          << normal
          << "). Prescribe all components there or none, or turn the scene so that the surface is "
             "parallel to an axis.";
        complaint = std::min(complaint.empty() ? message.str() : complaint, message.str());
      }
    if (free_part < 1. - 1e-12)
      turn = std::max(turn, 180. / numbers::PI * std::acos(free_part));
    return true;
  }


  template <int dim>
  Vector MortarCoupling<dim>::choose_multipliers(const std::vector<CoveredFace<dim>> &faces,
                                                 const DirichletConditions<dim>      &dirichlet)
  {
    const NodeIntegrals sums    = collect(faces);
    Vector              carries = discretization.make_vector();
    std::string         oblique_condition;
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      {
        const double weight = sums.covered.local_element(dim * node);
        if (!(weight > smallest_covered_node * sums.full.local_element(dim * node))
            || (rules.excluded != nullptr && (*rules.excluded)[node]))
          continue;
        Tensor<1, dim> normal = normal_at(node, sums);
        if (!(normal.norm() > smallest_normal * weight)) // faces that look in opposite directions
          continue;
        normal /= normal.norm();
        ContactNode<dim> contact_node{
          node, pair, discretization.node_positions()[node], 0., weight, contact_frame(normal), {}};
        if (!fit_to_dirichlet(dirichlet, normal, contact_node, oblique_condition))
          continue;
        contact_node.clearance            = sums.clearance.local_element(dim * node);
        carries.local_element(dim * node) = 1.;
        contact_nodes.push_back(contact_node);
      }
    const MPI_Comm communicator = discretization.communicator();
    for (const std::string &message : Utilities::MPI::all_gather(communicator, oblique_condition))
      if (!message.empty())
        throw UserError(message);
    n_left_to_dirichlet = Utilities::MPI::sum(n_left_to_dirichlet, communicator);
    n_global = Utilities::MPI::sum(static_cast<unsigned int>(contact_nodes.size()), communicator);
    turn     = Utilities::MPI::max(turn, communicator);
    carries.update_ghost_values();
    return carries;
  }


  template <int dim>
  void MortarCoupling<dim>::assemble_rows(const std::vector<CoveredFace<dim>> &faces,
                                          const Vector                        &carries)
  {
    Rows   rows;
    Vector integrals = discretization.make_vector(), distance = integrals;
    for (const CoveredFace<dim> &face : faces)
      {
        std::vector<bool> face_carries;
        for (const auto node : face.nodes)
          face_carries.push_back(carries(dim * node) > 0.);
        if (std::find(face_carries.begin(), face_carries.end(), true) == face_carries.end())
          continue;
        const Eigen::MatrixXd psi           = dual_basis(face.mass, face_carries);
        const Eigen::MatrixXd slave_product = psi * face.mass, gap = psi * face.distance;
        for (std::size_t i = 0; i < face.nodes.size(); ++i)
          if (face_carries[i])
            {
              auto &row = rows[face.nodes[i]];
              for (const auto &[node, product] : face.mixed)
                row[node] += psi.row(i) * product;
              for (std::size_t k = 0; k < face.nodes.size(); ++k)
                if (!face_carries[k])
                  row[face.nodes[k]] -= slave_product(i, k);
              integrals(dim * face.nodes[i]) += slave_product.row(i).sum();
              for (unsigned int c = 0; c < dim; ++c)
                distance(dim * face.nodes[i] + c) += gap(i, c);
            }
      }
    integrals.compress(VectorOperation::add);
    distance.compress(VectorOperation::add);
    rows = send_to_owners(rows);

    for (ContactNode<dim> &contact_node : contact_nodes)
      {
        contact_node.gap = 0.;
        contact_node.partners.clear();
        const auto node =
          discretization.matrices().pattern.partitioner->local_to_global(dim * contact_node.node)
          / dim;
        for (const auto &[partner, value] : rows[node])
          if (std::abs(value) > 1e-14 * contact_node.weight)
            contact_node.partners.emplace_back(partner, value / contact_node.weight);
        contact_node.transmission =
          integrals.local_element(dim * contact_node.node) / contact_node.weight;
        for (unsigned int c = 0; c < dim; ++c)
          contact_node.gap += contact_node.frame[c]
                              * distance.local_element(dim * contact_node.node + c)
                              / contact_node.weight;
      }
  }


  template <int dim>
  bool MortarCoupling<dim>::drop_what_transmits_little(Vector &carries)
  {
    const auto little = [](const ContactNode<dim> &node) {
      return node.transmission < smallest_transmission;
    };
    for (const ContactNode<dim> &node : contact_nodes)
      if (little(node))
        carries.local_element(dim * node.node) = 0.;
    contact_nodes.erase(std::remove_if(contact_nodes.begin(), contact_nodes.end(), little),
                        contact_nodes.end());
    const unsigned int before = n_global;
    n_global                  = Utilities::MPI::sum(static_cast<unsigned int>(contact_nodes.size()),
                                   discretization.communicator());
    carries.update_ghost_values();
    return n_global < before;
  }


  template <int dim>
  typename MortarCoupling<dim>::Rows MortarCoupling<dim>::send_to_owners(const Rows &rows) const
  {
    const IndexSet &owned = discretization.locally_owned();
    IndexSet        strangers(owned.size());
    for (const auto &[node, row] : rows)
      if (!owned.is_element(dim * node))
        strangers.add_index(dim * node);
    const auto owners =
      Utilities::MPI::compute_index_owner(owned, strangers, discretization.communicator());

    Rows                                                                                 result;
    std::map<unsigned int, std::vector<std::pair<types::global_dof_index, NodeWeights>>> outgoing;
    for (const auto &[node, row] : rows)
      if (owned.is_element(dim * node))
        result[node] = row;
      else
        outgoing[owners[strangers.index_within_set(dim * node)]].emplace_back(
          node, NodeWeights(row.begin(), row.end()));
    for (const auto &[rank, parts] :
         Utilities::MPI::some_to_some(discretization.communicator(), outgoing))
      for (const auto &[node, row] : parts)
        for (const auto &[partner, value] : row)
          result[node][partner] += value;
    return result;
  }


  template class MortarCoupling<2>;
  template class MortarCoupling<3>;
} // namespace signorini
