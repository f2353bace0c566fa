// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_held_nodes_h
#define signorini_tests_held_nodes_h

// Nodes held along directions that do not follow the axes, and the exact answers for them.

#include <signorini/linear_algebra/incomplete_cholesky.h>

#include <Eigen/Geometry>

#include "small_body.h"

namespace signorini
{
  /** A node held in some entries of a frame that is turned by an angle. */
  template <int dim>
  HeldNode<dim> held_in_turned_frame(const unsigned int           node,
                                     const double                 angle,
                                     const std::array<bool, dim> &held)
  {
    Eigen::Matrix<double, dim, dim, Eigen::RowMajor> frame;
    if constexpr (dim == 2)
      frame = Eigen::Rotation2Dd(angle).toRotationMatrix();
    else
      frame =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(1., 2., -1.).normalized()).toRotationMatrix();
    HeldNode<dim> result{node, {}, held};
    std::copy(frame.data(), frame.data() + dim * dim, result.frame.begin());
    return result;
  }

  /** Along the first entry of the frame only. */
  template <int dim>
  std::array<bool, dim> first_direction()
  {
    std::array<bool, dim> held{};
    held[0] = true;
    return held;
  }

  template <int dim>
  std::array<bool, dim> all_directions()
  {
    std::array<bool, dim> held{};
    held.fill(true);
    return held;
  }

  /** The nodes of the face x = 0, held in part in turned frames; ghosts included. */
  template <int dim>
  HeldNodes<dim> hold_face(const SmallBody<dim> &body)
  {
    HeldNodes<dim> held;
    for (unsigned int node = 0; node < body.matrices.pattern.n_local; ++node)
      if (const auto &position = body.discretization.node_positions()[node];
          std::abs(position[0]) < 1e-12 && !body.is_hanging(node))
        {
          const bool all = position[1] > 0.9;
          held.push_back(held_in_turned_frame<dim>(
            node, 0.4 + position[1], all ? all_directions<dim>() : first_direction<dim>()));
        }
    return held;
  }

  /** Without its components in the held directions. */
  template <int dim>
  Vector free_part(const HeldNodes<dim> &held, const unsigned int n_owned, Vector vector)
  {
    for (const HeldNode<dim> &node : held)
      for (unsigned int c = 0; c < dim; ++c)
        if (node.held[c] && node.node < n_owned)
          {
            double component = 0.;
            for (unsigned int d = 0; d < dim; ++d)
              component += node.frame[dim * c + d] * vector.local_element(dim * node.node + d);
            for (unsigned int d = 0; d < dim; ++d)
              vector.local_element(dim * node.node + d) -= component * node.frame[dim * c + d];
          }
    return vector;
  }

  /** Z (Z'KZ)^-1 Z', the columns of Z spanning what is free. */
  template <int dim>
  Eigen::MatrixXd inverse_on_free_directions(const Eigen::MatrixXd &K, const HeldNodes<dim> &held)
  {
    Eigen::MatrixXd   basis = Eigen::MatrixXd::Identity(K.rows(), K.cols()); // orthonormal columns
    std::vector<char> is_held(K.rows(), 0);
    for (const HeldNode<dim> &node : held)
      for (int c = 0; c < dim; ++c)
        {
          is_held[dim * node.node + c] = node.held[c];
          for (int d = 0; d < dim; ++d)
            basis(dim * node.node + d, dim * node.node + c) = node.frame[dim * c + d];
        }
    std::vector<int> free;
    for (int i = 0; i < K.rows(); ++i)
      if (!is_held[i])
        free.push_back(i);
    const Eigen::MatrixXd Z = basis(Eigen::all, free);
    return Z * (Z.transpose() * K * Z).inverse() * Z.transpose();
  }
} // namespace signorini

#endif
