// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_verification_frictional_motion_h
#define signorini_tests_verification_frictional_motion_h

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/diagnostics/energy_ledger.h>
#include <signorini/diagnostics/momentum.h>
#include <signorini/mass/redistribute_mass.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/meshed_scene.h>

namespace signorini::tests
{
  /** The real system, which remembers the last inequality that it solved. */
  template <int dim>
  class RecordingSystem : public ElasticContactSystem<dim>
  {
  public:
    using ElasticContactSystem<dim>::ElasticContactSystem;

    void solve(const IncrementProblem &problem, IncrementSolution &result) override
    {
      bounds           = problem.bounds;
      right_hand_side  = problem.right_hand_side;
      stiffness_factor = problem.stiffness_factor;
      force_factor     = problem.force_factor;
      further_reaction = problem.further_reaction == nullptr
                           ? ElasticContactSystem<dim>::make_vector()
                           : *problem.further_reaction;
      ElasticContactSystem<dim>::solve(problem, result);
      solution = result;
    }

    IncrementSolution solution;
    NormalGap         bounds;
    Vector            right_hand_side, further_reaction; ///< the last one zero if there is none
    double            stiffness_factor = 0., force_factor = 0.;
  };

  /** What of a scene is the same for all motions: mesh, contact, mass. */
  template <int dim>
  struct FrictionalBodies : public MappedAssembled<dim>
  {
    explicit FrictionalBodies(const Scene<dim> &scene, const Map<dim> &map = {})
      : MappedAssembled<dim>(scene, map)
      , dirichlet(this->discretization)
      , surface(this->discretization, dirichlet, scene.obstacles, scene.pairs)
      , mass_note(redistribute_mass(this->discretization, surface, scene.time.mass))
      , coordinates(this->discretization, surface, dirichlet)
    {
    }

    /**
     * Nodal values of a function of the reference position of the nodes of the first body; zero
     * elsewhere.
     */
    Vector of_first_body(
      const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &function) const
    {
      const auto &pattern = this->discretization.matrices().pattern;
      Vector      result  = this->discretization.make_vector();
      for (const auto &cell : this->discretization.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == 0)
          for (const unsigned int v : cell->vertex_indices())
            if (const auto dof = cell->vertex_dof_index(v, 0);
                pattern.partitioner->in_local_range(dof))
              if (const unsigned int first = pattern.partitioner->global_to_local(dof);
                  !pattern.is_empty(first / dim))
                {
                  const auto value = function(this->discretization.node_positions()[first / dim]);
                  for (unsigned int c = 0; c < dim; ++c)
                    result.local_element(first + c) = value[c];
                }
      return result;
    }

    const DirichletConditions<dim> dirichlet;
    const ContactSurface<dim>      surface;
    const std::string              mass_note;
    const ContactCoordinates<dim>  coordinates;
  };

  /** A motion of bodies by a scheme, step after step, with its energies. */
  template <int dim>
  struct FrictionalMotion
  {
    FrictionalMotion(const FrictionalBodies<dim> &bodies,
                     const std::string           &scheme,
                     const Vector                &displacement,
                     const Vector                &velocity,
                     const bool                   stop_sticking_nodes = true)
      : bodies(bodies)
      , loads(bodies.discretization)
      , timer(MPI_COMM_SELF, std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times)
      , system(bodies.discretization,
               bodies.surface,
               bodies.coordinates,
               loads,
               system_parameters(bodies.scene),
               timer)
      , scheme(make_time_scheme(scheme, parameters(stop_sticking_nodes)))
    {
      state.displacement   = displacement;
      state.velocity       = velocity;
      state.contact_force  = bodies.discretization.make_vector();
      state.momentum       = state.contact_force;
      state.internal_force = state.contact_force;
      system.apply_mass(state.momentum, state.velocity);
      system.apply_stiffness(state.internal_force, state.displacement);
      ledger.open(state, nullptr);
      system.see({ledger.initial().total(), ledger.initial().total()});
    }

    void step(const double step_size)
    {
      const double before = ledger.current().total();
      report              = scheme->advance(system, state, step_size);
      booking             = ledger.book(state, report, nullptr);
      energy_change       = ledger.current().total() - before;
      system.see({ledger.current().kinetic + ledger.current().elastic, ledger.current().elastic});
    }

    const FrictionalBodies<dim> &bodies;
    Loads<dim>                   loads;
    dealii::TimerOutput          timer;
    RecordingSystem<dim>         system;
    std::unique_ptr<TimeScheme>  scheme;
    State                        state;
    EnergyLedger                 ledger;
    StepReport                   report;  ///< of the last step
    EnergyBooking                booking; ///< of the last step
    double                       energy_change = 0.;

  private:
    static SchemeParameters parameters(const bool stop_sticking_nodes)
    {
      SchemeParameters result;
      result.stop_sticking_nodes = stop_sticking_nodes;
      return result;
    }
  };

  inline double largest_of_all_processes(const double value)
  {
    return dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
  }

  inline unsigned int sum_of_all_processes(const unsigned int value)
  {
    return dealii::Utilities::MPI::sum(value, MPI_COMM_WORLD);
  }
} // namespace signorini::tests

#endif
