// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Where the inverse of the mass is small. What arrives at a node from another one must not be more
// than the estimate says, by more than a constant factor; and not so much less that a neighbourhood
// would be far too large: on bricks the estimate is about exact along each axis, as M^-1 is then a
// product of inverses in one dimension, which decay by 2 - 3^(1/2) per cell.

#include "../contact/contact_scene.h"

#include <signorini/mass/mass_solver.h>
#include <signorini/preconditioners/reach_of_forces.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  struct Reach
  {
    double most_over_estimate = 0.; ///< of arrivals, where they are not round-off
    double least_estimate     = 1.; ///< of nodes with at least 1e-9
    double share              = 0.; ///< of nodes where the estimate is above 1e-9
  };

  /** Of a force at the nodes close to a corner. */
  template <int dim>
  Reach<dim> reach_from_corner(const Assembled<dim> &body)
  {
    const auto               &matrices = body.discretization.matrices();
    const NodePattern        &pattern  = matrices.pattern;
    Vector                    force    = body.discretization.make_vector();
    std::vector<unsigned int> origins;
    const std::string         close =
      dim == 2 ? "(x < 0.01) * (y < 0.01)" : "(x < 0.01)*(y < 0.01)*(z < 0.01)";
    std::array<std::string, dim> expressions;
    expressions.fill("0");
    expressions[0]      = close;
    const Vector marked = field<dim>(body.discretization, expressions);
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (marked.local_element(dim * node) > 0.5)
        {
          origins.push_back(node);
          force.local_element(dim * node) = 1.;
        }
    const std::vector<double> estimate = reach_of_forces(matrices, origins, 1e-12);
    const Vector              u        = MassSolver<dim>(matrices, {}).solve(force);
    const auto                size     = [&](const unsigned int node) {
      return std::abs(u.local_element(dim * node))
             * std::sqrt(matrices.mass[pattern.row_start[node]]);
    };
    double at_origin = 0.;
    for (const unsigned int node : origins)
      at_origin = std::max(at_origin, size(node));
    at_origin = dealii::Utilities::MPI::max(at_origin, MPI_COMM_WORLD);

    Reach<dim> result;
    double     n_reached = 0., n_nodes = 0.;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (!pattern.is_empty(node))
        {
          const double arrives = size(node) / at_origin;
          n_nodes += 1.;
          n_reached += estimate[node] > 1e-9;
          if (arrives > 1e-9)
            {
              result.most_over_estimate =
                std::max(result.most_over_estimate, arrives / std::max(estimate[node], 1e-30));
              result.least_estimate = std::min(result.least_estimate, estimate[node]);
            }
        }
    result.most_over_estimate =
      dealii::Utilities::MPI::max(result.most_over_estimate, MPI_COMM_WORLD);
    result.least_estimate = dealii::Utilities::MPI::min(result.least_estimate, MPI_COMM_WORLD);
    result.share          = dealii::Utilities::MPI::sum(n_reached, MPI_COMM_WORLD)
                   / dealii::Utilities::MPI::sum(n_nodes, MPI_COMM_WORLD);
    return result;
  }

  template <int dim>
  BodyDescription<dim> bricks(const unsigned int cells)
  {
    BodyDescription<dim> body = box<dim>();
    for (unsigned int d = 0; d < dim; ++d)
      {
        box_of(body).lower_corner[d] = 0.;
        box_of(body).upper_corner[d] = 1.;
        box_of(body).repetitions[d]  = cells;
      }
    body.refinements = 0;
    return body;
  }

  template <int dim>
  void expect_decay(const unsigned int cells)
  {
    const auto reach = reach_from_corner<dim>(Assembled<dim>(scene_of<dim>({bricks<dim>(cells)})));
    EXPECT_LT(reach.most_over_estimate, 5.) << dim;
    EXPECT_GT(reach.least_estimate, 1e-11) << dim;
    EXPECT_LT(reach.share, 0.7) << dim;
    EXPECT_GT(reach.share, 0.01) << dim;
  }
} // namespace

TEST(ReachOfForces, DecaysWithTheInverse)
{
  expect_decay<2>(32);
  expect_decay<3>(12);
}

TEST(ReachOfForces, GoesThroughCellsOfDifferentSize)
{
  for (const char *where : {"0.3 - x", "x - 0.3", "0.1 - (x - 0.5)^2"})
    {
      BodyDescription<2> body = bricks<2>(12);
      body.local_refinements  = 2;
      body.refine_where       = where;
      const auto reach        = reach_from_corner<2>(Assembled<2>(scene_of<2>({body})));
      EXPECT_LT(reach.most_over_estimate, 30.) << where;
      EXPECT_GT(reach.least_estimate, 1e-12) << where;
    }
}
