// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/covered_face.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using OfVertices = Eigen::Matrix<double, SurfaceFace<dim>::n_vertices, 1>;

    template <int dim>
    OfVertices<dim> shape_values(const Point<dim - 1> &xi)
    {
      return OfVertices<dim>(SurfaceFace<dim>::shape_values(xi).data());
    }

    template <int dim>
    Eigen::Matrix<double, 1, dim> row(const Tensor<1, dim> &x)
    {
      return Eigen::Map<const Eigen::Matrix<double, 1, dim>>(x.begin_raw());
    }
  } // namespace


  template <int dim>
  CoveredFace<dim>::CoveredFace(const SurfaceFace<dim> &slave)
    : slave(&slave)
  {
    for (const NodeWeights &weights : slave.nodes)
      for (const auto &[node, weight] : weights)
        if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
          nodes.push_back(node);
    const Eigen::Index n = nodes.size();
    of_vertices          = Eigen::MatrixXd::Zero(n, slave.n_vertices);
    for (unsigned int v = 0; v < slave.n_vertices; ++v)
      for (const auto &[node, weight] : slave.nodes[v])
        of_vertices(std::find(nodes.begin(), nodes.end(), node) - nodes.begin(), v) += weight;

    static const QGauss<dim - 1> quadrature(3);
    OfVertices<dim>              integrals = OfVertices<dim>::Zero();
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      integrals += quadrature.weight(q) * slave.area_vector(quadrature.point(q)).norm()
                   * shape_values<dim>(quadrature.point(q));
    full     = of_vertices * integrals;
    mass     = Eigen::MatrixXd::Zero(n, n);
    normals  = Eigen::MatrixXd::Zero(n, dim);
    opposite = normals;
    distance = normals;
  }


  template <int dim>
  void CoveredFace<dim>::add(const Segment<dim>     &segment,
                             const SurfaceFace<dim> &master,
                             const FacingWeight     &facing)
  {
    constexpr int                                 n_vertices = SurfaceFace<dim>::n_vertices;
    Eigen::Matrix<double, n_vertices, n_vertices> slave_slave, slave_master;
    Eigen::Matrix<double, n_vertices, dim>        normal, opposite_normal, apart;
    for (auto *sum : {&slave_slave, &slave_master})
      sum->setZero();
    for (auto *sum : {&normal, &opposite_normal, &apart})
      sum->setZero();
    for (const SegmentPoint<dim> &point : segment.points)
      {
        const double weight =
          facing ? facing(-(point.normal * point.opposite)) * point.weight : point.weight;
        const OfVertices<dim> values = shape_values<dim>(point.slave), weighted = weight * values;
        slave_slave += weighted * values.transpose();
        slave_master += weighted * shape_values<dim>(point.master).transpose();
        normal += weighted * row(point.normal);
        opposite_normal += weighted * row(point.opposite);
        apart += weighted * row(point.apart);
      }
    mass += of_vertices * slave_slave * of_vertices.transpose();
    normals += of_vertices * normal;
    opposite += of_vertices * opposite_normal;
    distance += of_vertices * apart;
    const Eigen::MatrixXd nodes_master = of_vertices * slave_master;
    for (unsigned int v = 0; v < master.n_vertices; ++v)
      for (const auto &[node, weight] : master.nodes[v])
        {
          const auto entry = mixed.emplace(node, Eigen::VectorXd::Zero(nodes.size())).first;
          entry->second += weight * nodes_master.col(v);
        }
    clearance = std::min(clearance, segment.smallest_gap);
  }


  template struct CoveredFace<2>;
  template struct CoveredFace<3>;
} // namespace signorini
