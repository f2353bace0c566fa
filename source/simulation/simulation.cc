// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/failure.h>
#include <signorini/base/interruption.h>
#include <signorini/base/user_error.h>
#include <signorini/output/earlier_results.h>
#include <signorini/output/obstacle_surfaces.h>
#include <signorini/output/provenance.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/schemes/trapezoidal_rule.h>
#include <signorini/simulation/change_mesh.h>
#include <signorini/simulation/following_contact.h>
#include <signorini/simulation/initial_state.h>
#include <signorini/simulation/make_time_stepping.h>
#include <signorini/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::unique_ptr<TimeScheme> make_scheme_with(const Scene<dim>       &scene,
                                                 const SchemeParameters &parameters)
    {
      auto scheme = make_time_scheme(scene.time.scheme, parameters);
      if (scene.motion == ContactMotion::linearised)
        return scheme;
      return std::make_unique<FollowingContact>(std::move(scheme));
    }
  } // namespace


  template <int dim>
  Simulation<dim>::Simulation(const Scene<dim>           &scene,
                              const MPI_Comm              communicator,
                              const bool                  quiet,
                              std::unique_ptr<TimeScheme> given_scheme)
    : scene(scene)
    , quiet(quiet)
    // Alone, it neither waits for other processes nor comments on an exception.
    , timer(MPI_COMM_SELF, timer_table, TimerOutput::never, TimerOutput::wall_times)
    , mesh(scene.bodies, communicator, scene.mapping, scene.adaptivity.any())
    , scheme(given_scheme ? std::move(given_scheme) : make_scheme())
    , mesh_control(mesh,
                   this->scene,
                   {scheme_info(scene.time.scheme).balance,
                    scene.time.step_size,
                    scene.time.start == StartKind::equilibrium})
    , checkpoints(scene.output_directory, communicator)
  {
    if (scene.output.fclib_every > 0)
      problems = std::make_unique<ProblemSeries<dim>>(
        scene.output_directory, scene.output.fclib_every, communicator);
  }


  template <int dim>
  std::unique_ptr<TimeScheme> Simulation<dim>::make_scheme()
  {
    SchemeParameters parameters = scene.time.parameters;
    if (parameters.spectral_radius || !scheme_info(scene.time.scheme).damps_unresolved)
      return make_scheme_with(scene, parameters);
    auto result = std::make_unique<DampingOfMesh>([this, parameters](const double radius) mutable {
      parameters.spectral_radius = radius;
      return make_scheme_with(scene, parameters);
    });
    automatic_damping = result.get();
    return result;
  }


  template <int dim>
  void Simulation<dim>::settle_damping()
  {
    if (automatic_damping != nullptr)
      automatic_damping->use(automatic_spectral_radius(mesh.courant_number(scene.time.step_size)));
  }


  template <int dim>
  double Simulation<dim>::stiffness_damping() const
  {
    if (!scheme_info(scene.time.scheme).trapezoidal_rule)
      return 0.;
    return TrapezoidalRule(automatic_damping != nullptr
                             ? automatic_damping->spectral_radius()
                             : scene.time.parameters.spectral_radius.value_or(1.))
      .damping;
  }


  template <int dim>
  double Simulation<dim>::force_delay() const
  {
    return scheme_info(scene.time.scheme).force_delay + stiffness_damping();
  }


  template <int dim>
  void Simulation<dim>::run()
  {
    prepare();
    const FolderLock lock(scene.output_directory, mesh.communicator());
    RunLog           log(scene.output_directory, quiet, mesh.communicator());
    remove_earlier_results(scene.output_directory, mesh.communicator());
    checkpoints.remove();
    log.copy_scene(scene.original_text, scene.all_parameters);
    log.record(
      provenance(scene.file_name, scene.overrides, scene.input_files, mesh.communicator()));
    log.message(description());
    for (const std::string &warning : warnings())
      log.warning(warning);

    begin_fields();
    Observation<dim> observation(scene, *meshed);
    observation.start(state);
    meshed->system.see(observation.energies());
    const auto stepping = make_stepping();
    if (writes_fields(0.))
      write_fields(observation);
    go_to_the_end(*stepping, observation, log);
  }


  template <int dim>
  std::unique_ptr<TimeStepping> Simulation<dim>::make_stepping()
  {
    const double before_end =
      force_before_end(scheme_info(scene.time.scheme), scene.time.parameters);
    return make_time_stepping(scene,
                              *scheme,
                              [this] { return 1. / mesh.courant_number(1.); },
                              {before_end, [this] { return force_delay(); }});
  }


  template <int dim>
  void
  Simulation<dim>::go_to_the_end(TimeStepping &stepping, Observation<dim> &observation, RunLog &log)
  {
    const FailureReporter failures(mesh.communicator());
    try
      {
        make_steps(stepping, observation, log);
        complete_fields(observation, true);
      }
    catch (...)
      {
        const std::exception_ptr reason = std::current_exception();
        if (failures.all_fail())
          end_early(reason, stepping, observation, log);
        throw;
      }
    timer.print_wall_time_statistics(mesh.communicator());
    log.message(summary(stepping, observation) + timer_table.str());
    for (const std::string &warning : observation.warnings())
      log.warning(warning);
    log.finish();
  }


  template <int dim>
  void
  Simulation<dim>::make_steps(TimeStepping &stepping, Observation<dim> &observation, RunLog &log)
  {
    Interruption interruption;
    while (!stepping.finished(state))
      {
        const StepReport         report = advance_or_leave(stepping, observation, interruption);
        std::vector<std::string> news;
        {
          TimerOutput::Scope scope(timer, "diagnostics and tables");
          news = observation.observe(state, report, stepping.finished(state));
          for (const std::string &sentence : stepping.news())
            news.push_back(sentence);
          for (const std::string &warning : news)
            log.warning(warning);
          meshed->system.see(observation.energies());
          tell_progress(stepping.fraction_done(state), observation, log);
        }
        heed(observation.broken_laws(), scene.output.guard, log);
        if (scene.time.stop_on_warning && !news.empty())
          throw RunError("`Time/Stop on warning`: " + news.front());
        write_problem(observation);
        if (writes_fields(stepping.fraction_done(state)))
          write_fields(observation);
        else
          complete_fields(observation, false);
        const bool is_last = stepping.finished(state);
        if (flags.any() && (!is_last || scene.checkpoint.any()))
          adapt_mesh(stepping, observation);
        keep_checkpoints(stepping, observation, interruption);
        if (is_last)
          return;
      }
  }


  template <int dim>
  void Simulation<dim>::tell_progress(const double            fraction,
                                      const Observation<dim> &observation,
                                      RunLog                 &log) const
  {
    const unsigned int n_steps  = scene.time.n_steps();
    const bool         is_whole = !scene.step_sizes.is_variable()
                          && std::lround(fraction * n_steps) == static_cast<long>(state.step);
    log.progress(state.step,
                 is_whole ? n_steps : 0,
                 fraction,
                 state.time,
                 observation.contact().normal_force,
                 observation.relative_energy_change(),
                 observation.contact().n_active);
  }


  template <int dim>
  void Simulation<dim>::write_fields(Observation<dim> &observation)
  {
    complete_fields(observation, true);
    TimerOutput::Scope scope(timer, "field output");
    observation.pause_clock();
    fields->write(state, meshed->discretization, meshed->surface, mesh_control.indicators());
    if (moving_obstacles)
      moving_obstacles->write(state, meshed->discretization);
    observation.resume_clock();
  }


  template <int dim>
  void Simulation<dim>::write_problem(Observation<dim> &observation)
  {
    if (!problems)
      return;
    TimerOutput::Scope scope(timer, "problems for FCLIB");
    observation.pause_clock();
    problems->write();
    observation.resume_clock();
  }


  template <int dim>
  void Simulation<dim>::complete_fields(Observation<dim> &observation, const bool wait)
  {
    if (!fields || !fields->is_writing())
      return;
    TimerOutput::Scope scope(timer, "field output: completion");
    observation.pause_clock();
    wait ? fields->finish() : fields->finish_if_written();
    observation.resume_clock();
  }


  template <int dim>
  std::string Simulation<dim>::summary(const TimeStepping     &stepping,
                                       const Observation<dim> &observation) const
  {
    return stepping.summary() + observation.summary() + mesh_control.summary()
           + meshed->system.cost_summary();
  }


  template <int dim>
  void Simulation<dim>::end_early(const std::exception_ptr &reason,
                                  const TimeStepping       &stepping,
                                  Observation<dim>         &observation,
                                  RunLog                   &log)
  {
    const std::string message = attempt([&] { std::rethrow_exception(reason); }).message;
    // In the middle of a change of the mesh there is no state.
    const bool has_state =
      meshed && state.displacement.size() == meshed->discretization.dof_handler().n_dofs();
    attempt([&] { observation.finish(); });
    // The reason may be a full disk; then the next moment fails, too.
    attempt([&] { complete_fields(observation, true); });
    if (has_state && fields)
      attempt([&] {
        meshed->take_contact_back(state);
        write_fields(observation);
        complete_fields(observation, true);
      });
    if (has_state)
      log.message(summary(stepping, observation));
    log.end_early("The run ended early, at the time " + Patterns::Tools::to_string(state.time)
                  + ": " + message + "\nWhat has been written is whole.");
  }


  template <int dim>
  StepReport Simulation<dim>::advance(TimeStepping &stepping, Observation<dim> &observation)
  {
    flags = MeshChange();
    if (!mesh_control.may_be_due(state.step + 1))
      return advance_on_this_mesh(stepping);
    unsigned int rejected = 0;
    for (unsigned int repetition = 0;; ++repetition)
      {
        const State start  = state;
        StepReport  report = advance_on_this_mesh(stepping);
        report.rejected_steps += rejected;
        if (repetition == 0
            && !mesh_control.is_due(*meshed, state)) // a repeated step is judged again
          return report;
        {
          TimerOutput::Scope scope(timer, "mesh: indicator and marking");
          flags =
            mesh_control.judge(*meshed, {start, state, report.step_size, stiffness_damping()});
        }
        if (!mesh_control.repeats_step(flags, repetition))
          return report;
        rejected = report.rejected_steps + 1;
        state    = start;
        meshed->take_contact_back(state);
        stepping.take_back();
        adapt_mesh(stepping, observation);
      }
  }


  template <int dim>
  StepReport Simulation<dim>::advance_on_this_mesh(TimeStepping &stepping)
  {
    TimerOutput::Scope scope(
      timer, mesh_has_just_changed ? "first step on a mesh" : "later steps on a mesh");
    if (std::exchange(mesh_has_just_changed, false))
      settle_damping();
    if (problems)
      problems->expect(state.step + 1, meshed->discretization, meshed->coordinates, meshed->system);
    const Interruption::Step step;
    StepReport               report = stepping.advance(meshed->system, state);
    report.force_delay              = report.step_size * force_delay();
    return report;
  }


  template <int dim>
  void Simulation<dim>::adapt_mesh(TimeStepping &stepping, Observation<dim> &observation)
  {
    TimerOutput::Scope scope(timer, "mesh: all of a change");
    mesh_control.mesh_changes(state.step);
    change_mesh(mesh, scene, mesh_control.mesh_life_time(), meshed, state, timer);
    stepping.forget();
    observation.change_mesh(*meshed, state);
    mesh_has_just_changed = true;
  }


  template <int dim>
  void Simulation<dim>::begin_fields()
  {
    write_obstacles();
    if (scene.output.vtu)
      fields = std::make_unique<FieldOutput<dim>>(scene.output_directory, mesh.communicator());
  }


  template <int dim>
  void Simulation<dim>::write_obstacles()
  {
    if (!scene.output.vtu || !scene.output.obstacles || scene.obstacles.empty())
      return;
    signorini::write_obstacles(
      scene.output_directory, mesh.bounding_boxes(), scene.obstacles, mesh.communicator());
    if (std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [](const auto &obstacle) {
          return obstacle.motion != nullptr;
        }))
      moving_obstacles = std::make_unique<ObstacleSeries<dim>>(
        scene.output_directory, scene.obstacles, mesh.communicator());
  }


  template <int dim>
  bool Simulation<dim>::writes_fields(const double fraction)
  {
    if (!scene.output.vtu)
      return false;
    if (scene.output.vtu_every > 0)
      return fraction >= 1. || state.step % scene.output.vtu_every == 0;
    const int interval = static_cast<int>(scene.output.vtu_states * std::min(fraction, 1.) + 1e-9);
    return std::exchange(latest_interval, interval) != interval;
  }


  template class Simulation<2>;
  template class Simulation<3>;
} // namespace signorini
