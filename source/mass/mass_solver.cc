// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mass/mass_solver.h>

#include <deal.II/lac/solver_cg.h>

#include <Eigen/Eigenvalues>

#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** M~ between the entries that are not held. */
    template <int dim>
    struct FreeMass
    {
      const ElasticMatrices<dim> &matrices;
      const Vector               &inverse_diagonal;

      void vmult(Vector &destination, const Vector &source) const
      {
        matrices.apply_mass(destination, source);
        clear_held(destination);
      }

      void clear_held(Vector &vector) const
      {
        for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
          if (inverse_diagonal.local_element(i) == 0.)
            vector.local_element(i) = 0.;
      }
    };


    struct Diagonal
    {
      const Vector &inverse;

      void vmult(Vector &destination, const Vector &source) const
      {
        destination = source;
        destination.scale(inverse);
      }
    };
  } // namespace


  template <int dim>
  MassSolver<dim>::MassSolver(const ElasticMatrices<dim>      &matrices,
                              const std::vector<unsigned int> &held)
    : matrices(matrices)
    , inverse_diagonal(matrices.pattern.partitioner)
  {
    const NodePattern &pattern = matrices.pattern;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (!pattern.is_empty(node))
        for (unsigned int c = 0; c < dim; ++c)
          inverse_diagonal.local_element(dim * node + c) =
            1. / matrices.mass[pattern.row_start[node]];
    for (const unsigned int node : matrices.massless_nodes)
      for (unsigned int c = 0; c < dim; ++c)
        inverse_diagonal.local_element(dim * node + c) = 0.;
    for (const unsigned int entry : held)
      {
        AssertIndexRange(entry, inverse_diagonal.locally_owned_size());
        inverse_diagonal.local_element(entry) = 0.;
      }
  }


  template <int dim>
  Vector MassSolver<dim>::solve(const Vector &force) const
  {
    AssertDimension(force.locally_owned_size(), inverse_diagonal.locally_owned_size());
    const FreeMass<dim> mass{matrices, inverse_diagonal};
    Vector              right_hand_side = force, result(matrices.pattern.partitioner);
    mass.clear_held(right_hand_side);
    ReductionControl control(1000, std::numeric_limits<double>::min(), 1e-14, false, false);
    SolverCG<Vector> solver(control);
    solver.solve(mass, result, right_hand_side, Diagonal{inverse_diagonal});
    return result;
  }


  template <int dim>
  double MassSolver<dim>::smallest_ratio() const
  {
    double least = std::numeric_limits<double>::max();
    for (const double entry : inverse_diagonal)
      least = std::min(least, std::isfinite(entry) ? entry : -1.);
    const MPI_Comm communicator = matrices.pattern.partitioner->get_mpi_communicator();
    if (Utilities::MPI::min(least, communicator) < 0.)
      return -std::numeric_limits<double>::infinity();

    // The Lanczos process behind conjugate gradients finds the ends of the spectrum first.
    // Something that has all wave lengths starts it.
    const FreeMass<dim> mass{matrices, inverse_diagonal};
    Vector              right_hand_side(matrices.pattern.partitioner), result = right_hand_side;
    const auto          first_entry = right_hand_side.get_partitioner()->local_range().first;
    for (unsigned int i = 0; i < right_hand_side.locally_owned_size(); ++i)
      right_hand_side.local_element(i) =
        1. + std::sin(static_cast<double>((first_entry + i) * (first_entry + i) % 1009));
    mass.clear_held(right_hand_side);
    std::vector<std::pair<double, double>> coefficients; // alpha and beta of each iteration
    IterationNumberControl control(60, 1e-12 * right_hand_side.l2_norm(), false, false);
    SolverCG<Vector>       solver(control);
    solver.connect_coefficients_slot(
      [&](const double alpha, const double beta) { coefficients.emplace_back(alpha, beta); });
    solver.solve(mass, result, right_hand_side, Diagonal{inverse_diagonal});

    // (deal.II would tell the absolute values of the eigenvalues only.)
    const unsigned int n = coefficients.size();
    if (n == 0)
      return 1.;
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n), next_to_it = Eigen::VectorXd::Zero(n - 1);
    for (unsigned int k = 0; k < n; ++k)
      {
        const auto &[alpha, beta] = coefficients[k];
        diagonal(k) += 1. / alpha;
        if (k + 1 < n)
          {
            diagonal(k + 1) = beta / alpha;
            next_to_it(k)   = std::sqrt(beta) / alpha;
          }
      }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigenvalues;
    eigenvalues.computeFromTridiagonal(diagonal, next_to_it, Eigen::EigenvaluesOnly);
    return eigenvalues.eigenvalues().minCoeff();
  }


  template class MassSolver<2>;
  template class MassSolver<3>;
} // namespace signorini
