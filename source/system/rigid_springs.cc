// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/rigid_springs.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  template <int dim>
  RigidSprings<dim>::RigidSprings(const LinearOperator &stiffness, const RigidModes<dim> &rigid)
    : stiffness(stiffness)
    , momenta(rigid.momenta_in_contact())
    , springs(Eigen::MatrixXd::Zero(rigid.size(), rigid.size()))
  {
  }


  template <int dim>
  void RigidSprings<dim>::set(const Eigen::MatrixXd &stiffness_of_springs)
  {
    AssertDimension(stiffness_of_springs.rows(), springs.rows());
    AssertDimension(stiffness_of_springs.cols(), springs.cols());
    springs = stiffness_of_springs;
    any     = springs.cwiseAbs().sum() > 0.;
  }


  template <int dim>
  void RigidSprings<dim>::vmult(Vector &destination, const Vector &source) const
  {
    stiffness.vmult(destination, source);
    if (any)
      add_forces(springs * amplitudes(source), destination);
  }


  template <int dim>
  void RigidSprings<dim>::diagonal(Vector &destination) const
  {
    stiffness.diagonal(destination);
    for (Eigen::Index i = 0; i < springs.rows(); ++i)
      for (Eigen::Index j = 0; j < springs.cols(); ++j)
        if (springs(i, j) != 0.)
          for (unsigned int k = 0; k < destination.locally_owned_size(); ++k)
            destination.local_element(k) +=
              springs(i, j) * momenta[i].local_element(k) * momenta[j].local_element(k);
  }


  template <int dim>
  Eigen::VectorXd RigidSprings<dim>::amplitudes(const Vector &displacement) const
  {
    std::vector<double> sums(momenta.size(), 0.);
    for (std::size_t i = 0; i < momenta.size(); ++i)
      for (unsigned int k = 0; k < displacement.locally_owned_size(); ++k)
        sums[i] += momenta[i].local_element(k) * displacement.local_element(k);
    dealii::Utilities::MPI::sum(sums, displacement.get_mpi_communicator(), sums);
    return Eigen::Map<const Eigen::VectorXd>(sums.data(), sums.size());
  }


  template <int dim>
  void RigidSprings<dim>::add_forces(const Eigen::VectorXd &forces, Vector &force) const
  {
    for (std::size_t i = 0; i < momenta.size(); ++i)
      if (forces[i] != 0.)
        force.add(forces[i], momenta[i]);
  }


  template class RigidSprings<2>;
  template class RigidSprings<3>;
} // namespace signorini
