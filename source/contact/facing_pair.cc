// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/facing_pair.h>
#include <signorini/contact/mortar_coupling.h>
#include <signorini/contact/node_coupling.h>
#include <signorini/contact/shift_row.h>
#include <signorini/discretization/common_boxes.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/geometry/algorithms/intersects.hpp>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Cosines of the angles at which faces begin to look at each other, and do so fully. */
    constexpr FacingWeight facing{0.2, 0.6};
    /**
     * How far faces look beyond the motion of a step, in their diameters: what begins a step
     * outside is not deep inside when it ends.
     */
    constexpr double behind = 0.1, ahead = 0.5;
    /** How deep a face looks into its own body. */
    constexpr double part_of_thickness = 0.3;


    template <int dim>
    bool share_no_node(const SurfaceFace<dim> &face, const SurfaceFace<dim> &other)
    {
      for (const VertexNodes &weights : face.nodes)
        for (const auto &[node, weight] : weights)
          for (const VertexNodes &other_weights : other.nodes)
            for (const auto &[other_node, other_weight] : other_weights)
              if (node == other_node)
                return false;
      return true;
    }


    /** Of a body that meets itself. */
    template <int dim>
    bool may_meet_itself(const SurfaceFace<dim> &slave, const SurfaceFace<dim> &master)
    {
      const Tensor<1, dim> apart  = slave.place - master.place;
      unsigned int         widest = 0;
      for (unsigned int c = 1; c < dim; ++c)
        if (std::abs(apart[c]) > std::abs(apart[widest]))
          widest = c;
      return apart[widest] > 0. && share_no_node(slave, master);
    }


    template <int dim>
    std::vector<unsigned int> owned_nodes(const std::vector<SurfaceFace<dim>> &faces,
                                          const Discretization<dim>           &discretization)
    {
      // What other processes know of an owned node's face arrives by a sum.
      Vector flags = discretization.make_vector();
      for (const SurfaceFace<dim> &face : faces)
        for (const VertexNodes &weights : face.nodes)
          for (const auto &[node, weight] : weights)
            flags(dim * node) += 1.;
      flags.compress(VectorOperation::add);
      std::vector<unsigned int> result;
      for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
        if (flags.local_element(dim * node) > 0.)
          result.push_back(node);
      return result;
    }


    template <int dim>
    Tensor<1, dim> motion_of(const unsigned int node, const Vector &motion)
    {
      Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = motion.local_element(dim * node + c);
      return result;
    }

  } // namespace


  template <int dim>
  FacingPair<dim>::FacingPair(const Discretization<dim>          &discretization,
                              const DirichletConditions<dim>     &dirichlet,
                              const std::vector<PairDescription> &pairs,
                              const unsigned int                  pair)
    : discretization(discretization)
    , dirichlet(dirichlet)
    , pairs(pairs)
    , pair(pair)
    , slaves(owned_surface_faces(discretization, pairs[pair].slave, pairs[pair].slave_boundary_ids))
    , masters(
        owned_surface_faces(discretization, pairs[pair].master, pairs[pair].master_boundary_ids))
    , owned_slave_nodes(owned_nodes(slaves, discretization))
    , owned_master_nodes(owned_nodes(masters, discretization))
  {
    measure_slave();
    for (const SurfaceFace<dim> &face : slaves)
      largest_face = std::max(largest_face, face.diameter());
    largest_face   = Utilities::MPI::max(largest_face, discretization.communicator());
    n_master_nodes = Utilities::MPI::sum(static_cast<unsigned int>(owned_master_nodes.size()),
                                         discretization.communicator());
    if (is_of_one_body())
      {
        const std::vector<double> thickness = thickness_behind_faces(masters);
        for (std::size_t f = 0; f < slaves.size(); ++f)
          slaves[f].thickness = thickness[f];
      }
  }


  template <int dim>
  std::vector<double>
  FacingPair<dim>::thickness_behind_faces(const std::vector<SurfaceFace<dim>> &others) const
  {
    std::vector<double>     thickness(slaves.size(), std::numeric_limits<double>::infinity());
    const double            size = discretization.mesh().body_size(pairs[pair].slave);
    std::vector<Sweep<dim>> sweeps;
    for (const SurfaceFace<dim> &face : slaves)
      sweeps.emplace_back(face, size, 0.);
    SearchRules<dim> rules;
    rules.rule     = SegmentRule::degree_5;
    rules.may_meet = share_no_node<dim>;
    find_opposite<dim>(slaves,
                       others,
                       sweeps,
                       discretization.communicator(),
                       rules,
                       [&](const FacedByMasters<dim> &face) {
                         double &least = thickness[face.slave];
                         for (const Segment<dim> &segment : face.segments)
                           least = std::min(least, -segment.gap);
                       });
    return thickness;
  }


  template <int dim>
  Vector FacingPair<dim>::reciprocal_thickness() const
  {
    const std::vector<double> thickness = thickness_behind_faces(slaves);
    Vector                    result    = discretization.make_vector();
    for (std::size_t f = 0; f < slaves.size(); ++f)
      for (const VertexNodes &weights : slaves[f].nodes)
        for (const auto &[node, weight] : weights)
          result(dim * node) = std::max<double>(result(dim * node), 1. / thickness[f]);
    result.compress(VectorOperation::max);
    return result;
  }


  template <int dim>
  void FacingPair<dim>::measure_slave()
  {
    Vector                area = discretization.make_vector(), outward = area;
    const QGauss<dim - 1> quadrature(3);
    for (const SurfaceFace<dim> &face : slaves)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Tensor<1, dim> surface =
            quadrature.weight(q) * face.area_vector(quadrature.point(q));
          const auto values = face.shape_values(quadrature.point(q));
          for (unsigned int v = 0; v < face.n_vertices; ++v)
            for (const auto &[node, weight] : face.nodes[v])
              {
                area(dim * node) += weight * values[v] * surface.norm();
                for (unsigned int c = 0; c < dim; ++c)
                  outward(dim * node + c) += weight * values[v] * surface[c];
              }
        }
    area.compress(VectorOperation::add);
    outward.compress(VectorOperation::add);
    bluntness.assign(discretization.matrices().pattern.n_owned, 0.);
    is_slave = discretization.make_vector();
    for (const unsigned int node : owned_slave_nodes)
      {
        is_slave.local_element(dim * node) = 1.;
        areas[node]                        = area.local_element(dim * node);
        bluntness[node] = std::max(0., 1. - motion_of<dim>(node, outward).norm() / areas[node]);
      }
  }


  template <int dim>
  double FacingPair<dim>::relative_motion(const Vector &increment) const
  {
    const MPI_Comm communicator = discretization.communicator();
    Tensor<1, dim> sum;
    for (const unsigned int node : owned_master_nodes)
      sum += motion_of<dim>(node, increment);
    const Tensor<1, dim> mean =
      Utilities::MPI::sum(sum, communicator) / static_cast<double>(n_master_nodes);
    std::vector<double> largest(2, 0.);
    for (const unsigned int node : owned_slave_nodes)
      largest[0] = std::max(largest[0], (motion_of<dim>(node, increment) - mean).norm());
    for (const unsigned int node : owned_master_nodes)
      largest[1] = std::max(largest[1], (motion_of<dim>(node, increment) - mean).norm());
    Utilities::MPI::max(largest, communicator, largest);
    return largest[0] + largest[1];
  }


  template <int dim>
  std::vector<BoundingBox<dim>> FacingPair<dim>::boxes(const Vector &displacement) const
  {
    CommonBoxes<dim> result(2);
    for (const unsigned int node : owned_slave_nodes)
      result.add(discretization.node_positions()[node] + motion_of<dim>(node, displacement), 0);
    for (const unsigned int node : owned_master_nodes)
      result.add(discretization.node_positions()[node] + motion_of<dim>(node, displacement), 1);
    return result.around_all(discretization.communicator());
  }


  template <int dim>
  std::vector<SurfaceFace<dim>>
  FacingPair<dim>::displaced(const std::vector<SurfaceFace<dim>> &faces,
                             const Vector                        &displacement,
                             const BoundingBox<dim>              &box) const
  {
    std::vector<SurfaceFace<dim>> result;
    SurfaceFace<dim>              moved;
    for (const SurfaceFace<dim> &face : faces)
      {
        moved.vertices = face.vertices;
        for (unsigned int v = 0; v < face.n_vertices; ++v)
          for (const auto &[node, weight] : face.nodes[v])
            for (unsigned int c = 0; c < dim; ++c)
              moved.vertices[v][c] += weight * displacement(dim * node + c);
        if (boost::geometry::intersects(moved.bounding_box(), box))
          {
            result.push_back(face);
            result.back().vertices = moved.vertices;
          }
      }
    return result;
  }


  template <int dim>
  double FacingPair<dim>::distance_of_boxes(const Vector &displacement) const
  {
    const auto     both  = boxes(displacement);
    const auto     slave = both[0].get_boundary_points(), master = both[1].get_boundary_points();
    Tensor<1, dim> apart;
    for (unsigned int c = 0; c < dim; ++c)
      apart[c] =
        std::max({0., master.first[c] - slave.second[c], slave.first[c] - master.second[c]});
    return apart.norm();
  }


  template <int dim>
  std::vector<ContactNode<dim>> FacingPair<dim>::at(const Vector            &displacement,
                                                    const double             reach,
                                                    const std::vector<bool> *excluded) const
  {
    const auto       both      = boxes(displacement);
    BoundingBox<dim> slave_box = both[0], master_box = both[1];
    slave_box.extend(reach + largest_face);
    master_box.extend(reach + largest_face);
    if (!boost::geometry::intersects(slave_box, master_box))
      return {};

    Vector ghosted = displacement;
    ghosted.update_ghost_values();
    FacingSurfaces<dim> surfaces;
    surfaces.slaves  = displaced(slaves, ghosted, master_box);
    surfaces.masters = displaced(masters, ghosted, slave_box);
    surfaces.sweeps.reserve(surfaces.slaves.size());
    for (const SurfaceFace<dim> &face : surfaces.slaves)
      surfaces.sweeps.emplace_back(
        face,
        std::min(reach + behind * face.diameter(), part_of_thickness * face.thickness),
        reach + ahead * face.diameter());
    SearchRules<dim> rules;
    rules.rule   = SegmentRule::degree_5;
    rules.facing = facing;
    if (is_of_one_body())
      rules.may_meet = may_meet_itself<dim>;
    std::vector<ContactNode<dim>> nodes = couple(
      CoveredSurface<dim>(std::move(surfaces), discretization.communicator(), rules), excluded);
    align(nodes, displacement);
    return nodes;
  }


  template <int dim>
  std::vector<ContactNode<dim>> FacingPair<dim>::couple(const CoveredSurface<dim> &surface,
                                                        const std::vector<bool>   *excluded) const
  {
    MortarRules rules;
    rules.bluntness                 = &bluntness;
    rules.excluded                  = excluded;
    const auto nodes_by_these_rules = [&] {
      return MortarCoupling<dim>(discretization, dirichlet, pairs, pair, surface, rules).nodes();
    };
    std::vector<ContactNode<dim>> nodes = nodes_by_these_rules();
    if (!is_of_one_body())
      return nodes;

    // A node that others follow follows none.
    std::vector<bool> followed(discretization.matrices().pattern.n_owned, false);
    if (excluded != nullptr)
      followed = *excluded;
    bool any = false;
    for (const unsigned int node :
         NodeCoupling<dim>(nodes, discretization.matrices().pattern.partitioner, true)
           .owned_partners())
      followed[node] = true;
    for (const ContactNode<dim> &node : nodes)
      any = any || followed[node.node];
    if (Utilities::MPI::max(static_cast<unsigned int>(any), discretization.communicator()) == 0)
      return nodes;
    rules.excluded = &followed;
    return nodes_by_these_rules();
  }


  template <int dim>
  void FacingPair<dim>::align(std::vector<ContactNode<dim>> &nodes,
                              const Vector                  &displacement) const
  {
    Vector positions = displacement;
    for (const auto *of_surface : {&owned_slave_nodes, &owned_master_nodes})
      for (const unsigned int node : *of_surface)
        for (unsigned int c = 0; c < dim; ++c)
          positions.local_element(dim * node + c) =
            discretization.node_positions()[node][c] + displacement.local_element(dim * node + c);
    const NodeCoupling<dim> coupling(nodes, discretization.matrices().pattern.partitioner, true);
    const auto              of_partners = coupling.partner_values(positions),
               are_slaves               = coupling.partner_values(is_slave);
    std::size_t first                   = 0;
    for (ContactNode<dim> &node : nodes)
      {
        shift_row<dim>(node,
                       motion_of<dim>(node.node, positions),
                       of_partners.data() + first,
                       are_slaves.data() + first);
        first += node.partners.size();
      }
  }


  template <int dim>
  double FacingPair<dim>::depth(const std::vector<ContactNode<dim>> &nodes)
  {
    double deepest = 0.;
    for (const ContactNode<dim> &node : nodes)
      deepest = std::max(deepest, -node.clearance);
    return deepest;
  }


  template class FacingPair<2>;
  template class FacingPair<3>;
} // namespace signorini
