// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/rigid_modes.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace signorini
{
  namespace
  {
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
  } // namespace


  template <int dim>
  RigidModes<dim>::RigidModes(const Discretization<dim>     &discretization,
                              const ContactCoordinates<dim> &coordinates)
    : discretization(discretization)
  {
    const std::vector<unsigned int> bodies = discretization.bodies_of_nodes();
    for (unsigned int body = 0; body < discretization.mesh().bodies().size(); ++body)
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
            // Twice: far from the origin a rotation is nearly a translation.
            for (unsigned int pass = 0; pass < 2; ++pass)
              for (std::size_t j = first; j < modes.size(); ++j)
                mode.displacement.add(-dot(modes[j].momentum, mode.displacement),
                                      modes[j].displacement);
            discretization.matrices().apply_mass(mode.momentum, mode.displacement);
            const double size = std::sqrt(dot(mode.momentum, mode.displacement));
            mode.displacement /= size;
            mode.momentum /= size;
            local.push_back(mode.displacement);
            coordinates.displacement_to_contact(local.back());
            modes.push_back(std::move(mode));
          }
      }
  }


  template <int dim>
  std::vector<Motion> RigidModes<dim>::free_of(const std::vector<unsigned int> &entries) const
  {
    for ([[maybe_unused]] const unsigned int entry : entries)
      AssertIndexRange(entry, dim * discretization.matrices().pattern.n_owned);
    const Eigen::Index n    = modes.size();
    Eigen::MatrixXd    gram = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        for (const unsigned int entry : entries)
          gram(i, j) += local[i].local_element(entry) * local[j].local_element(entry);
    const dealii::ArrayView<double> sums(gram.data(), gram.size());
    dealii::Utilities::MPI::sum(
      dealii::ArrayView<const double>(sums), discretization.communicator(), sums);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
    std::vector<Motion>                                  free;
    for (Eigen::Index k = 0; k < n; ++k)
      if (eigen.eigenvalues()[k] <= 1e-10 * eigen.eigenvalues()[n - 1]
          || eigen.eigenvalues()[n - 1] == 0.)
        {
          free.push_back({discretization.make_vector(), discretization.make_vector()});
          for (Eigen::Index i = 0; i < n; ++i)
            {
              free.back().displacement.add(eigen.eigenvectors()(i, k), modes[i].displacement);
              free.back().momentum.add(eigen.eigenvectors()(i, k), modes[i].momentum);
            }
        }
    return free;
  }


  template class RigidModes<2>;
  template class RigidModes<3>;
} // namespace signorini
