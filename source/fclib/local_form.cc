// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/fclib/frictional_problem.h>

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** W is full: 500 contacts in 3d are 27 MB in the file. */
    constexpr unsigned int most_contacts = 500;
    /** The factor of M takes seconds. */
    constexpr unsigned int most_unknowns = 30000;
    /** Columns of H that are solved for at once. */
    constexpr Eigen::Index columns_at_once = 64;


    /** M^-1 B, with the residual of the factor solved for once more. */
    class Inverse
    {
    public:
      explicit Inverse(const FrictionalProblem::Matrix &matrix)
        : matrix(matrix)
        , factor(matrix)
      {
        if (factor.info() != Eigen::Success)
          throw RunError("The matrix of the step has no factor for the local form of FCLIB.");
      }

      Eigen::MatrixXd operator()(const Eigen::MatrixXd &right_hand_sides) const
      {
        Eigen::MatrixXd       result   = factor.solve(right_hand_sides);
        const Eigen::MatrixXd residual = right_hand_sides - matrix * result;
        result += factor.solve(residual);
        return result;
      }

    private:
      const FrictionalProblem::Matrix                &matrix;
      Eigen::SimplicialLLT<FrictionalProblem::Matrix> factor;
    };
  } // namespace


  bool has_local_form(const FrictionalProblem &problem)
  {
    return problem.mu.size() <= most_contacts && problem.M.rows() <= most_unknowns;
  }


  LocalForm local_form(const FrictionalProblem &problem)
  {
    const Inverse      inverse(problem.M);
    const Eigen::Index m = problem.H.cols();
    Eigen::MatrixXd    W(m, m);
    for (Eigen::Index first = 0; first < m; first += columns_at_once)
      {
        const Eigen::Index n   = std::min(columns_at_once, m - first);
        W.middleCols(first, n) = problem.H.transpose() * inverse(problem.H.middleCols(first, n));
      }
    const Eigen::MatrixXd symmetric = 0.5 * (W + W.transpose());
    return {symmetric.sparseView(), problem.H.transpose() * inverse(problem.f) + problem.w};
  }
} // namespace signorini
