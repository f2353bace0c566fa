// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_covered_face_h
#define signorini_surfaces_covered_face_h

#include <signorini/surfaces/face_segments.h>

#include <limits>

namespace signorini
{
  /** Integrals over the covered part of a slave face; one row per vertex. */
  template <int dim>
  struct CoveredFace
  {
    static constexpr int n_vertices = SurfaceFace<dim>::n_vertices;
    /** Master nodes that find room without memory of their own: those of two (four) equal faces. */
    static constexpr std::size_t most_masters = dim == 2 ? 3 : 9;

    /** Full integrals; nothing is covered yet. The face must outlive this. */
    explicit CoveredFace(const SurfaceFace<dim> &slave);

    /** Add a segment to the integrals. */
    void add(const Segment<dim> &segment, const SurfaceFace<dim> &master);

    const SurfaceFace<dim>           *slave;
    typename Segment<dim>::OfVertices mass;                ///< int N_i N_j
    typename Segment<dim>::Vectors    normals;             ///< int N_i nu
    typename Segment<dim>::Vectors    opposite;            ///< int N_i n(chi)
    typename Segment<dim>::Vectors    distance;            ///< int N_i (X(chi) - X)
    std::array<double, n_vertices>    full;                ///< int N_i over the whole face
    double clearance = std::numeric_limits<double>::max(); ///< smallest distance to the master
    /** For the master nodes l, ascending: int N_i N_l(chi). */
    boost::container::small_vector<
      std::pair<dealii::types::global_dof_index, std::array<double, n_vertices>>,
      most_masters>
      mixed;
  };
} // namespace signorini

#endif
