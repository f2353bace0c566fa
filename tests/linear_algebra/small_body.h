// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_small_body_h
#define signorini_tests_small_body_h

// Small elastic bodies with their matrices, and dense copies of linear maps to compare with.

#include "../shapes/shape_of.h"

#include <signorini/discretization/discretization.h>
#include <signorini/scene/scene.h>

#include <Eigen/Dense>

#include <functional>

namespace signorini
{
  /**
   * Boxes [0,2] x [0,1]^(dim-1), side by side; where x < 1 perhaps refined once more, so that
   * there are hanging nodes.
   */
  template <int dim>
  Scene<dim> make_boxes(const unsigned int n_bodies,
                        const unsigned int refinements,
                        const bool         hanging_nodes = false)
  {
    Scene<dim> scene;
    for (unsigned int b = 0; b < n_bodies; ++b)
      {
        BodyDescription<dim> body;
        box_of(body).lower_corner[0] = 3. * b;
        box_of(body).upper_corner[0] = 3. * b + 2.;
        body.refinements             = refinements;
        body.local_refinements       = hanging_nodes;
        body.refine_where            = "1 - x";
        body.material.youngs_modulus = 3.;
        body.material.poissons_ratio = 0.3;
        body.material.density        = 2.;
        scene.bodies.push_back(body);
      }
    return scene;
  }

  /** A scene and its matrices. */
  template <int dim>
  struct SmallBody
  {
    SmallBody(const Scene<dim> &boxes, const MPI_Comm communicator)
      : scene(boxes)
      , mesh(scene.bodies, communicator, scene.mapping)
      , discretization(mesh)
      , matrices(discretization.matrices())
    {
      if (scene.time.mass.kind == MassKind::lumped)
        discretization.matrices().lump_mass();
    }

    const Scene<dim>            scene;
    const Mesh<dim>             mesh;
    Discretization<dim>         discretization;
    const ElasticMatrices<dim> &matrices;

    /** Nodal values of a field, zero in hanging nodes. */
    Vector field(const std::array<std::string, dim> &expressions) const
    {
      return discretization.interpolate(
        std::vector<std::array<std::string, dim>>(scene.bodies.size(), expressions));
    }

    /** Some vector without symmetry, zero in hanging nodes; the same on any number of processes. */
    Vector some_vector(const double phase) const
    {
      std::array<std::string, dim> expressions;
      for (unsigned int c = 0; c < dim; ++c)
        expressions[c] = "sin(" + std::to_string(3 + c) + "*x + 5*y + " + std::to_string(phase)
                         + ")" + (dim == 3 ? " + cos(4*z)" : "");
      return field(expressions);
    }

    bool is_hanging(const unsigned int local_node) const
    {
      return matrices.pattern.row_start[local_node] == matrices.pattern.row_start[local_node + 1];
    }
  };

  /** The matrix of a linear map (one process). */
  inline Eigen::MatrixXd dense(const std::function<void(Vector &, const Vector &)> &map,
                               const Vector                                        &like)
  {
    const unsigned int n = like.size();
    Eigen::MatrixXd    matrix(n, n);
    Vector             unit(like), column(like);
    for (unsigned int j = 0; j < n; ++j)
      {
        unit    = 0.;
        unit(j) = 1.;
        map(column, unit);
        for (unsigned int i = 0; i < n; ++i)
          matrix(i, j) = column(i);
      }
    return matrix;
  }
} // namespace signorini

#endif
