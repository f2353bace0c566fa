// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/contact/contact_frame.h>
#include <signorini/contact/dual_basis.h>
#include <signorini/contact/mean_curvature.h>
#include <signorini/contact/mortar_coupling.h>

#include <deal.II/base/quadrature_lib.h>

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

    template <int dim>
    Tensor<1, dim> unit(const Tensor<1, dim> &vector)
    {
      return vector / vector.norm();
    }


    /** Add factor times the shape functions of a face at a point to the nodes that move it. */
    template <int dim, typename Target>
    void for_each_node(const SurfaceFace<dim> &face, const Point<dim - 1> &xi, const Target &target)
    {
      const auto values = face.shape_values(xi);
      for (unsigned int v = 0; v < face.n_vertices; ++v)
        for (const auto &[node, weight] : face.nodes[v])
          target(node, weight * values[v]);
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
    : discretization(discretization)
    , pair(pair)
    , pair_name(pairs[pair].name)
  {
    const auto surfaces = find_facing_surfaces(discretization, pairs[pair]);
    const auto faces    = integrate(surfaces);
    const auto carries  = choose_multipliers(faces, dirichlet);
    assemble_rows(faces, carries);
  }


  template <int dim>
  MortarCoupling<dim>::CoveredFace::CoveredFace(const SurfaceFace<dim> &slave)
    : slave(&slave)
  {
    for (const NodeWeights &weights : slave.nodes)
      for (const auto &[node, weight] : weights)
        if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
          nodes.push_back(node);
    const Eigen::Index    n = nodes.size();
    const QGauss<dim - 1> quadrature(3);
    full = Eigen::VectorXd::Zero(n);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      full += quadrature.weight(q) * slave.area_vector(quadrature.point(q)).norm()
              * values_at(quadrature.point(q));
    mass     = Eigen::MatrixXd::Zero(n, n);
    normals  = Eigen::MatrixXd::Zero(n, dim);
    opposite = normals;
    distance = normals;
  }


  template <int dim>
  Eigen::VectorXd MortarCoupling<dim>::CoveredFace::values_at(const Point<dim - 1> &xi) const
  {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(nodes.size());
    for_each_node<dim>(*slave, xi, [&](const types::global_dof_index node, const double value) {
      values[std::find(nodes.begin(), nodes.end(), node) - nodes.begin()] += value;
    });
    return values;
  }


  template <int dim>
  void MortarCoupling<dim>::CoveredFace::add(const SegmentPoint<dim> &point,
                                             const SurfaceFace<dim>  &master,
                                             const Tensor<1, dim>    &normal,
                                             const Tensor<1, dim>    &opposite_normal)
  {
    const Eigen::VectorXd values = values_at(point.slave);
    const Tensor<1, dim>  apart  = master.position(point.master) - slave->position(point.slave);
    mass += point.weight * values * values.transpose();
    for (unsigned int c = 0; c < dim; ++c)
      {
        normals.col(c) += point.weight * normal[c] * values;
        opposite.col(c) += point.weight * opposite_normal[c] * values;
        distance.col(c) += point.weight * apart[c] * values;
      }
    for_each_node<dim>(
      master, point.master, [&](const types::global_dof_index node, const double value) {
        const auto entry = mixed.emplace(node, Eigen::VectorXd::Zero(nodes.size())).first;
        entry->second += point.weight * value * values;
      });
  }


  template <int dim>
  std::vector<typename MortarCoupling<dim>::CoveredFace>
  MortarCoupling<dim>::integrate(const FacingSurfaces<dim> &surfaces)
  {
    MeanCurvature<dim>       slave_curvature, master_curvature;
    std::vector<CoveredFace> result;
    for (std::size_t f = 0; f < surfaces.slaves.size(); ++f)
      {
        const SurfaceFace<dim> &slave = surfaces.slaves[f];
        CoveredFace             face(slave);
        total_area += face.full.sum();

        double covered = 0.;
        for (const Segment<dim> &segment : surfaces.segments[f])
          covered += segment.area;
        any_segment = any_segment || covered > 0.;
        if (covered < smallest_covered_face * projected_area(slave))
          continue;

        face.clearance = std::numeric_limits<double>::max();
        for (const Segment<dim> &segment : surfaces.segments[f])
          face.clearance = std::min(face.clearance, segment.smallest_gap);
        for (const Segment<dim> &segment : surfaces.segments[f])
          for (const SegmentPoint<dim> &point : segment.points)
            {
              const SurfaceFace<dim> &master   = surfaces.masters[segment.master];
              const Tensor<1, dim>    normal   = unit(slave.area_vector(point.slave));
              const Tensor<1, dim>    opposite = unit(master.area_vector(point.master));
              slave_curvature.add(point.weight, slave.position(point.slave), normal);
              master_curvature.add(point.weight, master.position(point.master), opposite);
              face.add(point, master, normal, opposite);
            }
        total_covered_area += face.mass.sum();
        result.push_back(std::move(face));
      }
    const MPI_Comm      communicator = discretization.communicator();
    const NormalWeights weights =
      weights_of_normals(slave_curvature.value(communicator), master_curvature.value(communicator));
    for (CoveredFace &face : result)
      face.normals = weights.slave * face.normals - weights.master * face.opposite;
    any_segment = Utilities::MPI::max(static_cast<unsigned int>(any_segment), communicator) > 0;
    total_area  = Utilities::MPI::sum(total_area, communicator);
    total_covered_area = Utilities::MPI::sum(total_covered_area, communicator);
    return result;
  }


  template <int dim>
  typename MortarCoupling<dim>::NodeIntegrals
  MortarCoupling<dim>::collect(const std::vector<CoveredFace> &faces) const
  {
    NodeIntegrals sums;
    for (Vector *vector : {&sums.covered, &sums.full, &sums.normals, &sums.clearance})
      *vector = discretization.make_vector();
    for (unsigned int i = 0; i < dim * discretization.matrices().pattern.n_local; ++i)
      sums.clearance.local_element(i) = std::numeric_limits<double>::max();
    for (const CoveredFace &face : faces)
      {
        const Eigen::VectorXd integrals = face.mass.rowwise().sum();
        for (std::size_t i = 0; i < face.nodes.size(); ++i)
          {
            const auto first = dim * face.nodes[i];
            sums.covered(first) += integrals[i];
            sums.full(first) += face.full[i];
            sums.clearance(first) = std::min(sums.clearance(first), face.clearance);
            for (unsigned int c = 0; c < dim; ++c)
              sums.normals(first + c) += face.normals(i, c);
          }
      }
    for (Vector *sum : {&sums.covered, &sums.full, &sums.normals})
      sum->compress(VectorOperation::add);
    sums.clearance.compress(VectorOperation::min);
    return sums;
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
  Vector MortarCoupling<dim>::choose_multipliers(const std::vector<CoveredFace> &faces,
                                                 const DirichletConditions<dim> &dirichlet)
  {
    const NodeIntegrals sums    = collect(faces);
    Vector              carries = discretization.make_vector();
    std::string         oblique_condition;
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      {
        const double weight = sums.covered.local_element(dim * node);
        if (!(weight > smallest_covered_node * sums.full.local_element(dim * node)))
          continue;
        Tensor<1, dim> normal;
        for (unsigned int c = 0; c < dim; ++c)
          normal[c] = sums.normals.local_element(dim * node + c);
        if (!(normal.norm() > 1e-3 * weight)) // faces that look in opposite directions
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
  void MortarCoupling<dim>::assemble_rows(const std::vector<CoveredFace> &faces,
                                          const Vector                   &carries)
  {
    Rows   rows;
    Vector integrals = discretization.make_vector(), distance = integrals;
    for (const CoveredFace &face : faces)
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
