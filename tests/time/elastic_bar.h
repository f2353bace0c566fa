// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_elastic_bar_h
#define signorini_tests_elastic_bar_h

// A bar of linear finite elements between two walls. Its inequalities are solved by trying all
// active sets.

#include <signorini/base/user_error.h>
#include <signorini/schemes/scheme_table.h>

#include <Eigen/Dense>

#include <functional>
#include <limits>

namespace signorini
{
  class ElasticBar : public DynamicalSystem,
                     private MassProjections,
                     protected NodalImpulses,
                     private MasslessNodes,
                     private MovingDirichletConditions,
                     private ViscousDamping,
                     private StaticProblems
  {
  public:
    /**
     * Consistent mass and stiffness of n nodes; the ends are the contact nodes, with normals -1
     * and +1.
     */
    explicit ElasticBar(const unsigned int n)
      : mass(Eigen::MatrixXd::Zero(n, n))
      , stiffness(mass)
    {
      for (unsigned int i = 0; i + 1 < n; ++i)
        {
          mass.block<2, 2>(i, i) += Eigen::Matrix2d{{2., 1.}, {1., 2.}} / (6. * (n - 1));
          stiffness.block<2, 2>(i, i) += Eigen::Matrix2d{{1., -1.}, {-1., 1.}} * (n - 1);
        }
    }

    /** Redistribute the mass of both ends: they follow the two nodes behind them linearly. */
    void remove_mass_of_ends()
    {
      const unsigned int n = mass.rows();
      Eigen::MatrixXd    P = Eigen::MatrixXd::Identity(n, n);
      for (const auto &[end, first, second] :
           {std::array<unsigned int, 3>{{0, 1, 2}}, {{n - 1, n - 2, n - 3}}})
        {
          P(end, end)    = 0.;
          P(end, first)  = 2.;
          P(end, second) = -1.;
        }
      mass     = (P.transpose() * mass * P).eval();
      massless = {0, n - 1};
    }

    Eigen::MatrixXd           mass, stiffness;
    Eigen::MatrixXd           damping; ///< empty: none
    std::vector<unsigned int> massless;
    std::array<double, 2>     distance = {{0.3, 0.3}};
    std::function<double(double)>
      motion; ///< prescribed displacement of the node in the middle; empty: none
    std::function<double(double)> load; ///< force on all nodes; empty: none

    Vector make_vector() const override { return Vector(mass.rows()); }

    void apply_mass(Vector &destination, const Vector &source) const override
    {
      view(destination) = mass * view(source);
    }

    void apply_stiffness(Vector &destination, const Vector &source) const override
    {
      view(destination) = stiffness * view(source);
    }

    void add_load(Vector &destination, const double factor, const double time) override
    {
      if (load)
        destination.add(factor * load(time));
    }

    Capabilities capabilities() override
    {
      return {this, this, this, this, damping.size() > 0 ? this : nullptr, this};
    }

    NormalGap normal_gap(const Vector &u) const override
    {
      return {distance[0] + u(0), distance[1] - u(u.size() - 1)};
    }

    NormalGap relative_normal(const Vector &motion) const override
    {
      return {-motion(0), motion(motion.size() - 1)};
    }

    NormalGap own_normal_forces(const Vector &nodal_forces) const override
    {
      return relative_normal(nodal_forces);
    }

    double length() const override { return 1.; }

    Vector solve_mass(const Vector &force) override
    {
      Vector          result = make_vector();
      Eigen::MatrixXd M      = mass;
      Eigen::VectorXd b      = view(force);
      for (const unsigned int i : massless)
        {
          M(i, i) = 1.;
          b[i]    = 0.;
        }
      if (motion)
        {
          const unsigned int middle = mass.rows() / 2;
          M.row(middle).setZero();
          M.col(middle).setZero();
          M(middle, middle) = 1.;
          b[middle]         = 0.;
        }
      view(result) = M.ldlt().solve(b);
      return result;
    }

    void solve(const IncrementProblem &problem, IncrementSolution &solution) override
    {
      Eigen::MatrixXd K = mass + problem.stiffness_factor * stiffness;
      if (damping.size() > 0)
        K += problem.damping_factor * damping;
      find_increment(
        K, problem.right_hand_side, problem.bounds, problem.start, problem.step_size, solution);
    }

  protected:
    Vector normal_forces(const std::vector<double> &forces) const override
    {
      Vector result  = make_vector();
      result(0)      = -forces[0];
      result(last()) = forces[1];
      return result;
    }

  private:
    std::vector<unsigned int> massless_entries() const override { return massless; }

    void equilibrate(const LoadStep &step, IncrementSolution &solution) override
    {
      find_increment(stiffness, step.force, step.bounds, step.start, step.step_size, solution);
    }

    void find_increment(const Eigen::MatrixXd &K,
                        const Vector          &force,
                        const NormalGap       &bounds,
                        const State           &start,
                        const double           step_size,
                        IncrementSolution     &solution) const
    {
      const unsigned int middle = mass.rows() / 2;
      solution.increment = solution.contact_reaction = solution.dirichlet_reaction = make_vector();
      const double moved =
        motion ? motion(start.time + step_size) - start.displacement(middle) : 0.;
      const auto b                   = view(force);
      view(solution.increment)       = minimise(K, b, bounds, motion ? &moved : nullptr);
      const Eigen::VectorXd reaction = K * view(solution.increment) - b;
      // Exactly zero where there is no contact, as in the real system.
      if (-solution.increment(0) > bounds[0] - 1e-13)
        solution.contact_reaction(0) = reaction[0];
      if (solution.increment(last()) > bounds[1] - 1e-13)
        solution.contact_reaction(last()) = reaction[last()];
      solution.normal_reaction = relative_normal(solution.contact_reaction);
      if (motion)
        solution.dirichlet_reaction(middle) = reaction[middle];
    }

    void apply_damping(Vector &destination, const Vector &velocity) const override
    {
      view(destination) = damping * view(velocity);
    }

    /** No test integrates this system with the reference. */
    SolveReport equilibrate_massless(Vector &, const Vector &, Vector &) override
    {
      throw RunError("not there");
    }

    void stop_at_dirichlet(Vector &velocity) const override
    {
      if (motion)
        velocity(mass.rows() / 2) = 0.;
    }

    SolveReport project(const Vector    &free_increment,
                        const NormalGap &bounds,
                        double,
                        Vector &correction,
                        Vector &mass_correction) override
    {
      correction = mass_correction = make_vector();
      const double    fixed        = 0.; // prescribed nodes are not corrected
      const NormalGap left = {bounds[0] + free_increment(0), bounds[1] - free_increment(last())};
      view(correction) =
        minimise(mass, Eigen::VectorXd::Zero(mass.rows()), left, motion ? &fixed : nullptr);
      apply_mass(mass_correction, correction);
      SolveReport effort;
      effort.n_active = correction.linfty_norm() > 0.;
      return effort;
    }

    SolveReport stop_relative_motion(const Vector    &velocity,
                                     const ActiveSet &held,
                                     Vector          &correction,
                                     Vector          &mass_correction) override
    {
      correction = mass_correction = make_vector();
      Eigen::MatrixXd matrix       = mass;
      Eigen::VectorXd right        = Eigen::VectorXd::Zero(mass.rows());
      const auto      prescribe    = [&](const unsigned int i, const double value) {
        matrix.row(i).setZero();
        matrix(i, i) = 1.;
        right[i]     = value;
      };
      if (held[0])
        prescribe(0, -velocity(0));
      if (held[1])
        prescribe(last(), -velocity(last()));
      if (motion)
        prescribe(mass.rows() / 2, 0.);
      view(correction) = matrix.partialPivLu().solve(right);
      apply_mass(mass_correction, correction);
      SolveReport effort;
      effort.n_active = (held[0] != contact_status::open) + (held[1] != contact_status::open);
      return effort;
    }

    Vector dirichlet_part(const Vector &forces) const override
    {
      Vector             part   = make_vector();
      const unsigned int middle = mass.rows() / 2;
      if (motion)
        part(middle) = forces(middle);
      return part;
    }

    unsigned int last() const { return mass.rows() - 1; }

    static Eigen::Map<Eigen::VectorXd> view(Vector &x)
    {
      return {x.begin(), static_cast<Eigen::Index>(x.size())};
    }

    static Eigen::Map<const Eigen::VectorXd> view(const Vector &x)
    {
      return {x.begin(), static_cast<Eigen::Index>(x.size())};
    }

    /**
     * Least 1/2 x'Kx - b'x with -x_0 and x_last below their bounds, and perhaps the middle node
     * moved. A static bar that nothing holds is left where it is, on average, if b balances.
     */
    Eigen::VectorXd minimise(const Eigen::MatrixXd &K,
                             const Eigen::VectorXd &b,
                             const NormalGap       &bounds,
                             const double          *moved = nullptr) const
    {
      double          least = std::numeric_limits<double>::infinity();
      Eigen::VectorXd best;
      for (unsigned int set = 0; set < 4; ++set)
        {
          Eigen::MatrixXd matrix    = K;
          Eigen::VectorXd right     = b;
          const auto      prescribe = [&](const unsigned int i, const double value) {
            matrix.row(i).setZero();
            matrix(i, i) = 1.;
            right[i]     = value;
          };
          if (set & 1)
            prescribe(0, -bounds[0]);
          if (set & 2)
            prescribe(last(), bounds[1]);
          if (moved)
            prescribe(mass.rows() / 2, *moved);
          const bool is_loose =
            set == 0 && !moved && (K * Eigen::VectorXd::Ones(K.rows())).norm() < 1e-9 * K.norm();
          if (is_loose && std::abs(b.sum()) > 1e-9)
            continue;
          const Eigen::VectorXd x =
            is_loose ? Eigen::VectorXd(matrix.completeOrthogonalDecomposition().solve(right))
                     : Eigen::VectorXd(matrix.partialPivLu().solve(right));
          const double value = 0.5 * x.dot(K * x) - b.dot(x);
          if (-x[0] <= bounds[0] + 1e-14 && x[last()] <= bounds[1] + 1e-14 && value < least)
            {
              least = value;
              best  = x;
            }
        }
      return best;
    }
  };
} // namespace signorini

#endif
