// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Products with the assembled matrices are the sums over all cells of mass and stiffness with
// hanging nodes interpolated, on any number of processes. Rows of ghosts are those of the owner.
// Assembling again gives the same, and counts of products go on.

#include "bodies.h"

#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

#include <map>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** x'My and x'Ay, cell by cell. */
  template <int dim>
  std::pair<double, double>
  sums_over_cells(const Discretization<dim> &discretization, const Vector &x, const Vector &y)
  {
    const Vector full_x         = discretization.interpolate_hanging_nodes(x),
                 full_y         = discretization.interpolate_hanging_nodes(y);
    double                 mass = 0., stiffness = 0.;
    constexpr unsigned int n_vertices = 1u << dim;
    for (const auto &cell : discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const auto matrix = discretization.mesh().cell_matrices().of(cell);
          for (unsigned int a = 0; a < n_vertices; ++a)
            for (unsigned int b = 0; b < n_vertices; ++b)
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const double x_ac = full_x(cell->vertex_dof_index(a, c));
                  mass += x_ac * matrix.mass(a, b) * full_y(cell->vertex_dof_index(b, c));
                  for (unsigned int d = 0; d < dim; ++d)
                    stiffness += x_ac * matrix.stiffness(a, b)[dim * d + c]
                                 * full_y(cell->vertex_dof_index(b, d));
                }
        }
    return {dealii::Utilities::MPI::sum(mass, MPI_COMM_WORLD),
            dealii::Utilities::MPI::sum(stiffness, MPI_COMM_WORLD)};
  }

  template <int dim>
  void expect_sums_over_cells(const BodyDescription<dim> &body)
  {
    const Assembled<dim> assembled(body);
    const auto          &discretization = assembled.discretization;
    const Vector x = irregular_field(discretization, 3.), y = irregular_field(discretization, 7.);
    const auto [mass, stiffness] = sums_over_cells(discretization, x, y);
    const double mass_scale      = std::abs(x * mass_times(discretization, x)),
                 stiffness_scale = std::abs(x * stiffness_times(discretization, x));
    EXPECT_NEAR(x * mass_times(discretization, y), mass, 1e-13 * mass_scale);
    EXPECT_NEAR(x * stiffness_times(discretization, y), stiffness, 1e-12 * stiffness_scale);
  }

  template <int dim>
  dealii::types::global_dof_index global_node(const NodePattern &pattern, const unsigned int node)
  {
    return pattern.partitioner->local_to_global(dim * node) / dim;
  }

  /**
   * All entries of the upper triangles of the owned rows of all processes, by global nodes, the
   * smaller one first.
   */
  template <int dim>
  std::map<std::pair<unsigned int, unsigned int>, double>
  all_masses(const ElasticMatrices<dim> &matrices)
  {
    std::vector<unsigned int> rows, columns;
    std::vector<double>       values;
    const NodePattern        &pattern = matrices.pattern;
    for (unsigned int row = 0; row < pattern.n_owned; ++row)
      for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
        {
          const auto nodes = std::minmax(
            {global_node<dim>(pattern, row), global_node<dim>(pattern, pattern.columns[k])});
          rows.push_back(nodes.first);
          columns.push_back(nodes.second);
          values.push_back(matrices.mass[k]);
        }
    const auto all_rows    = dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, rows);
    const auto all_columns = dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, columns);
    const auto all_values  = dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, values);
    std::map<std::pair<unsigned int, unsigned int>, double> result;
    for (unsigned int rank = 0; rank < all_rows.size(); ++rank)
      for (unsigned int i = 0; i < all_rows[rank].size(); ++i)
        result[{all_rows[rank][i], all_columns[rank][i]}] = all_values[rank][i];
    return result;
  }

  /** Two nodes that no cell couples, and which do not hang: opposite corners. */
  template <int dim>
  std::pair<unsigned int, unsigned int> corners(const Discretization<dim> &discretization)
  {
    std::array<unsigned int, 2> result{{0, 0}};
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      for (const unsigned int corner : {0, 1})
        {
          dealii::Point<dim> place;
          for (unsigned int c = 0; c < dim; ++c)
            place[c] = corner;
          if (discretization.node_positions()[node].distance(place) < 1e-10)
            result[corner] = global_node<dim>(discretization.matrices().pattern, node);
        }
    return {dealii::Utilities::MPI::max(result[0], MPI_COMM_WORLD),
            dealii::Utilities::MPI::max(result[1], MPI_COMM_WORLD)};
  }
} // namespace

TEST(Assembly, IsTheSumOverTheCells)
{
  expect_sums_over_cells<2>(box_with_hanging_nodes<2>());
  expect_sums_over_cells<3>(box_with_hanging_nodes<3>());
  expect_sums_over_cells<2>(ball<2>(3));
  BodyDescription<3> body = ball<3>(1);
  body.local_refinements  = 2;
  body.refine_where       = "0.7 - z + 0.2*x";
  expect_sums_over_cells<3>(body);
}

TEST(Assembly, RowsOfGhostsAreThoseOfTheOwner)
{
  const Assembled<3> assembled(box_with_hanging_nodes<3>());
  const auto        &matrices = assembled.discretization.matrices();
  const NodePattern &pattern  = matrices.pattern;
  const auto         all      = all_masses(matrices);
  unsigned int       n_found = 0, n_expected = 0;
  for (unsigned int row = pattern.n_owned; row < pattern.n_local; ++row)
    for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k, ++n_found)
      {
        EXPECT_TRUE(k > pattern.row_start[row] ? pattern.columns[k] > pattern.columns[k - 1]
                                               : pattern.columns[k] == row);
        const auto entry =
          all.find({global_node<3>(pattern, row), global_node<3>(pattern, pattern.columns[k])});
        ASSERT_TRUE(entry != all.end());
        EXPECT_NEAR(matrices.mass[k], entry->second, 1e-14 * entry->second);
      }
  for (const auto &[nodes, value] : all)
    if (pattern.partitioner->is_ghost_entry(3 * nodes.first)
        && pattern.partitioner->is_ghost_entry(3 * nodes.second))
      ++n_expected;
  EXPECT_EQ(n_found, n_expected);
}

TEST(Assembly, AChangeOfTheMassMayCoupleAnyNodes)
{
  Assembled<2> assembled(box_with_hanging_nodes<2>());
  auto        &discretization = assembled.discretization;
  const auto   before         = all_masses(discretization.matrices());
  const auto [first, second]  = corners(discretization);
  ASSERT_EQ(before.count(std::minmax(first, second)), 0u);

  MassChange change;
  const auto owned = discretization.matrices().pattern.partitioner;
  if (owned->in_local_range(2 * first))
    change = {{{first, second}, 0.25}, {{first, first}, 0.5}};
  if (owned->in_local_range(2 * second))
    change[{second, first}] = 0.25;
  const auto count = discretization.matrices().products();
  discretization.change_mass(change);

  auto expected = before;
  expected[std::minmax(first, second)] += 0.25;
  expected[{first, first}] += 0.5;
  const auto changed = all_masses(discretization.matrices());
  ASSERT_EQ(changed.size(), expected.size());
  for (const auto &[nodes, value] : expected)
    EXPECT_NEAR(changed.at(nodes), value, 1e-14) << nodes.first << ", " << nodes.second;
  const Vector x        = irregular_field(discretization, 3.);
  Vector       standard = discretization.make_vector();
  discretization.matrices().apply_standard_mass(standard, x);
  EXPECT_NEAR(x * standard, sums_over_cells(discretization, x, x).first, 1e-13 * (x * standard));
  EXPECT_EQ(discretization.matrices().products().mass, count.mass + 1)
    << "of the run, not of the matrices";

  discretization.change_mass({});
  EXPECT_TRUE(discretization.matrices().standard_mass.empty());
  const auto again = all_masses(discretization.matrices());
  ASSERT_EQ(again.size(), before.size());
  for (const auto &[nodes, value] : before)
    EXPECT_NEAR(again.at(nodes), value, 1e-14 * value);
}

TEST(Assembly, FieldsOfNumbersThatOverflowAreRefused)
{
  const Assembled<2> square(box<2>());
  for (const std::string value : {"1/(x-x)", "1e200", "-1e101"})
    EXPECT_THROW(field<2>(square.discretization, {{"0", value}}), UserError) << value;
  EXPECT_NO_THROW(field<2>(square.discretization, {{"0", "1e99"}}));
}
