// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/slip_scaling.h>
#include <signorini/variational_inequality/slip_system.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** Of the stiffness of a slip in terms of that of its node: its round-off may be felt. */
    constexpr double stiff = 1e3;
  } // namespace


  TangentVector tangential_entries(const FrictionNode &node, const Vector &vector)
  {
    TangentVector values = TangentVector::Zero();
    for (unsigned int j = 0; j < node.entries.size(); ++j)
      values[j] = vector.local_element(node.entries[j]);
    return values;
  }


  void
  add_to_tangential_entries(const FrictionNode &node, const TangentVector &values, Vector &vector)
  {
    for (unsigned int j = 0; j < node.entries.size(); ++j)
      vector.local_element(node.entries[j]) += values[j];
  }


  void SlipSystem::add(const unsigned int   normal,
                       const FrictionNode  &node,
                       const SlipCondition &condition,
                       const double         stiffness)
  {
    Assert(stiffness > 0., dealii::ExcMessage("The stiffness of a node is positive."));
    Assert(node.entries.size() == 1 || node.entries.size() == 2,
           dealii::ExcMessage("A node that slips has one tangential entry or two."));
    slipping.push_back(
      {normal, &node, condition, stiffness, slip_scaling<2>(condition.stiffness / stiffness)});
  }


  void SlipSystem::finish(const MPI_Comm communicator)
  {
    double most = 0.; // 1: slip, more: slip that may turn, by its stiffness
    for (const Node &node : slipping)
      most = std::max(most, 1. + node.condition.stiffness.norm() / node.stiffness);
    most     = dealii::Utilities::MPI::max(most, communicator);
    any_slip = most > 0.;
    may_turn = most > 1.;
    is_stiff = most > stiff;
  }


  /** K with the terms of the slipping nodes. */
  class SlipSystem::Jacobian : public LinearOperator
  {
  public:
    Jacobian(const LinearOperator &matrix, const std::vector<Node> &slipping)
      : matrix(matrix)
      , slipping(slipping)
    {
    }

    void vmult(Vector &destination, const Vector &source) const override
    {
      matrix.vmult(destination, source);
      for (const Node &node : slipping)
        add_to_tangential_entries(
          *node.friction,
          node.condition.stiffness * tangential_entries(*node.friction, source)
            - node.condition.coupling * destination.local_element(node.normal),
          destination);
    }

    void diagonal(Vector &destination) const override
    {
      matrix.diagonal(destination);
      for (const Node &node : slipping)
        add_to_tangential_entries(*node.friction, node.condition.stiffness.diagonal(), destination);
    }

  private:
    const LinearOperator    &matrix;
    const std::vector<Node> &slipping;
  };


  /** The preconditioner of K, scaled down where slip makes it stiff. */
  class SlipSystem::Preconditioner : public MaskedPreconditioner
  {
  public:
    Preconditioner(MaskedPreconditioner &of_matrix, const std::vector<Node> &slipping)
      : of_matrix(of_matrix)
      , slipping(slipping)
    {
    }

    void set_mask(const Mask &mask) override { of_matrix.set_mask(mask); }

    void vmult(Vector &destination, const Vector &source) const override
    {
      scaled = source;
      scale(scaled);
      of_matrix.vmult(destination, scaled);
      scale(destination);
    }

  private:
    MaskedPreconditioner    &of_matrix;
    const std::vector<Node> &slipping;
    mutable Vector           scaled;

    void scale(Vector &vector) const
    {
      for (const Node &node : slipping)
        {
          const TangentVector values = tangential_entries(*node.friction, vector);
          add_to_tangential_entries(*node.friction, node.scaling * values - values, vector);
        }
    }
  };


  std::vector<SlipRows> SlipSystem::rows() const
  {
    std::vector<SlipRows> result;
    for (const Node &node : slipping)
      result.push_back(
        {node.normal, node.friction->entries, node.condition.stiffness, node.condition.coupling});
    return result;
  }


  LinearReport SlipSystem::solve(const ConstrainedProblem &problem,
                                 Vector                   &residual,
                                 Vector                   &correction,
                                 const LimitsFor          &limits_for)
  {
    const Jacobian jacobian(problem.matrix, slipping);
    unbalance(residual);
    LinearReport report;
    if (const RoughSolver *rough_solver = problem.preconditioner.rough_solver_with(rows()))
      {
        correction.reinit(residual);
        report = refinement.solve(*rough_solver, jacobian, correction, unbalanced, limits_for);
        norm_at_start = refinement.initial_norm();
        lost          = 0.; // residuals are computed anew
      }
    else
      {
        const Preconditioner preconditioner(problem.preconditioner, slipping);
        report = gmres.solve(
          [&](Vector &destination, const Vector &source) { jacobian.vmult(destination, source); },
          [&](Vector &destination, const Vector &source) {
            preconditioner.vmult(destination, source);
          },
          correction,
          unbalanced,
          limits_for);
        norm_at_start = gmres.initial_norm();
        lost          = gmres.round_off();
      }
    balance(correction, residual);
    return report;
  }


  LinearReport SlipSystem::solve_symmetric(const ConstrainedProblem &problem,
                                           Vector                   &residual,
                                           Vector                   &correction,
                                           const double              tolerance,
                                           const double              reduction,
                                           const unsigned int        maximum_iterations)
  {
    Assert(std::all_of(slipping.begin(),
                       slipping.end(),
                       [](const Node &node) { return node.condition.coupling.isZero(); }),
           dealii::ExcMessage("Rows that see normal forces are not symmetric."));
    const Jacobian       jacobian(problem.matrix, slipping);
    const Preconditioner preconditioner(problem.preconditioner, slipping);
    unbalance(residual);
    correction.reinit(residual);
    const auto report = conjugate_gradients.solve(
      jacobian, preconditioner, correction, unbalanced, tolerance, reduction, maximum_iterations);
    balance(correction, residual);
    return report;
  }


  void SlipSystem::unbalance(const Vector &residual)
  {
    unbalanced = residual;
    for (const Node &node : slipping)
      add_to_tangential_entries(*node.friction, -node.condition.force, unbalanced);
  }


  void SlipSystem::balance(const Vector &correction, Vector &residual)
  {
    // The new b - K x is what is unbalanced plus the forces by the linearised law.
    law_forces.clear();
    for (const Node &node : slipping)
      {
        const double change_of_normal =
          unbalanced.local_element(node.normal) - residual.local_element(node.normal);
        law_forces.push_back(node.condition.force
                             + node.condition.stiffness
                                 * tangential_entries(*node.friction, correction)
                             + node.condition.coupling * change_of_normal);
        add_to_tangential_entries(*node.friction, law_forces.back(), unbalanced);
      }
    residual.swap(unbalanced);
    if (is_stiff)
      lost = std::max(lost, round_off_of_slip(correction));
  }


  double SlipSystem::round_off_of_slip(const Vector &correction) const
  {
    double square = 0.;
    for (const Node &node : slipping)
      square +=
        (node.condition.stiffness * tangential_entries(*node.friction, correction)).squaredNorm()
        / node.stiffness;
    return std::numeric_limits<double>::epsilon()
           * std::sqrt(dealii::Utilities::MPI::sum(square, correction.get_mpi_communicator()));
  }
} // namespace signorini
