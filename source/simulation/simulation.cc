// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mass/redistribute_mass.h>
#include <signorini/output/earlier_results.h>
#include <signorini/simulation/make_time_stepping.h>
#include <signorini/simulation/simulation.h>
#include <signorini/system/static_equilibrium.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  Simulation<dim>::Simulation(const Scene<dim> &scene, const MPI_Comm communicator, const bool quiet)
    : scene(scene)
    , quiet(quiet)
    // Alone, it neither waits for other processes nor comments on an exception.
    , timer(MPI_COMM_SELF, timer_table, TimerOutput::never, TimerOutput::wall_times)
    , discretization(scene, communicator)
  {
  }


  template <int dim>
  std::string Simulation<dim>::validate()
  {
    prepare();
    return scene.file_name + ": the scene is in order.\n" + description();
  }


  template <int dim>
  void Simulation<dim>::run()
  {
    prepare();
    RunLog log(scene.output_directory, quiet, discretization.communicator());
    remove_earlier_results(scene.output_directory, discretization.communicator());
    log.copy_scene(scene.original_text, scene.all_parameters);
    log.message(description());

    const auto       scheme = make_time_scheme(scene.time.scheme,
                                         {scene.time.hht_alpha,
                                                scene.time.spectral_radius,
                                                scene.time.newmark_beta,
                                                scene.time.newmark_gamma,
                                                scene.time.reference_tolerance,
                                                scene.time.impulses == "per node",
                                                scene.time.stop_sticking_nodes});
    FieldOutput<dim> fields(discretization, *surface, scene.output_directory);
    Observation<dim> observation(discretization, *surface, *loads, scene.output_directory);
    observation.start(state);
    system->set_energy(observation.energy_of_motion());
    if (writes_fields(0, false))
      fields.write(state);

    const auto stepping = make_time_stepping(scene.time, scene.step_sizes, *scheme, *system);
    while (!stepping->finished(state))
      {
        AcceptedStep step;
        {
          TimerOutput::Scope scope(timer, "step, all of it");
          step = stepping->advance(*system, state);
        }
        {
          TimerOutput::Scope scope(timer, "diagnostics and tables");
          observation.observe(state, step.report, step.step_size);
          system->set_energy(observation.energy_of_motion());
          log.progress(state.step,
                       scene.step_sizes.is_variable() ? 0 : scene.time.n_steps(),
                       stepping->fraction_done(state),
                       state.time,
                       observation.contact().normal_force,
                       observation.relative_energy_change(),
                       observation.contact().n_active);
        }
        if (writes_fields(state.step, stepping->finished(state)))
          {
            TimerOutput::Scope scope(timer, "field output");
            observation.pause_clock();
            fields.write(state);
            observation.resume_clock();
          }
      }

    timer.print_wall_time_statistics(discretization.communicator());
    log.message(stepping->summary() + observation.summary() + system->cost_summary() + timer_table.str());
    log.finish();
  }


  template <int dim>
  void Simulation<dim>::prepare()
  {
    {
      TimerOutput::Scope scope(timer, "assembly of mass and stiffness");
      discretization.assemble();
    }
    TimerOutput::Scope scope(timer, "contact surface and system");
    supports    = std::make_unique<Supports<dim>>(discretization);
    surface     = std::make_unique<ContactSurface<dim>>(discretization, *supports);
    mass_note   = redistribute_mass(discretization, *surface);
    coordinates = std::make_unique<ContactCoordinates<dim>>(discretization, *surface, *supports);
    loads       = std::make_unique<Loads<dim>>(discretization);
    system      = std::make_unique<ElasticContactSystem<dim>>(discretization, *surface, *coordinates, *loads, timer);
    set_initial_state();
  }


  template <int dim>
  void Simulation<dim>::set_initial_state()
  {
    std::vector<std::array<std::string, dim>> displacements, velocities;
    for (const auto &body : scene.bodies)
      {
        displacements.push_back(body.initial_displacement);
        velocities.push_back(body.initial_velocity);
      }
    state.displacement   = discretization.interpolate(displacements);
    state.velocity       = discretization.interpolate(velocities);
    state.contact_force  = discretization.make_vector();
    state.momentum       = discretization.make_vector();
    state.internal_force = discretization.make_vector();
    surface->check_initial_gap(state.displacement); // of the scene as it is given
    if (scene.time.start == "equilibrium")
      StaticEquilibrium<dim>(discretization, *surface, *coordinates)
        .find(state, loads->any() ? &loads->at(0.) : nullptr);
    system->apply_mass(state.momentum, state.velocity);
    system->apply_stiffness(state.internal_force, state.displacement);
  }


  template <int dim>
  bool Simulation<dim>::writes_fields(const unsigned int step, const bool is_last) const
  {
    if (!scene.output.vtu)
      return false;
    return step == 0 || is_last || (scene.output.vtu_every > 0 && step % scene.output.vtu_every == 0);
  }


  template <int dim>
  std::string Simulation<dim>::description() const
  {
    std::ostringstream text;
    text << "  scheme            " << scene.time.scheme << ", ";
    if (scene.step_sizes.is_variable())
      text << "steps by " << scene.step_sizes.control << ", the first of ";
    else
      text << scene.time.n_steps() << " steps of ";
    text << scene.time.step_size << "\n";
    if (!mass_note.empty())
      text << "  mass              " << mass_note << "\n";
    text << "  bodies            " << scene.bodies.size() << ", "
         << discretization.triangulation.n_global_active_cells() << " cells, " << discretization.dof_handler.n_dofs()
         << " degrees of freedom"
         << "\n  contact nodes     " << surface->n_global_nodes() << "\n  Courant number    "
         << discretization.courant_number(scene.time.step_size) << "\n  processes         "
         << Utilities::MPI::n_mpi_processes(discretization.communicator()) << "\n";
    if (!scene.pairs.empty() && surface->n_global_nodes() == 0)
      text << "  warning: Contact/Pairs names a pair, but no node can come into contact: none faces its obstacle, or "
              "supports hold them all\n";
    if (surface->n_supported() > 0)
      text
        << "  note: " << surface->n_supported()
        << " nodes of the contact surface are held in the normal direction by a support and take no part in contact\n";
    for (const std::string &note : surface->notes())
      text << "  note: " << note << "\n";
    return text.str();
  }


  template class Simulation<2>;
  template class Simulation<3>;
} // namespace signorini
