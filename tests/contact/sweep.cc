// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What a slave face may see, found in a tree: all faces that have a segment with it, in any
// direction of space; and not many more, however fine the surfaces are and however they lie.

#include "two_bodies.h"

#include <signorini/surfaces/face_segments.h>
#include <signorini/surfaces/sweep.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace signorini;
using namespace signorini::tests;
using dealii::BoundingBox;
using dealii::Point;

// Of its own: all tests of a folder are compiled as one.
namespace sweep_tests
{
  namespace
  {
    template <int dim>
    struct Search
    {
      Search(const Scene<dim> &scene, const Map<dim> &map)
        : problem(scene, map)
        , slaves(owned_surface_faces(problem.discretization, 0, scene.pairs[0].slave_boundary_ids))
      {
        for (const auto &part : dealii::Utilities::MPI::all_gather(
               MPI_COMM_WORLD,
               owned_surface_faces(problem.discretization, 1, scene.pairs[0].master_boundary_ids)))
          masters.insert(masters.end(), part.begin(), part.end());
        for (const SurfaceFace<dim> &face : masters)
          boxes.push_back(face.bounding_box());
      }

      Sweep<dim> sweep(const SurfaceFace<dim> &slave) const
      {
        return {slave, problem.mesh.bounding_box(0), problem.mesh.bounding_box(1)};
      }

      const MappedAssembled<dim>          problem;
      const std::vector<SurfaceFace<dim>> slaves;  ///< of this process
      std::vector<SurfaceFace<dim>>       masters; ///< of all
      std::vector<BoundingBox<dim>>       boxes;
    };


    /** Two plates that lie on each other, n cells along their edges. */
    template <int dim>
    Scene<dim> plates(const unsigned int n)
    {
      Point<dim>                    lower, middle, upper;
      std::array<unsigned int, dim> slave, master;
      slave.fill(n);
      master.fill(n + 1);
      slave[dim - 1] = master[dim - 1] = 1;
      for (unsigned int c = 0; c < dim; ++c)
        upper[c] = 1.;
      middle          = upper;
      middle[dim - 1] = 0.2;
      lower[dim - 1]  = 0.25;
      upper[dim - 1]  = 0.4;
      return stacked<dim>(block<dim>("upper", lower, upper, slave),
                          block<dim>("lower", Point<dim>(), middle, master));
    }


    template <int dim>
    void expect_all_with_a_segment(const Scene<dim> &scene, const Map<dim> &map)
    {
      const Search<dim> search(scene, map);
      const auto        tree       = dealii::pack_rtree_of_indices(search.boxes);
      unsigned int      n_segments = 0;
      for (const SurfaceFace<dim> &slave : search.slaves)
        {
          const Sweep<dim> sweep = search.sweep(slave);
          const auto       found = sweep.meets(tree);
          EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
          for (std::size_t m = 0; m < search.masters.size(); ++m)
            if (const Segment<dim> segment = intersect(slave, search.masters[m]);
                !segment.points.empty() && segment.gap >= -sweep.depth())
              {
                ++n_segments;
                EXPECT_TRUE(std::binary_search(found.begin(), found.end(), m));
              }
        }
      EXPECT_GT(dealii::Utilities::MPI::sum(n_segments, MPI_COMM_WORLD), 0u);
    }


    /** How many faces a search finds for a slave face, at most. */
    template <int dim>
    std::size_t most_found(const unsigned int n, const Map<dim> &map)
    {
      const Search<dim> search(plates<dim>(n), map);
      const auto        tree = dealii::pack_rtree_of_indices(search.boxes);
      std::size_t       most = 0;
      for (const SurfaceFace<dim> &slave : search.slaves)
        most = std::max(most, search.sweep(slave).meets(tree).size());
      return most;
    }
  } // namespace


  TEST(Sweep, FindsAllFacesWithASegment)
  {
    for (const double angle : {0., 0.3, 0.8, 2.1})
      {
        expect_all_with_a_segment<2>(plates<2>(9), turn<2>(angle));
        expect_all_with_a_segment<3>(plates<3>(5), turn<3>(angle));
        // All sides of balls: normals in all directions, and faces that are not plane.
        Scene<3> balls            = stacked<3>(ball<3>(2), ball<3>(1));
        balls.bodies[0].placement = Placement<3>(
          {{10., 20., 30.}}, ball_of(balls.bodies[0]).centre, dealii::Tensor<1, 3>({0.4, 0., 2.}));
        balls.pairs[0].slave_boundary_ids = balls.pairs[0].master_boundary_ids = {};
        expect_all_with_a_segment<3>(balls, turn<3>(angle));
      }
  }


  TEST(Sweep, FindsAsManyOnFineSurfacesAsOnCoarseOnes)
  {
    // Faces of equal plates meet at most nine of the other side, and their neighbours.
    for (const double angle : {0., 0.3, 0.8})
      {
        for (const unsigned int n : {10, 40, 160})
          EXPECT_LE(most_found<2>(n, turn<2>(angle)), 8u) << n << ' ' << angle;
        for (const unsigned int n : {8, 16, 32, 64})
          EXPECT_LE(most_found<3>(n, turn<3>(angle)), 50u) << n << ' ' << angle;
      }
  }
} // namespace sweep_tests
