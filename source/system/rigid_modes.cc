// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/rigid_modes.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * Of the largest eigenvalue: motions that Dirichlet conditions hold less than this may be free,
     * which is looked at more closely.
     */
    constexpr double held_for_sure = 1e-6;

    /** Translations, then rotations about the axes through the origin. */
    template <int dim>
    dealii::Tensor<1, dim> rigid_motion(const unsigned int which, const dealii::Point<dim> &x)
    {
      dealii::Tensor<1, dim> u;
      if (which < dim)
        u[which] = 1.;
      else
        {
          const unsigned int axis = dim == 2 ? 2 : which - dim;
          const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
          u[a] = -x[b];
          u[b] = x[a];
        }
      return u;
    }


    /** The bodies of which Dirichlet conditions leave a rigid motion, or more. Collective. */
    template <int dim>
    std::vector<unsigned int> bodies_that_move(const Discretization<dim>       &discretization,
                                               const ContactCoordinates<dim>   &coordinates,
                                               const std::vector<unsigned int> &body_of_node)
    {
      constexpr unsigned int n    = RigidModes<dim>::n_motions;
      const Mesh<dim>       &mesh = discretization.mesh();
      // Products of the motions of prescribed entries, in units of the size of the body.
      std::vector<double> products(mesh.bodies().size() * n * n, 0.);
      for (const unsigned int entry : coordinates.dirichlet_entries())
        {
          const unsigned int node = entry / dim, body = body_of_node[node];
          const auto        &frame = coordinates.node_frames().at(node);
          const auto         place = dealii::Point<dim>(
            (discretization.node_positions()[node] - mesh.bounding_box(body).center())
            / mesh.body_size(body));
          Eigen::Matrix<double, n, 1> parts = Eigen::Matrix<double, n, 1>::Zero();
          for (unsigned int which = 0; which < n; ++which)
            for (unsigned int c = 0; c < dim; ++c)
              parts[which] += frame[dim * (entry % dim) + c] * rigid_motion(which, place)[c];
          Eigen::Map<Eigen::Matrix<double, n, n>>(&products[body * n * n]) +=
            parts * parts.transpose();
        }
      dealii::Utilities::MPI::sum(products, discretization.communicator(), products);
      std::vector<unsigned int> result;
      for (unsigned int body = 0; body < mesh.bodies().size(); ++body)
        {
          const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, n, n>> eigen(
            Eigen::Map<Eigen::Matrix<double, n, n>>(&products[body * n * n]),
            Eigen::EigenvaluesOnly);
          if (eigen.eigenvalues()[0] <= held_for_sure * eigen.eigenvalues()[n - 1])
            result.push_back(body);
        }
      return result;
    }
  } // namespace


  template <int dim>
  RigidModes<dim>::RigidModes(const Discretization<dim>     &discretization,
                              const ContactCoordinates<dim> &coordinates)
    : discretization(discretization)
    , coordinates(coordinates)
  {
    const std::vector<unsigned int> bodies = discretization.bodies_of_nodes();
    loose_bodies                           = bodies_that_move(discretization, coordinates, bodies);
    for (const unsigned int body : loose_bodies)
      {
        const std::size_t first = modes.size();
        for (unsigned int which = 0; which < n_motions; ++which)
          {
            Motion mode{discretization.make_vector(), discretization.make_vector()};
            for (unsigned int node = 0; node < bodies.size(); ++node)
              if (bodies[node] == body)
                for (unsigned int c = 0; c < dim; ++c)
                  mode.displacement.local_element(dim * node + c) =
                    rigid_motion(which, discretization.node_positions()[node])[c];
            dealii::Tensor<1, 3> rotation;
            if (which >= dim)
              rotation[dim == 2 ? 2 : which - dim] = 1.;
            // Twice: far from the origin a rotation is nearly a translation.
            for (unsigned int pass = 0; pass < 2; ++pass)
              for (std::size_t j = first; j < modes.size(); ++j)
                {
                  const double part = dot(modes[j].momentum, mode.displacement);
                  mode.displacement.add(-part, modes[j].displacement);
                  rotation -= part * rotations[j];
                }
            discretization.matrices().apply_mass(mode.momentum, mode.displacement);
            const double size = std::sqrt(dot(mode.momentum, mode.displacement));
            mode.displacement /= size;
            mode.momentum /= size;
            rotations.push_back(rotation / size);
            sizes.push_back(mode.displacement.linfty_norm());
            local.push_back(mode.displacement);
            coordinates.displacement_to_contact(local.back());
            modes.push_back(std::move(mode));
          }
      }
  }


  template <int dim>
  std::vector<Vector> RigidModes<dim>::momenta_in_contact() const
  {
    std::vector<Vector> momenta;
    for (const Motion &mode : modes)
      {
        momenta.push_back(mode.momentum);
        coordinates.force_to_contact(momenta.back());
      }
    return momenta;
  }


  template <int dim>
  void RigidModes<dim>::add_in_contact(const Eigen::VectorXd &amplitudes,
                                       Vector                &displacement) const
  {
    AssertDimension(amplitudes.size(), size());
    for (unsigned int i = 0; i < size(); ++i)
      displacement.add(amplitudes[i], local[i]);
  }


  template <int dim>
  Eigen::VectorXd RigidModes<dim>::sizes_of_products(const Vector &forces) const
  {
    std::vector<double> sums(size(), 0.);
    for (unsigned int i = 0; i < size(); ++i)
      for (unsigned int k = 0; k < forces.locally_owned_size(); ++k)
        sums[i] += std::abs(local[i].local_element(k)) * forces.local_element(k);
    dealii::Utilities::MPI::sum(sums, discretization.communicator(), sums);
    return Eigen::Map<const Eigen::VectorXd>(sums.data(), sums.size());
  }


  template <int dim>
  Eigen::MatrixXd
  RigidModes<dim>::free_amplitudes(const std::vector<unsigned int>  &entries,
                                   const std::vector<HeldDirection> &directions) const
  {
    for ([[maybe_unused]] const unsigned int entry : entries)
      AssertIndexRange(entry, dim * discretization.matrices().pattern.n_owned);
    // Motions of displacement 1: bodies may differ in mass by many orders of magnitude.
    const Eigen::Index n = modes.size();
    if (n == 0)
      return {};
    const Eigen::VectorXd scale = Eigen::Map<const Eigen::VectorXd>(sizes.data(), n).cwiseInverse();
    Eigen::MatrixXd       gram  = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        for (const unsigned int entry : entries)
          gram(i, j) +=
            scale[i] * local[i].local_element(entry) * scale[j] * local[j].local_element(entry);
    for (const HeldDirection &held : directions)
      {
        Eigen::VectorXd parts(n);
        for (Eigen::Index i = 0; i < n; ++i)
          parts[i] = scale[i]
                     * (held.parts[0] * local[i].local_element(held.entries[0])
                        + held.parts[1] * local[i].local_element(held.entries[1]));
        gram += parts * parts.transpose();
      }
    const dealii::ArrayView<double> sums(gram.data(), gram.size());
    dealii::Utilities::MPI::sum(
      dealii::ArrayView<const double>(sums), discretization.communicator(), sums);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
    const double                                         largest = eigen.eigenvalues()[n - 1];
    Eigen::Index                                         n_free  = 0;
    while (n_free < n && eigen.eigenvalues()[n_free] <= 1e-10 * largest)
      ++n_free;
    const Eigen::MatrixXd free = scale.asDiagonal() * eigen.eigenvectors().leftCols(n_free);
    return Eigen::HouseholderQR<Eigen::MatrixXd>(free).householderQ()
           * Eigen::MatrixXd::Identity(n, n_free);
  }


  template <int dim>
  std::vector<Motion> RigidModes<dim>::free_of(const std::vector<unsigned int> &entries) const
  {
    const Eigen::MatrixXd amplitudes = free_amplitudes(entries);
    std::vector<Motion>   free;
    for (Eigen::Index k = 0; k < amplitudes.cols(); ++k)
      {
        free.push_back({discretization.make_vector(), discretization.make_vector()});
        for (Eigen::Index i = 0; i < amplitudes.rows(); ++i)
          {
            free.back().displacement.add(amplitudes(i, k), modes[i].displacement);
            free.back().momentum.add(amplitudes(i, k), modes[i].momentum);
          }
      }
    return free;
  }


  template class RigidModes<2>;
  template class RigidModes<3>;
} // namespace signorini
