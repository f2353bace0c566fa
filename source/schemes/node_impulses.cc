// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/fixed_point.h>
#include <signorini/schemes/node_impulses.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <random>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_probes = 4;
    // Changes of velocity in an iteration, relative to the largest velocity.
    constexpr FixedPoint::Limits impulse_limits{1e-10, 1e-8, 200};

    /** The equations of the nodes with a force, in unknowns without unit. */
    class NodeEquations
    {
    public:
      NodeEquations(DynamicalSystem &system, const NodeContact &contact);

      bool trivial() const { return speed == 0.; }

      /** A vector of unknowns y_p = D_p I_p / speed, zero. */
      Vector make_unknowns() const { return unknowns; }

      /** next = the solutions of the equations of the single nodes. @return the largest change */
      double iterate(const Vector &current, Vector &next) const;

      /** I of all contact nodes. */
      std::vector<double> impulses(const Vector &values) const;

    private:
      DynamicalSystem          &system;
      const NormalGap          &approach;
      std::vector<unsigned int> nodes;      ///< those with a force
      std::vector<double>       work;       ///< Lambda_p gamma_p of each of them
      std::vector<double>       diagonal;   ///< D_p
      double                    speed = 0.; ///< the largest velocity that may appear
      Vector                    unknowns;

      /** G I at all contact nodes. */
      NormalGap response(const std::vector<double> &impulses) const
      {
        return system.relative_normal(
          system.solve_mass(system.capabilities().impulses->normal_forces(impulses)));
      }

      void estimate_diagonal();
    };


    NodeEquations::NodeEquations(DynamicalSystem &system, const NodeContact &contact)
      : system(system)
      , approach(contact.approach)
    {
      for (unsigned int p = 0; p < contact.force.size(); ++p)
        if (contact.force[p] > 0.)
          {
            nodes.push_back(p);
            work.push_back(contact.force[p]
                           * std::max(0., contact.gap[p])); // below zero by round-off
          }
      estimate_diagonal();

      const MPI_Comm communicator = system.make_vector().get_mpi_communicator();
      for (unsigned int k = 0; k < nodes.size(); ++k)
        speed =
          std::max(speed, std::abs(approach[nodes[k]]) + std::sqrt(2. * diagonal[k] * work[k]));
      speed = Utilities::MPI::max(speed, communicator);

      unknowns = FixedPoint::make_unknowns(nodes.size(), communicator);
    }


    void NodeEquations::estimate_diagonal()
    {
      diagonal.assign(nodes.size(), 0.);
      std::mt19937 random; // the same numbers in each step: a step depends on the state alone
      std::vector<double> signs(approach.size(), 0.);
      for (unsigned int probe = 0; probe < n_probes; ++probe)
        {
          for (const unsigned int p : nodes)
            signs[p] = random() % 2 ? 1. : -1.;
          const NormalGap product = response(signs);
          for (unsigned int k = 0; k < nodes.size(); ++k)
            diagonal[k] += product[nodes[k]] * product[nodes[k]] / n_probes;
        }
      for (double &entry : diagonal)
        entry = std::sqrt(entry);
    }


    std::vector<double> NodeEquations::impulses(const Vector &values) const
    {
      std::vector<double> result(approach.size(), 0.);
      for (unsigned int k = 0; k < nodes.size(); ++k)
        result[nodes[k]] = speed / diagonal[k] * values.local_element(k);
      return result;
    }


    double NodeEquations::iterate(const Vector &current, Vector &next) const
    {
      const NormalGap change = response(impulses(current));
      next                   = 0.;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        {
          const double omega =
            approach[nodes[k]] - 0.5 * change[nodes[k]] + 0.5 * speed * current.local_element(k);
          const double root = std::sqrt(omega * omega + 2. * diagonal[k] * work[k]);
          // omega + root without cancellation
          const double lost     = 2. * diagonal[k] * work[k];
          const double below    = lost > 0. ? lost / (root - omega) : 0.;
          const double sum      = omega > 0. ? omega + root : below;
          next.local_element(k) = sum / speed;
        }
      Vector difference = next;
      difference -= current;
      return difference.linfty_norm();
    }
  } // namespace


  NodeImpulses solve_node_impulses(DynamicalSystem &system, const NodeContact &contact)
  {
    const NodeEquations equations(system, contact);
    const auto          iterate = [&](const Vector &current, Vector &next) {
      return equations.iterate(current, next);
    };
    FixedPoint   fixed_point(iterate, equations.make_unknowns(), impulse_limits);
    NodeImpulses result;
    if (!equations.trivial())
      for (const unsigned int depth :
           {FixedPoint::usual_depth,
            0U}) // acceleration may lead astray, the plain iteration descends
        if (!fixed_point.converged())
          fixed_point.run(depth);
    result.iterations = fixed_point.n_iterations();
    result.converged  = equations.trivial() || fixed_point.converged();
    result.impulses   = equations.impulses(fixed_point.best());
    return result;
  }
} // namespace signorini
