// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/contact/mortar_coupling.h>
#include <signorini/surfaces/contact_frame.h>
#include <signorini/surfaces/dual_basis.h>
#include <signorini/surfaces/nodal_face.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    // A node of which so little is covered (on the faces that are covered at all) would
    // extrapolate.
    constexpr double smallest_covered_node = 2e-2;
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


    /** To a row that is ascending. */
    void add_to(NodeWeights &row, const types::global_dof_index node, const double value)
    {
      if (row.empty())
        row.reserve(16); // as many as where both surfaces have equal quadrilaterals
      const auto entry =
        std::lower_bound(row.begin(), row.end(), node, [](const auto &known, const auto other) {
          return known.first < other;
        });
      if (entry != row.end() && entry->first == node)
        entry->second += value;
      else
        row.insert(entry, {node, value});
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
                     CoveredSurface<dim>(facing_surfaces(discretization, pairs[pair]),
                                         discretization.communicator(),
                                         SearchRules<dim>()),
                     MortarRules())
  {
  }


  template <int dim>
  MortarCoupling<dim>::MortarCoupling(const Discretization<dim>          &discretization,
                                      const DirichletConditions<dim>     &dirichlet,
                                      const std::vector<PairDescription> &pairs,
                                      const unsigned int                  pair,
                                      const CoveredSurface<dim>          &surface,
                                      const MortarRules                  &rules)
    : discretization(discretization)
    , pair(pair)
    , pair_name(pairs[pair].name)
    , rules(rules)
    , weights(surface.weights_of_normals())
    , total_area(surface.area())
    , total_covered_area(surface.covered_area())
    , any_segment(surface.any())
  {
    Vector carries = choose_multipliers(surface.faces(), dirichlet);
    do
      assemble_rows(surface.faces(), carries);
    while (drop_what_transmits_little(carries));
  }


  template <int dim>
  unsigned int MortarCoupling<dim>::local_node(const types::global_dof_index node) const
  {
    return discretization.matrices().pattern.partitioner->global_to_local(dim * node) / dim;
  }


  template <int dim>
  typename MortarCoupling<dim>::NodeIntegrals
  MortarCoupling<dim>::collect(const std::vector<CoveredFace<dim>> &faces) const
  {
    NodeIntegrals sums;
    for (Vector *vector :
         {&sums.covered, &sums.full, &sums.normals, &sums.opposite, &sums.clearance})
      vector->reinit(discretization.matrices().pattern.partitioner);
    for (unsigned int i = 0; i < dim * discretization.matrices().pattern.n_local; ++i)
      sums.clearance.local_element(i) = std::numeric_limits<double>::max();
    for (const CoveredFace<dim> &face : faces)
      for (int v = 0; v < face.n_vertices; ++v)
        for (const auto &[node, weight] : face.slave->nodes[v])
          {
            const unsigned int first = dim * local_node(node);
            sums.covered.local_element(first) += weight * face.mass.row(v).sum();
            sums.full.local_element(first) += weight * face.full[v];
            double &clearance = sums.clearance.local_element(first);
            clearance         = std::min(clearance, face.clearance);
            for (unsigned int c = 0; c < dim; ++c)
              {
                sums.normals.local_element(first + c) += weight * face.normals(v, c);
                sums.opposite.local_element(first + c) += weight * face.opposite(v, c);
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
    turn                = Utilities::MPI::max(turn, communicator);
    carries.update_ghost_values();
    return carries;
  }


  template <int dim>
  void MortarCoupling<dim>::add_rows(const CoveredFace<dim> &face,
                                     const Vector           &carries,
                                     Rows                   &rows,
                                     Vector                 &integrals,
                                     Vector                 &distance) const
  {
    const auto carries_one = [&](const auto node) {
      return carries.local_element(dim * local_node(node)) > 0.;
    };
    const auto add_row = [&](const unsigned int node, const auto &psi, const double integral) {
      for (const auto &[partner, product] : face.mixed)
        {
          double value = 0.;
          for (int v = 0; v < face.n_vertices; ++v)
            value += psi[v] * product[v];
          add_to(rows[node], partner, value);
        }
      integrals.local_element(dim * node) += integral;
      for (unsigned int c = 0; c < dim; ++c)
        for (int v = 0; v < face.n_vertices; ++v)
          distance.local_element(dim * node + c) += psi[v] * face.distance(v, c);
    };

    const auto &vertices = face.slave->nodes;
    if (is_plain(*face.slave) && std::all_of(vertices.begin(), vertices.end(), [&](const auto &w) {
          return carries_one(w[0].first);
        }))
      {
        const auto psi       = dual_basis(face.mass);
        const auto integrals = (psi * face.mass).rowwise().sum().eval();
        for (int i = 0; i < face.n_vertices; ++i)
          add_row(local_node(vertices[i][0].first), psi.row(i), integrals[i]);
        return;
      }
    const NodalFace<dim> nodal(face);
    std::vector<bool>    face_carries;
    for (const auto node : nodal.nodes)
      face_carries.push_back(carries_one(node));
    if (std::find(face_carries.begin(), face_carries.end(), true) == face_carries.end())
      return;
    const Eigen::MatrixXd psi           = dual_basis(nodal.mass, face_carries);
    const Eigen::MatrixXd slave_product = psi * nodal.mass, at_vertices = psi * nodal.of_vertices;
    for (std::size_t i = 0; i < nodal.nodes.size(); ++i)
      if (face_carries[i])
        {
          const unsigned int node = local_node(nodal.nodes[i]);
          add_row(node, at_vertices.row(i), slave_product.row(i).sum());
          for (std::size_t k = 0; k < nodal.nodes.size(); ++k)
            if (!face_carries[k])
              add_to(rows[node], nodal.nodes[k], -slave_product(i, k));
        }
  }


  template <int dim>
  void MortarCoupling<dim>::assemble_rows(const std::vector<CoveredFace<dim>> &faces,
                                          const Vector                        &carries)
  {
    const NodePattern &pattern = discretization.matrices().pattern;
    Rows               rows(pattern.n_local);
    Vector             integrals(pattern.partitioner), distance(pattern.partitioner);
    for (const CoveredFace<dim> &face : faces)
      add_rows(face, carries, rows, integrals, distance);
    integrals.compress(VectorOperation::add);
    distance.compress(VectorOperation::add);
    send_to_owners(rows);

    for (ContactNode<dim> &contact_node : contact_nodes)
      {
        contact_node.partners = std::move(rows[contact_node.node]);
        auto kept             = contact_node.partners.begin();
        for (const auto &[partner, value] : contact_node.partners)
          if (std::abs(value) > 1e-14 * contact_node.weight)
            *kept++ = {partner, value / contact_node.weight};
        contact_node.partners.erase(kept, contact_node.partners.end());
        contact_node.transmission =
          integrals.local_element(dim * contact_node.node) / contact_node.weight;
        contact_node.gap = contact_node.normal() * NodeIntegrals::at(distance, contact_node.node)
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
    const auto kept = std::remove_if(contact_nodes.begin(), contact_nodes.end(), little);
    std::vector<unsigned int> numbers{static_cast<unsigned int>(kept - contact_nodes.begin()),
                                      static_cast<unsigned int>(contact_nodes.end() - kept)};
    contact_nodes.erase(kept, contact_nodes.end());
    Utilities::MPI::sum(numbers, discretization.communicator(), numbers);
    n_global = numbers[0];
    if (numbers[1] > 0)
      carries.update_ghost_values();
    return numbers[1] > 0;
  }


  template <int dim>
  void MortarCoupling<dim>::send_to_owners(Rows &rows) const
  {
    if (Utilities::MPI::n_mpi_processes(discretization.communicator()) == 1)
      return;
    const auto        &partitioner = *discretization.matrices().pattern.partitioner;
    const unsigned int n_owned     = discretization.matrices().pattern.n_owned;
    const auto         global_node = [&](const unsigned int node) {
      return partitioner.local_to_global(dim * node) / dim;
    };
    IndexSet strangers(partitioner.size());
    for (unsigned int node = n_owned; node < rows.size(); ++node)
      if (!rows[node].empty())
        strangers.add_index(dim * global_node(node));
    const auto owners = Utilities::MPI::compute_index_owner(
      discretization.locally_owned(), strangers, discretization.communicator());

    std::map<unsigned int, std::vector<std::pair<types::global_dof_index, NodeWeights>>> outgoing;
    for (unsigned int node = n_owned; node < rows.size(); ++node)
      if (!rows[node].empty())
        outgoing[owners[strangers.index_within_set(dim * global_node(node))]].emplace_back(
          global_node(node), std::move(rows[node]));
    for (const auto &[rank, parts] :
         Utilities::MPI::some_to_some(discretization.communicator(), outgoing))
      for (const auto &[node, row] : parts)
        for (const auto &[partner, value] : row)
          add_to(rows[local_node(node)], partner, value);
  }


  template class MortarCoupling<2>;
  template class MortarCoupling<3>;
} // namespace signorini
