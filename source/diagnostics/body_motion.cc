// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/body_motion.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Each entry becomes its sum over all processes. */
    template <typename T>
    void sum_over_processes(std::vector<T> &values, const MPI_Comm communicator)
    {
      for (T &value : values)
        value = Utilities::MPI::sum(value, communicator);
    }
  } // namespace


  template <int dim>
  BodyMotion<dim>::BodyMotion(const Discretization<dim> &discretization)
    : communicator(discretization.communicator())
    , turns_without_strain(discretization.mesh().mapping().get_degree() == 1)
  {
    const unsigned int n_bodies = discretization.mesh().bodies().size();
    const auto        &pattern  = discretization.matrices().pattern;

    Vector along_x = discretization.make_vector(), mass = along_x;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      along_x.local_element(dim * node) = 1.;
    discretization.matrices().apply_standard_mass(mass, along_x);

    const std::vector<unsigned int> bodies = discretization.bodies_of_nodes();
    masses.assign(n_bodies, 0.);
    centres.resize(n_bodies);
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (bodies[node] < n_bodies)
        {
          const double weight = mass.local_element(dim * node);
          masses[bodies[node]] += weight;
          points.push_back({node, bodies[node], weight, discretization.node_positions()[node]});
        }
    sum_over_processes(masses, communicator);

    // Twice: far from the origin the first mean has the round-off of the positions.
    for (unsigned int pass = 0; pass < 2; ++pass)
      {
        std::vector<Tensor<1, dim>> first_moments(n_bodies);
        for (const MassPoint &point : points)
          first_moments[point.body] += point.mass * point.arm;
        sum_over_processes(first_moments, communicator);
        for (MassPoint &point : points)
          point.arm -= first_moments[point.body] / masses[point.body];
        for (unsigned int body = 0; body < n_bodies; ++body)
          centres[body] += first_moments[body] / masses[body];
      }

    std::vector<Tensor<2, n_axes>> inertia(n_bodies);
    for (const MassPoint &point : points)
      {
        for (unsigned int i = 0; i < n_axes; ++i)
          {
            inertia[point.body][i][i] += point.mass * point.arm.norm_square();
            if constexpr (dim == 3)
              for (unsigned int j = 0; j < n_axes; ++j)
                inertia[point.body][i][j] -= point.mass * point.arm[i] * point.arm[j];
          }
      }
    sum_over_processes(inertia, communicator);
    for (const auto &tensor : inertia)
      inverse_inertia.push_back(invert(tensor));
  }


  template <int dim>
  typename BodyMotion<dim>::Moment BodyMotion<dim>::moment(const Tensor<1, dim> &arm,
                                                           const Tensor<1, dim> &vector)
  {
    if constexpr (dim == 3)
      return cross_product_3d(arm, vector);
    else
      {
        Moment result;
        result[0] = arm[0] * vector[1] - arm[1] * vector[0];
        return result;
      }
  }


  template <int dim>
  std::vector<double> BodyMotion<dim>::rotation(const Vector &displacement) const
  {
    std::vector<Moment> moments(inverse_inertia.size());
    for (const MassPoint &point : points)
      {
        Tensor<1, dim> u;
        for (unsigned int c = 0; c < dim; ++c)
          u[c] = displacement.local_element(dim * point.node + c);
        moments[point.body] += point.mass * moment(point.arm, u);
      }
    sum_over_processes(moments, communicator);
    std::vector<double> angles;
    for (std::size_t body = 0; body < moments.size(); ++body)
      angles.push_back((inverse_inertia[body] * moments[body]).norm());
    return angles;
  }


  template <int dim>
  std::vector<double> BodyMotion<dim>::moments(const Vector &forces,
                                               const Vector *displacement) const
  {
    const auto at_node = [](const Vector &vector, const unsigned int node) {
      Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = vector.local_element(dim * node + c);
      return result;
    };
    std::vector<Tensor<1, dim>> means(masses.size());
    if (displacement != nullptr)
      for (const MassPoint &point : points)
        means[point.body] += point.mass / masses[point.body] * at_node(*displacement, point.node);
    sum_over_processes(means, communicator);
    std::vector<Moment> sums(masses.size());
    for (const MassPoint &point : points)
      sums[point.body] +=
        moment(displacement != nullptr ? at_node(*displacement, point.node) - means[point.body]
                                       : point.arm,
               at_node(forces, point.node));
    sum_over_processes(sums, communicator);
    std::vector<double> result;
    for (const Moment &sum : sums)
      result.push_back(sum.norm());
    return result;
  }


  template <int dim>
  double BodyMotion<dim>::elastic_energy(const State &state) const
  {
    // Per body: u'Au; resultant and moment of Au, which are round-off (the moment only where
    // rotations are among the displacements); of m u the same, which are the motion.
    constexpr unsigned int n_sums = 1 + 2 * (dim + n_axes);
    std::vector<double>    sums(masses.size() * n_sums, 0.);
    for (const MassPoint &point : points)
      {
        double        *sum = &sums[point.body * n_sums];
        Tensor<1, dim> u, force;
        for (unsigned int c = 0; c < dim; ++c)
          {
            u[c]     = state.displacement.local_element(dim * point.node + c);
            force[c] = state.internal_force.local_element(dim * point.node + c);
            sum[1 + c] += force[c];
            sum[1 + dim + n_axes + c] += point.mass * u[c];
          }
        sum[0] += u * force;
        const Moment of_force = moment(point.arm, force), of_motion = moment(point.arm, u);
        for (unsigned int axis = 0; axis < n_axes; ++axis)
          {
            sum[1 + dim + axis] += of_force[axis];
            sum[1 + 2 * dim + n_axes + axis] += point.mass * of_motion[axis];
          }
      }
    Utilities::MPI::sum(sums, communicator, sums);
    double twice_the_energy = 0.;
    for (std::size_t body = 0; body < masses.size(); ++body)
      {
        const double *force = &sums[body * n_sums + 1], *motion = force + dim + n_axes;
        twice_the_energy += sums[body * n_sums];
        for (unsigned int c = 0; c < dim; ++c)
          twice_the_energy -= force[c] * motion[c] / masses[body];
        for (unsigned int i = 0; turns_without_strain && i < n_axes; ++i)
          for (unsigned int j = 0; j < n_axes; ++j)
            twice_the_energy -= force[dim + i] * inverse_inertia[body][i][j] * motion[dim + j];
      }
    return 0.5 * twice_the_energy;
  }


  template <int dim>
  std::vector<BodyReading> BodyMotion<dim>::read(const State &state) const
  {
    // Per body: both energies, momentum, angular momentum, mean displacement.
    constexpr unsigned int n_sums = 2 + 2 * dim + n_axes;
    std::vector<double>    sums(masses.size() * n_sums, 0.);
    for (const MassPoint &point : points)
      {
        double        *sum = &sums[point.body * n_sums];
        Tensor<1, dim> momentum;
        for (unsigned int c = 0; c < dim; ++c)
          {
            const unsigned int i = dim * point.node + c;
            const double       u = state.displacement.local_element(i);
            momentum[c]          = state.momentum.local_element(i);
            sum[0] += 0.5 * state.velocity.local_element(i) * momentum[c];
            sum[1] += 0.5 * u * state.internal_force.local_element(i);
            sum[2 + c] += momentum[c];
            sum[2 + dim + n_axes + c] += point.mass * u / masses[point.body];
          }
        const Moment spin = moment(point.arm, momentum);
        for (unsigned int axis = 0; axis < n_axes; ++axis)
          sum[2 + dim + axis] += spin[axis];
      }
    Utilities::MPI::sum(sums, communicator, sums);

    std::vector<BodyReading> readings(masses.size());
    for (std::size_t body = 0; body < masses.size(); ++body)
      {
        const double *sum      = &sums[body * n_sums];
        BodyReading  &reading  = readings[body];
        reading.kinetic_energy = sum[0];
        reading.elastic_energy = sum[1];
        for (unsigned int c = 0; c < dim; ++c)
          {
            reading.momentum[c] = sum[2 + c];
            reading.velocity[c] = sum[2 + c] / masses[body];
            reading.centroid[c] = centres[body][c] + sum[2 + dim + n_axes + c];
          }
        for (unsigned int axis = 0; axis < n_axes; ++axis)
          reading.angular_momentum[3 - n_axes + axis] = sum[2 + dim + axis];
      }
    return readings;
  }


  template class BodyMotion<2>;
  template class BodyMotion<3>;
} // namespace signorini
