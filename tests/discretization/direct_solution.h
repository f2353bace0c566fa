// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_discretization_direct_solution_h
#define signorini_tests_discretization_direct_solution_h

#include "bodies.h"

#include <Eigen/Cholesky>

namespace signorini::tests
{
  /**
   * The displacement in balance with nodal forces, by a dense factor of the stiffness: for small
   * meshes without hanging nodes, whatever their condition.
   * @param prescribed values of the entries that are held
   * @param held       of the place of a node, which may be held in all its components
   */
  template <int dim>
  Vector direct_solution(const Discretization<dim>                             &discretization,
                         const Vector                                          &forces,
                         const Vector                                          &prescribed,
                         const std::function<bool(const dealii::Point<dim> &)> &held)
  {
    using dealii::Utilities::MPI::sum;
    const unsigned int  n     = discretization.dof_handler().n_dofs();
    const auto         &owned = discretization.locally_owned();
    std::vector<double> is_free(n, 0.);
    Vector              known = discretization.make_vector();
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (held(discretization.node_positions()[node]))
          known.local_element(dim * node + c) = prescribed.local_element(dim * node + c);
        else
          is_free[owned.nth_index_in_set(dim * node + c)] = 1.;
    sum(is_free, MPI_COMM_WORLD, is_free);
    std::vector<unsigned int> free;
    for (unsigned int i = 0; i < n; ++i)
      if (is_free[i] > 0.)
        free.push_back(i);

    Vector right_hand_side = forces;
    right_hand_side.add(-1., stiffness_times(discretization, known));
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(free.size(), free.size() + 1);
    const auto      store   = [&](const Vector &vector, const unsigned int column) {
      for (unsigned int i = 0; i < free.size(); ++i)
        if (owned.is_element(free[i]))
          columns(i, column) = vector(free[i]);
    };
    for (unsigned int j = 0; j < free.size(); ++j)
      {
        Vector unit = discretization.make_vector();
        if (owned.is_element(free[j]))
          unit(free[j]) = 1.;
        store(stiffness_times(discretization, unit), j);
      }
    store(right_hand_side, free.size());
    const dealii::ArrayView<double> entries(columns.data(), columns.size());
    sum(dealii::ArrayView<const double>(columns.data(), columns.size()), MPI_COMM_WORLD, entries);

    const Eigen::VectorXd values =
      columns.leftCols(free.size()).llt().solve(columns.rightCols<1>());
    Vector result = known;
    for (unsigned int i = 0; i < free.size(); ++i)
      if (owned.is_element(free[i]))
        result(free[i]) = values[i];
    return result;
  }
} // namespace signorini::tests

#endif
