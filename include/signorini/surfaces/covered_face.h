// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_covered_face_h
#define signorini_surfaces_covered_face_h

#include <signorini/surfaces/face_segments.h>

#include <Eigen/Core>

#include <map>

namespace signorini
{
  /** Integrals over the covered part of a slave face; one row per node that moves the face. */
  template <int dim>
  struct CoveredFace
  {
    /** Nodes and full integrals; nothing is covered yet. The face must outlive this. */
    explicit CoveredFace(const SurfaceFace<dim> &slave);

    /** N_i of all nodes at a point of the face. */
    Eigen::VectorXd values_at(const dealii::Point<dim - 1> &xi) const;

    /**
     * Add a point of a segment to the integrals.
     * @param weight of the point, times the surface element
     * @param normal, opposite of slave and master, unit vectors out of the bodies
     */
    void add(const SegmentPoint<dim>      &point,
             double                        weight,
             const SurfaceFace<dim>       &master,
             const dealii::Tensor<1, dim> &normal,
             const dealii::Tensor<1, dim> &opposite);

    const SurfaceFace<dim>                      *slave;
    std::vector<dealii::types::global_dof_index> nodes;
    Eigen::MatrixXd                              mass; ///< int N_i N_j
    std::map<dealii::types::global_dof_index, Eigen::VectorXd>
                    mixed;          ///< per master node l: int N_i N_l(chi)
    Eigen::MatrixXd normals;        ///< int N_i nu, dim columns
    Eigen::MatrixXd opposite;       ///< int N_i n(chi), dim columns
    Eigen::MatrixXd distance;       ///< int N_i (X(chi) - X), dim columns
    Eigen::VectorXd full;           ///< int N_i over the whole face
    double          clearance = 0.; ///< smallest distance to the master
  };
} // namespace signorini

#endif
