// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/mass/minimised_mass.h>
#include <signorini/mass/quadratic_moments.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The body of each local node of the pattern. */
    template <int dim>
    std::vector<unsigned int> bodies_of_nodes(const Discretization<dim> &discretization)
    {
      Vector bodies = discretization.make_vector(); // travels to the ghosts
      for (const auto &cell : discretization.cells())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            if (const auto dof = cell->vertex_dof_index(v, 0);
                discretization.locally_owned().is_element(dof))
              bodies(dof) = cell->material_id();
      bodies.update_ghost_values();
      std::vector<unsigned int> result(discretization.matrices().pattern.n_local);
      for (unsigned int node = 0; node < result.size(); ++node)
        result[node] = static_cast<unsigned int>(std::lround(bodies.local_element(dim * node)));
      return result;
    }


    /** By local node. */
    template <int dim>
    std::vector<bool> massless_nodes(const NodePattern &pattern, const ContactStrip<dim> &strip)
    {
      std::vector<bool> massless(pattern.n_local);
      for (unsigned int node = 0; node < pattern.n_local; ++node)
        massless[node] = strip.is_massless(pattern.partitioner->local_to_global(dim * node) / dim);
      return massless;
    }


    /** The polynomial that gives back what was taken. */
    template <typename Matrix, typename Values>
    Values polynomial_of(const Matrix &gram, const Values &taken, const std::string &body)
    {
      const Eigen::FullPivLU<Matrix> factor(gram);
      if (!factor.isInvertible())
        throw UserError("Time/Mass redistribution = minimisation: the body '" + body
                        + "' has too few nodes besides its contact nodes. Increase Refinements or "
                          "Repetitions.");
      return factor.solve(taken);
    }
  } // namespace


  template <int dim>
  void minimise_change_of_mass(Discretization<dim> &discretization, const ContactStrip<dim> &strip)
  {
    auto             &matrices  = discretization.matrices();
    const auto       &pattern   = matrices.pattern;
    const auto       &positions = discretization.node_positions();
    const auto        body_of   = bodies_of_nodes(discretization);
    const std::size_t n_bodies  = discretization.mesh().bodies().size();
    const auto        massless  = massless_nodes(pattern, strip);

    // Per body: what the couplings with contact nodes take away, and what a polynomial q gives to
    // the others.
    using Moments      = QuadraticMoments<dim>;
    constexpr auto n   = Moments::n;
    using Values       = typename Moments::Values;
    using Matrix       = Eigen::Matrix<double, n, n>;
    const auto moments = [&](const unsigned int body, const unsigned int i, const unsigned int j) {
      return Moments{discretization.mesh().bounding_box(body).center(),
                     discretization.mesh().body_size()}
        .at(positions[i], positions[j]);
    };
    std::vector<double> sums(n_bodies * (n + n * n), 0.);
    const auto          taken = [&](const unsigned int body) {
      return Eigen::Map<Values>(sums.data() + body * (n + n * n));
    };
    const auto gram = [&](const unsigned int body) {
      return Eigen::Map<Matrix>(sums.data() + body * (n + n * n) + n);
    };
    for (unsigned int row = 0; row < pattern.n_owned; ++row)
      for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
        {
          const unsigned int column = pattern.columns[k], body = body_of[row];
          // The diagonal counts once, pairs of owned nodes twice, and the other half of a pair with
          // a ghost is its owner's.
          const double mass =
            (column == row || column >= pattern.n_owned ? 1. : 2.) * matrices.mass[k];
          const Values values = moments(body, row, column);
          if (massless[row] || massless[column])
            taken(body) += mass * values;
          else
            gram(body) += mass * values * values.transpose();
        }
    Utilities::MPI::sum(sums, discretization.communicator(), sums);

    std::vector<Values> polynomial(n_bodies, Values::Zero());
    for (unsigned int body = 0; body < n_bodies; ++body)
      if (taken(body)(n - 1) > 0.)
        polynomial[body] = polynomial_of<Matrix, Values>(
          gram(body), taken(body), discretization.mesh().bodies()[body].name);

    matrices.standard_mass = matrices.mass;
    for (unsigned int row = 0; row < pattern.n_local; ++row)
      for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
        {
          const unsigned int column = pattern.columns[k], body = body_of[row];
          matrices.mass[k] *= massless[row] || massless[column]
                                ? 0.
                                : 1. + polynomial[body].dot(moments(body, row, column));
        }
  }


  template void minimise_change_of_mass(Discretization<2> &, const ContactStrip<2> &);
  template void minimise_change_of_mass(Discretization<3> &, const ContactStrip<3> &);
} // namespace signorini
