// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>
#include <signorini/base/spelling.h>
#include <signorini/output/run_log.h>
#include <signorini/output/whole_file.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <streambuf>
#include <unistd.h>

namespace signorini
{
  /** Passes every character on to both streams, or to one, or to none. */
  class RunLog::Tee : public std::streambuf
  {
  public:
    Tee(std::streambuf *first, std::streambuf *second)
      : first(first)
      , second(second)
    {
    }

    /** Whether all of the first stream could be written. A terminal that went away harms nobody. */
    bool complete() const { return all_written; }

  protected:
    int_type overflow(const int_type c) override
    {
      const char character = traits_type::to_char_type(c);
      if (!traits_type::eq_int_type(c, traits_type::eof()))
        xsputn(&character, 1);
      return traits_type::not_eof(c);
    }

    /**
     * A full disk must not silence the screen: failures are remembered instead of reported to the
     * stream.
     */
    std::streamsize xsputn(const char *text, const std::streamsize n) override
    {
      if (second)
        second->sputn(text, n);
      if (first)
        all_written = first->sputn(text, n) == n && all_written;
      return n;
    }

    int sync() override
    {
      if (second)
        second->pubsync();
      if (first)
        all_written = first->pubsync() == 0 && all_written;
      return 0;
    }

  private:
    std::streambuf *first, *second;
    bool            all_written = true;
  };


  namespace
  {
    std::string date()
    {
      const std::time_t seconds = std::time(nullptr);
      char              text[32];
      std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S", std::localtime(&seconds));
      return text;
    }

    /**
     * The mpirun of OpenMPI gives the first process a pseudo terminal for its output even if that
     * goes to a file, but a pipe for its errors; a line that is updated in place would litter the
     * file.
     */
    bool is_terminal()
    {
      return isatty(STDOUT_FILENO) == 1 && isatty(STDERR_FILENO) == 1;
    }

    /** "1 h 02 min", "3 min 20 s" or "12 s". */
    std::string duration(const double seconds)
    {
      const long n = std::lround(seconds);
      char       text[48];
      if (n >= 3600)
        std::snprintf(text, sizeof(text), "%ld h %02ld min", n / 3600, n % 3600 / 60);
      else if (n >= 60)
        std::snprintf(text, sizeof(text), "%ld min %02ld s", n / 60, n % 60);
      else
        std::snprintf(text, sizeof(text), "%ld s", n);
      return text;
    }
  } // namespace


  RunLog::RunLog(const std::string &directory,
                 const bool         quiet,
                 const MPI_Comm     communicator,
                 const bool         goes_on)
    : path(directory + "/log.txt")
    , communicator(communicator)
    , first_process(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    , on_terminal(first_process && !quiet && is_terminal())
    , to_screen(first_process && !quiet)
    , both(nullptr)
    , start(Clock::now())
  {
    succeed_together(communicator, [&] {
      if (!first_process)
        return;
      std::error_code error;
      std::filesystem::create_directories(directory, error);
      if (error)
        throw_write_error(directory, error.value());
      errno = 0;
      log.open(path, goes_on ? std::ios::app : std::ios::out);
      if (!log)
        throw_write_error(path, errno);
    });
    tee = std::make_unique<Tee>(first_process ? log.rdbuf() : nullptr,
                                to_screen ? std::cout.rdbuf() : nullptr);
    both.rdbuf(tee.get());

    const unsigned int n_processes = dealii::Utilities::MPI::n_mpi_processes(communicator);
    message(trim(version_and_commit()) + ", " + date() + ", " + std::to_string(n_processes)
            + (n_processes == 1 ? " process" : " processes"));
  }


  RunLog::~RunLog()
  {
    close_line();
    if (!finished && first_process)
      log << "The run ended early; the message is on the screen. What has been written is whole."
          << std::endl;
  }


  void RunLog::copy_scene(const std::string &original_text, const std::string &all_parameters) const
  {
    succeed_together(communicator, [&] {
      if (!first_process)
        return;
      const auto directory = std::filesystem::path(path).parent_path();
      write_whole_file((directory / "scene.prm").string(),
                       [&](std::ostream &out) { out << original_text; });
      write_whole_file((directory / "parameters.prm").string(),
                       [&](std::ostream &out) { out << all_parameters; });
    });
  }


  void RunLog::message(const std::string &text)
  {
    stream() << text << '\n' << std::flush;
  }


  void RunLog::record(const std::string &text)
  {
    if (first_process)
      log << text << '\n' << std::flush;
  }


  void RunLog::warning(const std::string &text)
  {
    if (!first_process)
      return;
    close_line();
    log << "  warning: " << text << '\n' << std::flush;
    std::cerr << "signorini: warning: " << text << std::endl;
  }


  std::ostream &RunLog::stream()
  {
    close_line();
    return both;
  }


  void RunLog::progress(const unsigned int step,
                        const unsigned int n_steps,
                        const double       fraction,
                        const double       time,
                        const double       contact_force,
                        const double       relative_energy_change,
                        const unsigned int n_active)
  {
    if (!first_process)
      return;
    const Clock::time_point now        = Clock::now();
    const bool              end        = fraction >= 1.;
    const int               tenths_now = static_cast<int>(10. * fraction + 1e-9);
    const bool              milestone  = end || step <= 1 || tenths_now != tenths;
    const bool              refresh =
      on_terminal && (milestone || now - last_update > std::chrono::milliseconds(100));
    if (!milestone && !refresh)
      return;

    char line[160];
    std::snprintf(
      line,
      sizeof(line),
      "step %u%s  time %-10.5g contact force %-10.4g energy %+.4f %%  active nodes %u  ",
      step,
      n_steps > 0 ? (" of " + std::to_string(n_steps)).c_str() : "",
      time,
      contact_force,
      100. * relative_energy_change,
      n_active);
    if (before == no_step)
      before = step - 1;
    const std::string text = line + pace(step - before) + time_left(fraction);
    tenths                 = tenths_now;
    if (milestone)
      log << text << '\n' << std::flush;
    if (refresh)
      {
        // The escape sequence clears what a longer line has left.
        std::cout << '\r' << text << "\033[K" << std::flush;
        line_is_open = true;
        last_update  = now;
        if (end)
          close_line();
      }
    else if (milestone && to_screen)
      std::cout << text << '\n' << std::flush;
  }


  std::string RunLog::pace(const unsigned int n_steps) const
  {
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    if (n_steps == 0 || !(elapsed > 0.))
      return "";
    const double rate     = n_steps / elapsed;
    char         text[32] = "";
    std::snprintf(text,
                  sizeof(text),
                  rate >= 1. ? "%.3g steps/s, " : "%.3g s per step, ",
                  rate >= 1. ? rate : 1. / rate);
    return text;
  }


  std::string RunLog::time_left(const double fraction) const
  {
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    if (fraction >= 1.)
      return duration(elapsed);
    return fraction > 0. ? duration(elapsed * (1. - fraction) / fraction) + " left" : "";
  }


  void RunLog::close_line()
  {
    if (line_is_open)
      std::cout << '\n' << std::flush;
    line_is_open = false;
  }


  void RunLog::end_early(const std::string &text)
  {
    close_line();
    finished = true;
    if (first_process)
      log << text << std::endl;
  }


  void RunLog::finish()
  {
    close_line();
    finished = true;
    succeed_together(communicator, [&] {
      errno = 0;
      both.flush();
      log.flush();
      if (first_process && !(tee->complete() && log))
        throw_write_error(path, errno);
    });
  }
} // namespace signorini
