// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_covered_face_h
#define signorini_surfaces_covered_face_h

#include <signorini/surfaces/face_segments.h>

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <map>

namespace signorini
{
  /** What a pair of points that face each other counts, by the cosine of their angle. */
  using FacingWeight = std::function<double(double)>;

  /** Integrals over the covered part of a slave face; one row per node that moves the face. */
  template <int dim>
  struct CoveredFace
  {
    /** Nodes and full integrals; nothing is covered yet. The face must outlive this. */
    explicit CoveredFace(const SurfaceFace<dim> &slave);

    /** Add a segment to the integrals. @param facing null: 1 */
    void
    add(const Segment<dim> &segment, const SurfaceFace<dim> &master, const FacingWeight &facing);

    const SurfaceFace<dim>                      *slave;
    std::vector<dealii::types::global_dof_index> nodes;
    Eigen::MatrixXd                              mass; ///< int N_i N_j
    std::map<dealii::types::global_dof_index, Eigen::VectorXd>
                    mixed;                                 ///< per master node l: int N_i N_l(chi)
    Eigen::MatrixXd normals;                               ///< int N_i nu, dim columns
    Eigen::MatrixXd opposite;                              ///< int N_i n(chi), dim columns
    Eigen::MatrixXd distance;                              ///< int N_i (X(chi) - X), dim columns
    Eigen::VectorXd full;                                  ///< int N_i over the whole face
    double clearance = std::numeric_limits<double>::max(); ///< smallest distance to the master

  private:
    Eigen::MatrixXd of_vertices; ///< N_i at the vertices of the face
  };
} // namespace signorini

#endif
