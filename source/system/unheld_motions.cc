// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What nothing holds in a solution of a StaticEquilibrium: motions, and whether they are driven.

#include <signorini/system/motion_in_words.h>
#include <signorini/system/static_equilibrium.h>
#include <signorini/variational_inequality/slip_system.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * Of the stiffness of a node: what resists the turning of its slip, bound over slip, is nothing
     * below. Bodies that slide without end come here.
     */
    constexpr double turning = 1e-3;

    /** Forces on rigid motions, relative to all that acts on them, that are none. */
    constexpr double balanced = 1e-7;

    /** The same, of a body that creeps along without end: friction does not see so little. */
    constexpr double hardly_unbalanced = 1e-6;
  } // namespace


  template <int dim>
  Eigen::MatrixXd StaticEquilibrium<dim>::free_motions(const StaticProblem   &problem,
                                                       const StaticSolution  &solution,
                                                       const Eigen::VectorXd &drive) const
  {
    const std::vector<unsigned int> held = coordinates.held_entries(solution.status);
    if (!with_friction || solution.n_steps > patience_with_slip)
      return rigid.free_amplitudes(held);

    std::vector<HeldDirection> directions; // slip of nodes, along and across
    const auto                 for_each_slip = [&](const auto &action) {
      for (std::size_t k = 0; k < problem.friction.size(); ++k)
        {
          const FrictionNode &node = problem.friction[k];
          if (solution.status[k] != contact_status::slip || node.entries.empty())
            continue;
          const NodeForces forces = node_forces(
            node, coordinates.normal_entries()[k], true, solution.increment, solution.residual);
          const double slip = forces.slip.norm(), bound = node.law.bound(forces.normal);
          if (slip > 0. && bound > turning * diagonal.local_element(node.entries[0]) * slip)
            action(node.entries, TangentVector(forces.slip / slip));
        }
    };
    for_each_slip([&](const std::vector<unsigned int> &entries, const TangentVector &along) {
      if (entries.size() > 1)
        directions.push_back({{{entries[0], entries[1]}}, {{-along[1], along[0]}}});
    });
    const Eigen::MatrixXd free = rigid.free_amplitudes(held, directions);
    Vector                motion(discretization.make_vector());
    rigid.add_in_contact(free * (free.transpose() * drive), motion);
    for_each_slip([&](const std::vector<unsigned int> &entries, const TangentVector &along) {
      double forwards = 0.;
      for (unsigned int j = 0; j < entries.size(); ++j)
        forwards += along[j] * motion.local_element(entries[j]);
      if (forwards < 0.)
        directions.push_back(
          {{{entries.front(), entries.back()}}, {{along[0], entries.size() > 1 ? along[1] : 0.}}});
    });
    return rigid.free_amplitudes(held, directions);
  }


  template <int dim>
  Eigen::MatrixXd StaticEquilibrium<dim>::springs(const Eigen::MatrixXd &free) const
  {
    return stiffness_of_springs
           * (weakness * loose * loose.transpose() + (1. - weakness) * free * free.transpose());
  }


  template <int dim>
  Eigen::MatrixXd StaticEquilibrium<dim>::motions_without_slip(const StaticProblem  &problem,
                                                               const StaticSolution &solution) const
  {
    std::vector<unsigned int> held = coordinates.held_entries(solution.status);
    for (std::size_t k = 0; k < problem.friction.size(); ++k)
      if (solution.status[k] == contact_status::slip)
        held.insert(
          held.end(), problem.friction[k].entries.begin(), problem.friction[k].entries.end());
    return rigid.free_amplitudes(held);
  }


  template <int dim>
  double StaticEquilibrium<dim>::unbalanced_part(const StaticProblem   &problem,
                                                 const StaticSolution  &solution,
                                                 const Eigen::VectorXd &forces) const
  {
    Vector force = problem.force;
    coordinates.force_to_contact(force);
    for (unsigned int i = 0; i < force.locally_owned_size(); ++i)
      force.local_element(i) =
        std::abs(force.local_element(i)) + std::abs(solution.residual.local_element(i));
    const Eigen::VectorXd  all     = rigid.sizes_of_products(force);
    constexpr Eigen::Index n       = RigidModes<dim>::n_motions;
    double                 largest = 0.;
    for (Eigen::Index first = 0; first < all.size(); first += n) // body by body
      if (const double on_body = forces.segment(first, n).norm(); on_body > 0.)
        largest = std::max(largest, on_body / all.segment(first, n).norm());
    return largest;
  }


  template <int dim>
  bool StaticEquilibrium<dim>::is_driven(const StaticProblem  &problem,
                                         const StaticSolution &solution,
                                         const double          error) const
  {
    return solution.acceleration.norm() > 10. * error * std::sqrt(stiffness_of_springs)
           && unbalanced_part(problem, solution, solution.acceleration) > balanced;
  }


  template <int dim>
  bool StaticEquilibrium<dim>::goes_on_creeping(const StaticProblem   &problem,
                                                const StaticSolution  &solution,
                                                const Eigen::VectorXd &drive) const
  {
    return solution.n_steps == patience_with_slip
           && unbalanced_part(problem, solution, drive) <= hardly_unbalanced;
  }


  template <int dim>
  std::string StaticEquilibrium<dim>::unheld_motion(const StaticSolution &solution) const
  {
    std::vector<std::string> names;
    for (const auto &body : discretization.mesh().bodies())
      names.push_back(body.name);
    return motion_in_words(names, rigid, solution.acceleration);
  }

#define INSTANTIATE(dim)                                                                           \
  template Eigen::MatrixXd StaticEquilibrium<dim>::free_motions(                                   \
    const StaticProblem &, const StaticSolution &, const Eigen::VectorXd &) const;                 \
  template Eigen::MatrixXd StaticEquilibrium<dim>::motions_without_slip(                           \
    const StaticProblem &, const StaticSolution &) const;                                          \
  template Eigen::MatrixXd StaticEquilibrium<dim>::springs(const Eigen::MatrixXd &) const;         \
  template double          StaticEquilibrium<dim>::unbalanced_part(                                \
    const StaticProblem &, const StaticSolution &, const Eigen::VectorXd &) const;        \
  template bool StaticEquilibrium<dim>::is_driven(                                                 \
    const StaticProblem &, const StaticSolution &, double) const;                                  \
  template bool StaticEquilibrium<dim>::goes_on_creeping(                                          \
    const StaticProblem &, const StaticSolution &, const Eigen::VectorXd &) const;                 \
  template std::string StaticEquilibrium<dim>::unheld_motion(const StaticSolution &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
