// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_nodal_face_h
#define signorini_surfaces_nodal_face_h

#include <signorini/surfaces/covered_face.h>

#include <algorithm>

namespace signorini
{
  /** A face in terms of its nodes, of which several may move one vertex. */
  template <int dim>
  struct NodalFace
  {
    std::vector<dealii::types::global_dof_index> nodes;
    Eigen::MatrixXd                              of_vertices; ///< N_i at the vertices
    Eigen::MatrixXd                              mass;

    explicit NodalFace(const CoveredFace<dim> &face)
    {
      for (const auto &weights : face.slave->nodes)
        for (const auto &[node, weight] : weights)
          if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
            nodes.push_back(node);
      of_vertices = Eigen::MatrixXd::Zero(nodes.size(), face.n_vertices);
      for (int v = 0; v < face.n_vertices; ++v)
        for (const auto &[node, weight] : face.slave->nodes[v])
          of_vertices(std::find(nodes.begin(), nodes.end(), node) - nodes.begin(), v) += weight;
      mass = of_vertices * face.mass * of_vertices.transpose();
    }
  };


  /** Whether each vertex is a node. */
  template <int dim>
  bool is_plain(const SurfaceFace<dim> &face)
  {
    return std::all_of(face.nodes.begin(), face.nodes.end(), [](const auto &weights) {
      return weights.size() == 1;
    });
  }
} // namespace signorini

#endif
