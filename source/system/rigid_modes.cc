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
    std::vector<std::array<std::string, dim>> rigid_motions();

    template <>
    std::vector<std::array<std::string, 2>> rigid_motions<2>()
    {
      return {{{"1", "0"}}, {{"0", "1"}}, {{"-y", "x"}}};
    }

    template <>
    std::vector<std::array<std::string, 3>> rigid_motions<3>()
    {
      return {{{"1", "0", "0"}},
              {{"0", "1", "0"}},
              {{"0", "0", "1"}},
              {{"0", "-z", "y"}},
              {{"z", "0", "-x"}},
              {{"-y", "x", "0"}}};
    }
  } // namespace


  template <int dim>
  RigidModes<dim>::RigidModes(const Discretization<dim>     &discretization,
                              const ContactCoordinates<dim> &coordinates)
    : discretization(discretization)
  {
    const std::size_t n_bodies = discretization.mesh().bodies().size();
    for (std::size_t body = 0; body < n_bodies; ++body)
      {
        const std::size_t first = modes.size();
        for (const auto &motion : rigid_motions<dim>())
          {
            std::array<std::string, dim> rest;
            rest.fill("0");
            std::vector<std::array<std::string, dim>> expressions(n_bodies, rest);
            expressions[body] = motion;
            Motion mode{discretization.interpolate(expressions), discretization.make_vector()};
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
