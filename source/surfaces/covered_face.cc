// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/covered_face.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  CoveredFace<dim>::CoveredFace(const SurfaceFace<dim> &slave)
    : slave(&slave)
    , full{}
  {
    static const QGauss<dim - 1> quadrature(3);
    const auto                   parts = slave.area_vector_parts();
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        Tensor<1, dim> area = parts[0];
        for (unsigned int d = 0; d < dim - 1; ++d)
          area += quadrature.point(q)[d] * parts[d + 1];
        const double weight = quadrature.weight(q) * area.norm();
        const auto   values = slave.shape_values(quadrature.point(q));
        for (int v = 0; v < n_vertices; ++v)
          full[v] += weight * values[v];
      }
    mass.setZero();
    for (auto *sum : {&normals, &opposite, &distance})
      sum->setZero();
  }


  template <int dim>
  void CoveredFace<dim>::add(const Segment<dim> &segment, const SurfaceFace<dim> &master)
  {
    mass += segment.slave_slave;
    normals += segment.normals;
    opposite += segment.opposite;
    // From a place nearby, so that nothing cancels.
    typename Segment<dim>::Vectors from, to;
    for (int v = 0; v < n_vertices; ++v)
      for (unsigned int c = 0; c < dim; ++c)
        {
          from(v, c) = slave->vertices[v][c] - slave->vertices[0][c];
          to(v, c)   = master.vertices[v][c] - slave->vertices[0][c];
        }
    distance += segment.slave_master * to - segment.slave_slave * from;
    for (int v = 0; v < n_vertices; ++v)
      for (const auto &[node, weight] : master.nodes[v])
        {
          auto entry = std::lower_bound(
            mixed.begin(), mixed.end(), node, [](const auto &known, const auto other) {
              return known.first < other;
            });
          if (entry == mixed.end() || entry->first != node)
            entry = mixed.insert(entry, {node, {}});
          for (int i = 0; i < n_vertices; ++i)
            entry->second[i] += weight * segment.slave_master(i, v);
        }
    clearance = std::min(clearance, segment.smallest_gap);
  }


  template struct CoveredFace<2>;
  template struct CoveredFace<3>;
} // namespace signorini
