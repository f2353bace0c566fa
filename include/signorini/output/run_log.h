// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_run_log_h
#define signorini_output_run_log_h

#include <deal.II/base/mpi.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <ostream>
#include <string>

namespace signorini
{
  /**
   * What a run tells its user: on the screen (unless quiet) and in `log.txt`, by the first process
   * only. On a terminal the progress is one line that is updated in place; elsewhere (under mpirun,
   * too) and in the log it is a line every tenth of the steps.
   */
  class RunLog
  {
  public:
    /**
     * Makes the output directory and begins a new log with program, date and number of processes.
     * Collective. @param goes_on append to the log that is there
     * @throws RunError on all processes
     */
    RunLog(const std::string &directory, bool quiet, MPI_Comm communicator, bool goes_on = false);
    RunLog(const RunLog &) = delete;
    ~RunLog();

    /**
     * Keep a copy of the scene: as it was given, and with all defaults. Collective. @throws
     * RunError on all processes.
     */
    void copy_scene(const std::string &original_text, const std::string &all_parameters) const;

    /** One or several lines of text, without the last end of line. */
    void message(const std::string &text);

    /** The same for the log only: what a reader of the screen has no use for. */
    void record(const std::string &text);

    /**
     * What makes results doubtful: a line in the log and on the error stream of the first process,
     * also of a quiet run.
     */
    void warning(const std::string &text);

    /**
     * State of the run after a step. The time left is estimated from the time since this log was
     * begun.
     * @param n_steps  of the whole run, 0 if that is not known
     * @param fraction of the run that is done, 1 at the end
     */
    void progress(unsigned int step,
                  unsigned int n_steps,
                  double       fraction,
                  double       time,
                  double       contact_force,
                  double       relative_energy_change,
                  unsigned int n_active);

    /** How the run ended before its end, for the log only: others tell the user. */
    void end_early(const std::string &text);

    /**
     * For everything else, such as tables of timers. Written to log and screen; swallows
     * everything on other processes.
     */
    std::ostream &stream();

    /** Collective. @throws RunError on all processes if something of the log could not be written.
     */
    void finish();

  private:
    using Clock = std::chrono::steady_clock;
    class Tee;

    std::string          path;
    MPI_Comm             communicator;
    bool                 first_process, on_terminal, to_screen;
    std::ofstream        log;
    std::unique_ptr<Tee> tee;
    std::ostream         both;
    bool                 finished  = false; ///< the log says how the run ended
    bool              line_is_open = false; ///< the cursor stands behind the progress on a terminal
    Clock::time_point start, last_update;
    int               tenths = -1; ///< of the run, at the last line of the log

    static constexpr unsigned int no_step = -1;
    unsigned int                  before  = no_step; ///< the step before the first one told

    void close_line();
    /** Steps per second, or seconds per step. */
    std::string pace(unsigned int n_steps) const;
    std::string time_left(double fraction) const;
  };
} // namespace signorini

#endif
