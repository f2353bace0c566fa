// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_simulation_h
#define signorini_simulation_simulation_h

#include <signorini/base/interruption.h>
#include <signorini/checkpoint/checkpoint_folder.h>
#include <signorini/checkpoint/packed_state.h>
#include <signorini/fclib/problem_series.h>
#include <signorini/output/field_output.h>
#include <signorini/output/folder_lock.h>
#include <signorini/output/obstacle_series.h>
#include <signorini/output/run_log.h>
#include <signorini/simulation/damping_of_mesh.h>
#include <signorini/simulation/first_impacts.h>
#include <signorini/simulation/initial_state.h>
#include <signorini/simulation/mesh_control.h>
#include <signorini/simulation/observation.h>
#include <signorini/step_size/time_stepping.h>
#include <signorini/system/start_equilibrium.h>

#include <deal.II/base/timer.h>

#include <exception>
#include <sstream>

namespace signorini
{
  /**
   * A run of one scene. Owns the nouns and orders the verbs, nothing else. All functions are
   * collective.
   */
  template <int dim>
  class Simulation
  {
  public:
    /**
     * Builds the mesh. @param quiet no output on the screen. The scene must outlive the
     * simulation. @param scheme null: that of the scene; another one must keep to its properties,
     * and damps nothing by itself unless the scene gives a `Spectral radius`
     */
    Simulation(const Scene<dim>           &scene,
               MPI_Comm                    communicator,
               bool                        quiet,
               std::unique_ptr<TimeScheme> scheme = nullptr);

    /**
     * Build everything that a run needs, and look for penetration at the start.
     * @param for_programs as JSON, see Preflight
     * @return what would run, for the user
     * @throws UserError
     */
    std::string validate(bool for_programs);

    /** From time 0 to the end. @throws UserError before the first step, RunError later. */
    void run();

    /**
     * From the latest checkpoint to the end. @throws UserError if there is none, or if the scene is
     * another one; RunError later
     */
    void resume();

  private:
    const Scene<dim>   &scene;
    const bool          quiet;
    std::ostringstream  timer_table;
    dealii::TimerOutput timer;
    Mesh<dim>           mesh;
    State               state;

    DampingOfMesh                    *automatic_damping = nullptr; ///< the scheme, if it is one
    const std::unique_ptr<TimeScheme> scheme;
    StartReport                       equilibrium; ///< of a run that starts in it

    Remarks                  start_remarks; ///< about the initial state
    Remarks                  expected;      ///< of what is to come
    std::vector<FirstImpact> impacts;

    std::unique_ptr<MeshedScene<dim>> meshed;
    MeshControl<dim>                  mesh_control;
    MeshChange                        flags; ///< what the latest step wants of the mesh
    bool                              mesh_has_just_changed = true; ///< since the latest step
    int latest_interval = -1;                    ///< of time, in which fields were written
    std::unique_ptr<FieldOutput<dim>>    fields; ///< none if the scene wants none
    std::unique_ptr<ObstacleSeries<dim>> moving_obstacles; ///< none if there are none
    std::unique_ptr<ProblemSeries<dim>>  problems;         ///< none if the scene wants none
    const CheckpointFolder               checkpoints;
    dealii::Timer                        since_checkpoint;

    std::unique_ptr<TimeScheme> make_scheme();
    /** Let what is automatic be that of the present mesh. */
    void settle_damping();
    /** See StepRecord. */
    double stiffness_damping() const;
    /** See StepReport, as a part of the step. */
    double force_delay() const;

    /** Matrices, contact surface, system, initial state. */
    void prepare();
    void set_initial_state();
    /** Refine the mesh of the initial state as far as the indicator wants it. */
    void                          adapt_initial_mesh();
    std::unique_ptr<TimeStepping> make_stepping();
    /** Obstacles, and what fields are written to, if the scene wants them. */
    void begin_fields();
    /** All steps, and the summary; or the end of a run that fails. */
    void go_to_the_end(TimeStepping &, Observation<dim> &, RunLog &);

    /**
     * The next step; or, if it takes long after a signal, a checkpoint of its start.
     * @throws Interrupted
     */
    StepReport  advance_or_leave(TimeStepping &, Observation<dim> &, Interruption &);
    std::string how_to_go_on() const;
    /** A checkpoint if one is due, or if the run was told to end. @throws Interrupted */
    void keep_checkpoints(TimeStepping &, Observation<dim> &, Interruption &);
    /** Whether the scene wants one after this step, or at the end. */
    bool is_checkpoint(bool at_end);
    void write_checkpoint(PackedState &, TimeStepping &, Observation<dim> &);
    /**
     * Forget what is in no checkpoint, as a run that is resumed: mesh and state are the same,
     * all that is built on them is made anew.
     */
    void begin_anew(const PackedState &, TimeStepping &, Observation<dim> &);
    /** The state on what has just been built. */
    void go_on_with(const PackedState &, Observation<dim> &);
    /** What the run remembers besides mesh and state. */
    void archive(Archive &, TimeStepping &, Observation<dim> &);
    /** The scene must be that of a checkpoint. @throws UserError */
    void check_scene(const std::string &checkpoint) const;

    /** All steps to the end of the run. @throws Interrupted */
    void make_steps(TimeStepping &, Observation<dim> &, RunLog &);
    void tell_progress(double fraction, const Observation<dim> &, RunLog &) const;
    void write_fields(Observation<dim> &);
    /** The problem of the latest step, if the scene wants it. */
    void write_problem(Observation<dim> &);
    /** Of those that are being written in the background. @param wait until they are there */
    void complete_fields(Observation<dim> &, bool wait);
    /**
     * The next step. If the mesh turns out to be too coarse for it, the step may be repeated on a
     * refined one.
     */
    StepReport advance(TimeStepping &stepping, Observation<dim> &observation);
    StepReport advance_on_this_mesh(TimeStepping &stepping);
    /** Carry out the flags of the mesh. */
    void adapt_mesh(TimeStepping &stepping, Observation<dim> &observation);
    /** Their surfaces, if the scene wants fields of them: of those that move with the fields. */
    void write_obstacles();
    /** Whether it is time to. @param fraction of the run that is done */
    bool        writes_fields(double fraction);
    std::string description() const;
    /** What is assumed, or has been changed, before the first step, a sentence each. */
    std::vector<std::string> notes() const;
    /** What is doubtful before the first step, a sentence each. */
    std::vector<std::string> warnings() const;
    /** After the last step. */
    std::string summary(const TimeStepping &, const Observation<dim> &) const;
    /**
     * All processes fail together for a reason: write the last state, and say so in the log. What
     * cannot be written any more is left out.
     */
    void
    end_early(const std::exception_ptr &reason, const TimeStepping &, Observation<dim> &, RunLog &);
  };
} // namespace signorini

#endif
