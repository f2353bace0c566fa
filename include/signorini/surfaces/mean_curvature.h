// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_mean_curvature_h
#define signorini_surfaces_mean_curvature_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

namespace signorini
{
  /**
   * How much a surface bends, from its normals at sample points: the spread of the normals over the
   * spread of the points (root mean squares). Of a sphere it is about 1/R, however its facets are
   * cut, of a plane zero.
   */
  template <int dim>
  class MeanCurvature
  {
  public:
    void add(double                        weight,
             const dealii::Point<dim>     &position,
             const dealii::Tensor<1, dim> &unit_normal);

    /**
     * Collective: of the samples of all processes, in 1/length; exactly 0 for a plane, and without
     * samples.
     */
    double value(MPI_Comm communicator) const;

  private:
    double                 weight  = 0.;
    double                 squares = 0.; ///< of the distances from the mean position
    dealii::Tensor<1, dim> normals;
    dealii::Tensor<1, dim> mean_position; ///< so far: sums from the origin would cancel far from it
  };


  /** What the normals of two surfaces that face each other count in their mean; the sum is 1. */
  struct NormalWeights
  {
    double slave = 0.5, master = 0.5;
  };

  /**
   * Weights in inverse proportion to the curvatures. Near the point where bodies touch the tilts of
   * their normals against the common tangent plane are curvature times distance, so that this mean
   * is the normal of that plane: of a ball on a plane it is the normal of the plane, of two balls
   * the axis through their centres. A normal that is tilted against it would turn a part of the
   * normal force into a tangential one when the bodies move past each other.
   */
  NormalWeights weights_of_normals(double slave_curvature, double master_curvature);
} // namespace signorini

#endif
