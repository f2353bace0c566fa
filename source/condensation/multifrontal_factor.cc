// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/condensation/multifrontal_factor.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace signorini
{
  namespace
  {
    /** For each eliminated node, the later nodes of its column of the factor. */
    using Structures = std::vector<std::vector<int>>;

    Structures structures_of(const Eigen::SparseMatrix<double> &lower,
                             const std::vector<int>            &node_starts,
                             const int                          n_eliminated)
    {
      const int        n_nodes = node_starts.size() - 1;
      std::vector<int> node_of(lower.rows());
      for (int node = 0; node < n_nodes; ++node)
        std::fill(
          node_of.begin() + node_starts[node], node_of.begin() + node_starts[node + 1], node);
      Structures       result(n_eliminated), children(n_eliminated);
      std::vector<int> seen_by(n_nodes, -1);
      for (int node = 0; node < n_eliminated; ++node)
        {
          std::vector<int> &structure = result[node];
          seen_by[node]               = node;
          const auto add              = [&](const int other) {
            if (seen_by[other] != node)
              structure.push_back(other);
            seen_by[other] = node;
          };
          for (int column = node_starts[node]; column < node_starts[node + 1]; ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry)
              add(node_of[entry.row()]);
          for (const int child : children[node])
            std::for_each(result[child].begin(), result[child].end(), add);
          std::sort(structure.begin(), structure.end());
          if (!structure.empty() && structure.front() < n_eliminated)
            children[structure.front()].push_back(node);
        }
      return result;
    }


    /**
     * Where panels begin, and the number of eliminated nodes. A node joins the one before if that
     * brings few zeros into its columns.
     */
    std::vector<int> begins_of_panels(const Structures &structures)
    {
      constexpr double most_zeros = 0.03; // of the numbers of a panel
      const int        n          = structures.size();
      std::vector<int> result     = {0};
      double           zeros = 0., numbers = 0.;
      for (int node = 1; node <= n; ++node)
        {
          const std::vector<int> &before = structures[node - 1];
          numbers += 1. + before.size();
          if (node < n && !before.empty() && before.front() == node)
            {
              const double columns = node - result.back();
              const double more    = columns * (1. + structures[node].size() - before.size());
              if (zeros + more <= most_zeros * (numbers + more))
                {
                  zeros += more;
                  numbers += more;
                  continue;
                }
            }
          result.push_back(node);
          zeros = numbers = 0.;
        }
      return result;
    }


    /** Call action with the number of columns as a constant. */
    template <typename Action>
    void with_number(const int n_columns, const Action &action)
    {
      if (n_columns == 1)
        action(std::integral_constant<int, 1>());
      else if (n_columns == 2)
        action(std::integral_constant<int, 2>());
      else if (n_columns == 3)
        action(std::integral_constant<int, 3>());
      else
        action(std::integral_constant<int, 4>());
    }


    /** What eliminated panels leave for some rows. */
    struct Update
    {
      const int      *rows;
      Eigen::MatrixXd matrix; ///< lower triangle
    };


    /**
     * Add up, in the lower triangle of a full matrix, the first columns of some rows of a sparse
     * one and what eliminated panels leave for these rows.
     * @param place of each row in the full matrix: work space
     */
    void assemble(const Eigen::SparseMatrix<double> &lower,
                  const int *const                   rows,
                  const Eigen::Index                 n_rows,
                  const Eigen::Index                 n_columns,
                  const std::vector<Update>         &updates,
                  std::vector<int>                  &place,
                  Eigen::MatrixXd                   &front)
    {
      for (Eigen::Index i = 0; i < n_rows; ++i)
        place[rows[i]] = i;
      front.setZero(n_rows, n_rows);
      for (Eigen::Index j = 0; j < n_columns; ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, rows[j]); entry; ++entry)
          front(place[entry.row()], j) += entry.value();
      for (const Update &update : updates)
        for (Eigen::Index j = 0; j < update.matrix.cols(); ++j)
          {
            double       *column = &front(0, place[update.rows[j]]);
            const double *more   = &update.matrix(0, j);
            for (Eigen::Index i = j; i < update.matrix.rows(); ++i)
              column[place[update.rows[i]]] += more[i];
          }
    }


    /** Columns of the factor in place of the first ones of a front. @return what they leave */
    Eigen::MatrixXd eliminate_columns(Eigen::MatrixXd &front, const Eigen::Index n_columns)
    {
      const Eigen::Index n_left = front.rows() - n_columns;
      auto               pivots = front.topLeftCorner(n_columns, n_columns);
      auto               below  = front.bottomLeftCorner(n_left, n_columns);
      const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(pivots);
      if (factor.info() != Eigen::Success)
        throw StepError("the matrix of a step has no Cholesky factor.");
      pivots.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
      Eigen::MatrixXd left = front.bottomRightCorner(n_left, n_left);
      left.selfadjointView<Eigen::Lower>().rankUpdate(below, -1.);
      return left;
    }
  } // namespace


  MultifrontalFactor::MultifrontalFactor(const Eigen::SparseMatrix<double> &lower,
                                         const std::vector<int>            &node_starts,
                                         const int                          n_eliminated)
  {
    find_panels(lower, node_starts, n_eliminated);
    factorise(lower, node_starts[n_eliminated]);
    find_groups();
  }


  void MultifrontalFactor::find_panels(const Eigen::SparseMatrix<double> &lower,
                                       const std::vector<int>            &node_starts,
                                       const int                          n_eliminated)
  {
    const Structures       structures = structures_of(lower, node_starts, n_eliminated);
    const std::vector<int> begins     = begins_of_panels(structures);
    std::size_t            n_numbers  = 0;
    for (std::size_t k = 0; k + 1 < begins.size(); ++k)
      {
        const int first = node_starts[begins[k]], end = node_starts[begins[k + 1]];
        panels.push_back({end - first, 0, rows.size(), n_numbers});
        for (int row = first; row < end; ++row)
          rows.push_back(row);
        for (const int node : structures[begins[k + 1] - 1])
          for (int row = node_starts[node]; row < node_starts[node + 1]; ++row)
            rows.push_back(row);
        panels.back().n_rows = rows.size() - panels.back().first_row;
        n_numbers            = panels.back().diagonal(panels.back().n_columns);
      }
    numbers.resize(n_numbers);
  }


  void MultifrontalFactor::factorise(const Eigen::SparseMatrix<double> &lower,
                                     const int                          n_eliminated_rows)
  {
    const int                        n_panels = panels.size();
    std::vector<int>                 place(lower.rows()), panel_of(n_eliminated_rows);
    std::vector<std::vector<Update>> updates(n_panels + 1); // by the panel that takes them
    for (int k = 0; k < n_panels; ++k)
      std::fill_n(panel_of.begin() + rows[panels[k].first_row], panels[k].n_columns, k);
    Eigen::MatrixXd front;
    for (int k = 0; k < n_panels; ++k)
      {
        const Panel &panel = panels[k];
        const int   *first = rows.data() + panel.first_row;
        assemble(lower, first, panel.n_rows, panel.n_columns, updates[k], place, front);
        updates[k]           = {};
        Eigen::MatrixXd left = eliminate_columns(front, panel.n_columns);
        for (int j = 0; j < panel.n_columns; ++j)
          std::copy_n(&front(j, j), panel.n_rows - j, &numbers[panel.diagonal(j)]);
        if (panel.n_rows == panel.n_columns)
          continue;
        const int *const left_rows = first + panel.n_columns;
        const int taker = left_rows[0] < n_eliminated_rows ? panel_of[left_rows[0]] : n_panels;
        updates[taker].push_back({left_rows, std::move(left)});
      }

    std::vector<int> others(lower.rows() - n_eliminated_rows);
    std::iota(others.begin(), others.end(), n_eliminated_rows);
    assemble(
      lower, others.data(), others.size(), others.size(), updates[n_panels], place, of_others);
    of_others.triangularView<Eigen::StrictlyUpper>() = of_others.transpose();
  }


  void MultifrontalFactor::find_groups()
  {
    for (const Panel &panel : panels)
      for (int first = 0; first < panel.n_columns; first += most_columns)
        groups.push_back({std::min(most_columns, panel.n_columns - first),
                          panel.n_rows - first,
                          panel.first_row + first,
                          panel.diagonal(first)});
  }


  template <int n_columns>
  void MultifrontalFactor::eliminate(const Group &group, double *const values) const
  {
    const int    *row    = &rows[group.first_row];
    const double *column = &numbers[group.first_number];
    const double *columns[n_columns]; // without the rows of the group
    double        known[n_columns];
    for (int j = 0; j < n_columns; ++j)
      {
        double *own = values + row[0] + j;
        known[j]    = *own /= column[0];
        for (int i = 1; i < n_columns - j; ++i)
          own[i] -= column[i] * known[j];
        columns[j] = column + n_columns - j;
        column += group.n_rows - j;
      }
    row += n_columns;
    for (int p = 0; p < group.n_rows - n_columns; ++p)
      {
        double sum = 0.;
        for (int j = 0; j < n_columns; ++j)
          sum += columns[j][p] * known[j];
        values[row[p]] -= sum;
      }
  }


  template <int n_columns>
  void MultifrontalFactor::substitute(const Group &group, double *const values) const
  {
    const double *columns[n_columns], *column = &numbers[group.first_number];
    double        sums[n_columns] = {};
    for (int j = 0; j < n_columns; ++j)
      {
        columns[j] = column + n_columns - j;
        column += group.n_rows - j;
      }
    const int *row    = &rows[group.first_row] + n_columns;
    const int  n_rows = group.n_rows - n_columns;
    for (int p = 0; p < n_rows; ++p)
      {
        const double value = values[row[p]];
        for (int j = 0; j < n_columns; ++j)
          sums[j] += columns[j][p] * value;
      }
    double *const own = values + rows[group.first_row];
    for (int j = 0; j < n_columns; ++j) // so that the sums stay in registers above
      own[j] -= sums[j];
    for (int j = n_columns; j-- > 0;)
      {
        const double *diagonal = columns[j] - (n_columns - j);
        for (int i = j + 1; i < n_columns; ++i)
          own[j] -= diagonal[i - j] * own[i];
        own[j] /= diagonal[0];
      }
  }


  void MultifrontalFactor::eliminate(double *const values) const
  {
    for (const Group &group : groups)
      with_number(group.n_columns,
                  [&](const auto n_columns) { eliminate<n_columns>(group, values); });
  }


  void MultifrontalFactor::substitute(double *const values) const
  {
    for (auto group = groups.rbegin(); group != groups.rend(); ++group)
      with_number(group->n_columns,
                  [&](const auto n_columns) { substitute<n_columns>(*group, values); });
  }
} // namespace signorini
