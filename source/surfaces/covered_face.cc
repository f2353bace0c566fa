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
    /** Add factor times the shape functions of a face at a point to the nodes that move it. */
    template <int dim, typename Target>
    void for_each_node(const SurfaceFace<dim> &face, const Point<dim - 1> &xi, const Target &target)
    {
      const auto values = face.shape_values(xi);
      for (unsigned int v = 0; v < face.n_vertices; ++v)
        for (const auto &[node, weight] : face.nodes[v])
          target(node, weight * values[v]);
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
  Eigen::VectorXd CoveredFace<dim>::values_at(const Point<dim - 1> &xi) const
  {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(nodes.size());
    for_each_node<dim>(*slave, xi, [&](const types::global_dof_index node, const double value) {
      values[std::find(nodes.begin(), nodes.end(), node) - nodes.begin()] += value;
    });
    return values;
  }


  template <int dim>
  void CoveredFace<dim>::add(const SegmentPoint<dim> &point,
                             const double             weight,
                             const SurfaceFace<dim>  &master,
                             const Tensor<1, dim>    &normal,
                             const Tensor<1, dim>    &opposite_normal)
  {
    const Eigen::VectorXd values = values_at(point.slave);
    const Tensor<1, dim>  apart  = master.position(point.master) - slave->position(point.slave);
    mass += weight * values * values.transpose();
    for (unsigned int c = 0; c < dim; ++c)
      {
        normals.col(c) += weight * normal[c] * values;
        opposite.col(c) += weight * opposite_normal[c] * values;
        distance.col(c) += weight * apart[c] * values;
      }
    for_each_node<dim>(
      master, point.master, [&](const types::global_dof_index node, const double value) {
        const auto entry = mixed.emplace(node, Eigen::VectorXd::Zero(nodes.size())).first;
        entry->second += weight * value * values;
      });
  }


  template struct CoveredFace<2>;
  template struct CoveredFace<3>;
} // namespace signorini
