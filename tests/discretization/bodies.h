// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_discretization_bodies_h
#define signorini_tests_discretization_bodies_h

#include "../shapes/shape_of.h"

#include <signorini/discretization/discretization.h>
#include <signorini/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>

namespace signorini::tests
{
  /** Corners (0, ..., 0) and (upper, ..., upper), two cells per direction. */
  template <int dim>
  BodyDescription<dim> box(const double upper = 1.)
  {
    BodyDescription<dim> body;
    body.name = "box";
    box_of(body).upper_corner *= upper;
    box_of(body).repetitions.fill(2);
    body.material = {500., 0.3, 2.};
    return body;
  }

  /**
   * A box some cells of which are finer by one or two levels, so that it has hanging nodes inside
   * and on faces.
   */
  template <int dim>
  BodyDescription<dim> box_with_hanging_nodes()
  {
    BodyDescription<dim> body = box<dim>();
    body.local_refinements    = 2;
    body.refine_where         = "0.6 - x - y";
    return body;
  }

  /** Radius 1, on the plane where the last coordinate is zero. */
  template <int dim>
  BodyDescription<dim> ball(const unsigned int refinements)
  {
    BodyDescription<dim> body;
    body.name                     = "ball";
    ball_of(body).centre[dim - 1] = 1.;
    body.refinements              = refinements;
    body.material                 = {500., 0.3, 2.};
    return body;
  }

  template <int dim>
  Scene<dim> scene_of(const std::vector<BodyDescription<dim>> &bodies)
  {
    Scene<dim> scene;
    scene.file_name      = "test.prm";
    scene.time.step_size = 1e-2;
    scene.time.end_time  = 1.;
    scene.bodies         = bodies;
    return scene;
  }

  /** A scene and its assembled discretisation. */
  template <int dim>
  struct Assembled
  {
    explicit Assembled(const Scene<dim> &scene)
      : scene(scene)
      , mesh(scene.bodies, MPI_COMM_WORLD, scene.mapping)
      , discretization(mesh)
    {
      if (scene.time.mass.kind == MassKind::lumped)
        discretization.matrices().lump_mass();
    }
    explicit Assembled(const BodyDescription<dim> &body)
      : Assembled(scene_of<dim>({body}))
    {
    }

    const Scene<dim>    scene;
    Mesh<dim>           mesh;
    Discretization<dim> discretization;
  };

  /** The same expressions for each body. */
  template <int dim>
  Vector field(const Discretization<dim>          &discretization,
               const std::array<std::string, dim> &expressions)
  {
    return discretization.interpolate(std::vector<std::array<std::string, dim>>(
      discretization.mesh().bodies().size(), expressions));
  }

  template <int dim>
  Vector ones(const Discretization<dim> &discretization)
  {
    std::array<std::string, dim> expressions;
    expressions.fill("1");
    return field<dim>(discretization, expressions);
  }

  /** A field without any symmetry; zero at hanging nodes. */
  template <int dim>
  Vector irregular_field(const Discretization<dim> &discretization, const double frequency)
  {
    const std::string            f = std::to_string(frequency);
    std::array<std::string, dim> expressions;
    for (unsigned int c = 0; c < dim; ++c)
      expressions[c] =
        "sin(" + f + "*x + " + std::to_string(c) + ") + cos(" + f + "*(y + 0.3*x*y)) + x*x";
    return field<dim>(discretization, expressions);
  }

  template <int dim>
  Vector mass_times(const Discretization<dim> &discretization, const Vector &vector)
  {
    Vector result = discretization.make_vector();
    discretization.matrices().apply_mass(result, vector);
    return result;
  }

  template <int dim>
  Vector stiffness_times(const Discretization<dim> &discretization, const Vector &vector)
  {
    Vector result = discretization.make_vector();
    discretization.matrices().apply_stiffness(result, vector);
    return result;
  }

  /** Mass of all bodies, 1'M1 / dim. */
  template <int dim>
  double total_mass(const Discretization<dim> &discretization)
  {
    const Vector one = ones(discretization);
    return one * mass_times(discretization, one) / dim;
  }

  /** Sum over the owned nodes of all processes. */
  template <int dim>
  double sum_over_nodes(const Discretization<dim>                            &discretization,
                        const std::function<double(const unsigned int node)> &value)
  {
    double sum = 0.;
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      sum += value(node);
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  /** Area of the regular polygon with n corners on the unit circle. */
  inline double polygon_area(const unsigned int n)
  {
    return 0.5 * n * std::sin(2. * dealii::numbers::PI / n);
  }
} // namespace signorini::tests

#endif
