// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/step_friction.h>
#include <signorini/variational_inequality/node_stiffness.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  namespace
  {
    /** Of a node for all but the solver: an open one that others press is closed, and none hangs.
     */
    char reported_status(const char status, const bool pressed)
    {
      if (contact_status::is_closed(status))
        return status;
      if (!pressed)
        return contact_status::open;
      return contact_status::sticks(status) ? contact_status::stick : contact_status::slip;
    }
  } // namespace


  template <int dim>
  StepFriction<dim>::StepFriction(const ContactCoordinates<dim> &coordinates,
                                  const bool                     may_come,
                                  const MPI_Comm                 communicator)
    : coordinates(coordinates)
  {
    unsigned int n = 0;
    for (const auto &entries : coordinates.tangential_entries())
      n += entries.size();
    has_friction = dealii::Utilities::MPI::max(n, communicator) > 0 || may_come;
  }


  template <int dim>
  Friction StepFriction<dim>::of_step(const double     factor,
                                      const NormalGap &bounds,
                                      const double     touching,
                                      const Vector    *further_reaction) const
  {
    AssertDimension(bounds.size(), coordinates.surface_nodes().size());
    Assert(touching >= 0., dealii::ExcMessage("The distance of touching is a length."));
    Vector further;
    if (further_reaction != nullptr)
      {
        further = *further_reaction;
        coordinates.force_to_contact(further);
      }
    const auto &nodes = coordinates.surface_nodes();
    Friction    friction(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        friction[k].entries = coordinates.tangential_entries()[k];
        FrictionLaw &law    = friction[k].law;
        law                 = nodes[k].friction.scaled(factor);
        if (bounds[k] > touching)
          law.constant = 0.;
        if (further_reaction != nullptr)
          law.constant -=
            law.coefficient * std::min(0., further.local_element(coordinates.normal_entries()[k]));
      }
    return friction;
  }


  template <int dim>
  void StepFriction<dim>::extract(const Friction       &friction,
                                  const ActiveSet      &status,
                                  const Vector         &increment,
                                  const Vector         &residual,
                                  const LinearOperator &matrix,
                                  const bool            pressed_from_elsewhere,
                                  IncrementSolution    &solution,
                                  const SlipForces      slip_forces) const
  {
    AssertDimension(friction.size(), status.size());
    AssertDimension(status.size(), coordinates.normal_entries().size());
    AssertDimension(residual.size(), increment.size());
    solution.friction_reaction.reinit(increment);
    solution.slip.reinit(increment);
    solution.slip_length.assign(status.size(), 0.);
    solution.status.resize(status.size());
    const std::vector<double> stiffness =
      node_stiffness(matrix, coordinates.normal_entries(), friction, increment);
    double work = 0.;
    for (std::size_t k = 0; k < status.size(); ++k)
      {
        const FrictionNode &node   = friction[k];
        const bool          closed = contact_status::is_closed(status[k]);
        const NodeForces    forces =
          node_forces(node, coordinates.normal_entries()[k], closed, increment, residual);
        const bool sticks = contact_status::sticks(status[k]);
        solution.status[k] =
          reported_status(status[k], pressed_from_elsewhere && node.law.constant > 0.);
        if (node.entries.empty() || (!sticks && node.law.bound(forces.normal) == 0.))
          continue;
        const TangentVector force = sticks || slip_forces == SlipForces::of_residual
                                      ? forces.tangential
                                      : slip_force(node.law, forces, stiffness[k]);
        for (unsigned int j = 0; j < node.entries.size(); ++j)
          {
            solution.friction_reaction.local_element(node.entries[j]) = -force[j];
            solution.slip.local_element(node.entries[j])              = forces.slip[j];
          }
        solution.slip_length[k] = forces.slip.norm();
        work -= force.dot(forces.slip);
      }
    solution.friction_work = dealii::Utilities::MPI::sum(work, increment.get_mpi_communicator());
    coordinates.rotate_from_frames(solution.slip);
  }


  template class StepFriction<2>;
  template class StepFriction<3>;
} // namespace signorini
