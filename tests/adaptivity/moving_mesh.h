// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_adaptivity_moving_mesh_h
#define signorini_tests_adaptivity_moving_mesh_h

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/energy_ledger.h>
#include <signorini/diagnostics/momentum.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/change_mesh.h>
#include <signorini/simulation/initial_state.h>

#include <random>
#include <sstream>

namespace signorini::tests
{
  /** The unit square or cube on a coordinate plane that is moved up to a height. */
  template <int dim>
  BodyDescription<dim> box(const std::string &name, const double bottom)
  {
    dealii::Point<dim> lower, upper;
    for (unsigned int c = 0; c < dim; ++c)
      upper[c] = 1.;
    lower[dim - 1] += bottom;
    upper[dim - 1] += bottom;
    std::array<unsigned int, dim> repetitions;
    repetitions.fill(1);
    BodyDescription<dim> body = block<dim>(name, lower, upper, repetitions);
    body.refinements          = 1;
    return body;
  }

  /** A scene in motion on a mesh that changes at random, the same on any number of processes. */
  template <int dim>
  struct MovingMesh
  {
    explicit MovingMesh(const Scene<dim> &scene)
      : scene(scene)
      , timer(MPI_COMM_SELF,
              timer_text,
              dealii::TimerOutput::never,
              dealii::TimerOutput::wall_times)
      , mesh(scene.bodies, MPI_COMM_WORLD, scene.mapping, true)
      , meshed(std::make_unique<MeshedScene<dim>>(mesh, this->scene, scene.time.n_steps(), timer))
      , scheme(make_time_scheme(scene.time.scheme))
    {
      state = initial_state(meshed->discretization);
      meshed->system.apply_mass(state.momentum, state.velocity);
      meshed->system.apply_stiffness(state.internal_force, state.displacement);
      ledger.open(state, meshed->load(0.));
      meshed->system.see(
        {ledger.current().kinetic + ledger.current().elastic, ledger.current().elastic});
    }

    /** Refine and coarsen a few cells anywhere. */
    void
    change_at_random(const unsigned int highest_level, const double refined, const double coarsened)
    {
      ++n_changes;
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            // The dice know the cell, not the process. A family is coarsened together.
            const bool         family = cell->level() > 0;
            std::ostringstream name;
            name << n_changes << ' ';
            const double mine = dice(name.str() + cell->id().to_string());
            const double ours = family ? dice(name.str() + cell->parent()->id().to_string()) : 1.;
            if (mine < refined && cell->level() < static_cast<int>(highest_level))
              cell->set_refine_flag();
            else if (ours < coarsened
                     && cell->level()
                          > static_cast<int>(scene.bodies[cell->material_id()].refinements))
              cell->set_coarsen_flag();
          }
      change();
    }

    /** Carry out the flags. */
    void change()
    {
      change_mesh(mesh, scene, scene.time.n_steps(), meshed, state, timer);
      ledger.transfer(state, meshed->load(state.time));
    }

    /** One step. */
    EnergyBooking advance(const double step_size)
    {
      const StepReport report = scheme->advance(meshed->system, state, step_size);
      effort                  = report.corrector;
      return ledger.book(state, report, meshed->load(state.time));
    }

    double total_energy() const { return ledger.current().total(); }

    static double dice(const std::string &name)
    {
      std::seed_seq seed(name.begin(), name.end());
      return std::generate_canonical<double, 53>(*std::make_unique<std::mt19937>(seed));
    }

    const Scene<dim>                  scene;
    std::ostringstream                timer_text;
    dealii::TimerOutput               timer;
    Mesh<dim>                         mesh;
    std::unique_ptr<MeshedScene<dim>> meshed;
    std::unique_ptr<TimeScheme>       scheme;
    State                             state;
    EnergyLedger                      ledger;
    SolveReport                       effort; ///< of the last step
    unsigned int                      n_changes = 0;
  };
} // namespace signorini::tests

#endif
