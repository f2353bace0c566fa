// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_simulation_small_run_h
#define signorini_tests_simulation_small_run_h

#include "../output/scratch.h"

#include <signorini/base/spelling.h>
#include <signorini/scene/read_scene.h>
#include <signorini/simulation/simulation.h>

#include <gtest/gtest.h>

#include <map>
#include <regex>

namespace signorini::tests
{
  /** Nobody reads a file before all processes have ended the run, by an exception or not. */
  struct LeaveTogether
  {
    ~LeaveTogether() { MPI_Barrier(MPI_COMM_WORLD); }
  };

  /**
   * A scene in a folder of its own: a square of four cells, of mass 2, that flies to the floor with
   * the velocity 2 and touches it at the time 0.0525, in the sixth of ten steps of 0.01.
   */
  class SmallRun
  {
  public:
    explicit SmallRun(std::vector<Override> overrides = {})
      : overrides(std::move(overrides))
    {
    }

    void change(const std::vector<Override> &more)
    {
      overrides.insert(overrides.end(), more.begin(), more.end());
    }

    void run()
    {
      const LeaveTogether together;
      Simulation<2>(scene(), MPI_COMM_WORLD, true).run();
    }

    /** With another scheme than that of the scene. */
    void run(std::unique_ptr<TimeScheme> scheme)
    {
      const LeaveTogether together;
      Simulation<2>(scene(), MPI_COMM_WORLD, true, std::move(scheme)).run();
    }

    std::string validate() { return Simulation<2>(scene(), MPI_COMM_WORLD, true).validate(false); }

    bool has(const std::string &file) const { return std::filesystem::exists(path(file)); }

    std::string text(const std::string &file) const { return contents(path(file)); }

    std::string path(const std::string &file) const { return folder.name + "/" + file; }

    /** A column of the history. */
    std::vector<double> column(const std::string &name) const
    {
      std::istringstream table(text("history.csv"));
      std::string        line;
      std::getline(table, line);
      const std::vector<std::string> names = split(line, ',');
      const auto          place = std::find(names.begin(), names.end(), name) - names.begin();
      std::vector<double> values;
      while (std::getline(table, line))
        values.push_back(std::stod(split(line, ',').at(place)));
      return values;
    }

    /** The times of the moments whose fields were written. */
    std::vector<double> times_of_fields() const
    {
      const std::string   series = text("volume.pvd");
      const std::regex    moment("timestep=\"([^\"]*)\"");
      std::vector<double> times;
      for (std::sregex_iterator i(series.begin(), series.end(), moment), end; i != end; ++i)
        times.push_back(std::stod((*i)[1]));
      return times;
    }

    const Scene<2> &scene()
    {
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::ofstream(path("mine.prm")) << R"(set Dimension = 2
subsection Time
  set Scheme    = contact-stabilized
  set Step size = 0.01
  set End time  = 0.1
end
subsection Bodies
  set Names = box
  subsection box
    set Shape            = box
    set Upper corner     = 1, 1
    set Repetitions      = 2, 2
    set Young's modulus  = 500
    set Density          = 2
    set Initial velocity = 0; -2
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape  = plane
    set Point  = 0, -0.105
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = box[2] : floor
end
)";
      MPI_Barrier(MPI_COMM_WORLD);
      std::vector<Override> all = overrides;
      all.emplace_back("Output directory", folder.name);
      current = read_scene<2>(path("mine.prm"), all);
      return current;
    }

  private:
    ScratchFolder         folder;
    std::vector<Override> overrides;
    Scene<2>              current;
  };
} // namespace signorini::tests

#endif
