// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/fclib/frictional_problem.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace signorini
{
  namespace
  {
    /** W is full: 500 contacts in 3d are 27 MB in the file. */
    constexpr unsigned int most_contacts = 500;
    /** The factor of M takes seconds. */
    constexpr unsigned int most_unknowns_2d = 100000, most_unknowns_3d = 10000;


    using Matrix      = FrictionalProblem::Matrix;
    using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

    /** Little fill-in, but the unknowns that contacts move come last. */
    Permutation order_contacts_last(const FrictionalProblem &problem)
    {
      Permutation order;
      Eigen::AMDOrdering<int>()(problem.M.selfadjointView<Eigen::Lower>(), order);
      std::vector<char> moved(problem.M.rows(), false);
      for (Eigen::Index column = 0; column < problem.H.outerSize(); ++column)
        for (Matrix::InnerIterator entry(problem.H, column); entry; ++entry)
          moved[entry.row()] = true;
      auto &indices = order.indices(); // of the unknowns, one after the other
      std::stable_partition(
        indices.data(), indices.data() + indices.size(), [&](const int i) { return !moved[i]; });
      return order.inverse();
    }


    Matrix reordered(const Matrix &matrix, const Permutation &order)
    {
      Matrix result;
      result = matrix.twistedBy(order);
      return result;
    }


    /** M = P' L L' P: W is X'X with X = L^-1 P H, of which only the last rows are not zero. */
    class Factor
    {
    public:
      explicit Factor(const FrictionalProblem &problem)
        : matrix(problem.M)
        , order(order_contacts_last(problem))
        , factor(reordered(matrix, order))
      {
        if (factor.info() != Eigen::Success)
          throw RunError("The matrix of the step has no factor for the local form of FCLIB.");
      }

      Eigen::MatrixXd half_of_inverse(const Matrix &right_hand_sides) const
      {
        using RowByRow     = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        RowByRow    result = order * right_hand_sides;
        const auto &lower  = factor.matrixL().nestedExpression();
        for (Eigen::Index column = 0; column < lower.cols(); ++column)
          {
            auto row = result.row(column);
            if (row.isZero(0.))
              continue;
            typename std::decay_t<decltype(lower)>::InnerIterator entry(lower, column);
            row /= entry.value(); // a column begins with its diagonal
            while (++entry)
              result.row(entry.row()) -= entry.value() * row;
          }
        return result;
      }

      /** The residual of the factor is solved for once more. */
      Eigen::VectorXd solve(const Eigen::VectorXd &right_hand_side) const
      {
        Eigen::VectorXd       result   = solve_once(right_hand_side);
        const Eigen::VectorXd residual = right_hand_side - matrix * result;
        return result + solve_once(residual);
      }

    private:
      const Matrix                                                                 &matrix;
      const Permutation                                                             order;
      const Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor;

      Eigen::VectorXd solve_once(const Eigen::VectorXd &right_hand_side) const
      {
        const Eigen::VectorXd ordered = order * right_hand_side;
        return order.inverse() * factor.solve(ordered).eval();
      }
    };
  } // namespace


  bool has_local_form(const FrictionalProblem &problem)
  {
    return problem.mu.size() <= most_contacts
           && problem.M.rows() <= (problem.dim == 2 ? most_unknowns_2d : most_unknowns_3d);
  }


  LocalForm local_form(const FrictionalProblem &problem)
  {
    const Factor          factor(problem);
    const Eigen::MatrixXd half = factor.half_of_inverse(problem.H);
    const Eigen::MatrixXd W    = half.transpose() * half;
    return {W.sparseView(), problem.H.transpose() * factor.solve(problem.f) + problem.w};
  }
} // namespace signorini
